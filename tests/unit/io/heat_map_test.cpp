#include "io/heat_map.h"

#include <doctest/doctest.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <cmath>
#include <string>

#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

// η(x, t) = cos(k (x - c t)), 40 × 30 cells.
HeatMap travelling_wave() {
    HeatMap map{.title = "a < b", .x_label = "x (m)", .y_label = "time (s)", .value_label = "η (m)"};
    map.right = 16.0;
    map.top = 5.0;
    map.columns = 40;
    map.rows = 30;
    for (std::size_t j = 0; j < map.rows; ++j) {
        for (std::size_t i = 0; i < map.columns; ++i) {
            const double x = (static_cast<double>(i) + 0.5) * 16.0 / 40.0;
            const double t = (static_cast<double>(j) + 0.5) * 5.0 / 30.0;
            map.values.push_back(0.7 * std::cos(1.5 * (x - 3.0 * t)));
        }
    }
    return map;
}

bool well_formed(const std::string& svg) {
    const auto root =
        vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(svg.c_str()));
    return root && std::string(root->GetName()) == "svg";
}

bool holds(const std::string& svg, const std::string& part) { return svg.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a heat map is well-formed XML with axes, a colour bar and its provenance") {
    const std::string svg = draw_heat_map(travelling_wave(), test_provenance());
    CHECK(well_formed(svg));
    for (const char* text : {">a &lt; b<", ">x (m)<", ">time (s)<", ">η (m)<", "tidewater-test a.toml"})
        CHECK(holds(svg, text));
    CHECK(holds(svg, ">0.8<"));  // the greatest value, 0.7, rounded up
    CHECK(holds(svg, ">-0.8<"));
    CHECK(!holds(svg, "no value"));
}

TEST_CASE("cells without a value are named in the legend, lines over the cells too") {
    HeatMap map = travelling_wave();
    map.values[5] = std::nan("");
    map.lines = {{.label = "√(gD) t", .x = {0.0, 30.0}, .y = {0.0, 10.0}, .dashed = true}};
    const std::string svg = draw_heat_map(map, test_provenance());
    CHECK(well_formed(svg));
    CHECK(holds(svg, ">no value<"));
    CHECK(holds(svg, ">√(gD) t<"));
    CHECK(!holds(svg, "nan"));
}

TEST_CASE("the scale begins at zero where all values are of one sign, and its end can be set") {
    HeatMap map = travelling_wave();
    map.scale = HeatScale::sequential;
    map.greatest = 3.0;
    const std::string svg = draw_heat_map(map, test_provenance());
    CHECK(holds(svg, ">3.0<"));
    CHECK(!holds(svg, ">-0.5<"));
}

TEST_CASE("more cells than pixels are averaged, so that the file stays small") {
    HeatMap map = travelling_wave();
    map.columns = 5000;
    map.rows = 3000;
    map.values.assign(map.columns * map.rows, 0.1);
    CHECK(draw_heat_map(map, test_provenance()).size() < 200'000);
}

TEST_CASE("heat maps without cells, with one, and of nothing but gaps are well-formed too") {
    HeatMap map{.title = {}, .x_label = {}, .y_label = {}, .value_label = {}};
    CHECK(well_formed(draw_heat_map(map, test_provenance())));
    map.columns = map.rows = 1;
    map.values = {0.0};
    CHECK(well_formed(draw_heat_map(map, test_provenance())));
    map.values = {std::nan("")};
    const std::string svg = draw_heat_map(map, test_provenance());
    CHECK(well_formed(svg));
    CHECK(!holds(svg, "nan"));
}
