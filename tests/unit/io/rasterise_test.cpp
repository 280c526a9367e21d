#include "io/rasterise.h"

#include <doctest/doctest.h>

#include <string>

#include "core/error.h"
#include "core/files.h"
#include "io/chart.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

const std::string flag =
    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"20\" height=\"10\">"
    "<rect width=\"20\" height=\"10\" fill=\"#ff0000\"/><rect width=\"10\" height=\"10\" "
    "fill=\"#0000ff\"/></svg>";

}  // namespace

TEST_CASE("pixels have the colours of the shapes at their places, at any scale") {
    for (const double scale : {1.0, 2.0, 3.5}) {
        const Canvas canvas = rasterise(flag, scale);
        CHECK(canvas.width() == static_cast<int>(20 * scale));
        CHECK(canvas.height() == static_cast<int>(10 * scale));
        CHECK(canvas.at(0, 0) == Color{0, 0, 255});
        CHECK(canvas.at(static_cast<int>(9 * scale), 1) == Color{0, 0, 255});
        CHECK(canvas.at(canvas.width() - 1, canvas.height() - 1) == Color{255, 0, 0});
    }
}

TEST_CASE("what is no SVG, or has no size, is told") {
    CHECK_THROWS_AS(rasterise(""), OutputError);
    CHECK_THROWS_AS(rasterise("<svg"), OutputError);
    CHECK_THROWS_AS(rasterise("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100%\" height=\"9\"/>"),
                    OutputError);
    CHECK_THROWS_AS(rasterise(flag, 1e5), OutputError);
}

TEST_CASE("a chart is written as SVG and, twice as fine, as PNG, byte by byte the same each time") {
    const TemporaryFolder folder;
    Chart chart{.title = "Überfall δ, √(gD)", .x_label = "time (s)", .panels = {ChartPanel{}}};
    chart.panels[0].lines = {{.label = "η", .x = {0, 1, 2}, .y = {0, 1, 0}}};
    const std::string svg = draw_chart(chart, test_provenance());
    for (const char* name : {"a.svg", "b.svg"})
        write_svg_and_png(folder / name, svg, chart_scale, test_provenance());
    CHECK(read_text(folder / "a.svg") == svg);
    CHECK(read_text(folder / "a.png") == read_text(folder / "b.png"));
    CHECK(read_text(folder / "a.png").find("tidewater-test a.toml") != std::string::npos);
    CHECK(folder.file_count() == 4);
    CHECK(rasterise(svg, chart_scale).width() == 1920);
    CHECK_THROWS_AS(write_svg_and_png(folder / "no/a.svg", svg, 1.0, test_provenance()), OutputError);
}
