#include "io/canvas.h"

#include <doctest/doctest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include "core/files.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

TEST_CASE("the PNG reads back pixel by pixel, and repeats byte by byte") {
    const TemporaryFolder folder;
    Canvas canvas(30, 20, Color{10, 20, 30});
    canvas.blend(2, 1, Color{200, 100, 50});
    canvas.write_png(folder / "a.png", test_provenance());
    canvas.write_png(folder / "b.png", test_provenance());
    CHECK(read_text(folder / "a.png") == read_text(folder / "b.png"));
    CHECK(read_text(folder / "a.png").find("tidewater-test a.toml") != std::string::npos);
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName((folder / "a.png").c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    CHECK(image->GetDimensions()[0] == 30);
    CHECK(image->GetDimensions()[1] == 20);
    CHECK(image->GetNumberOfScalarComponents() == 3);
    CHECK(image->GetScalarComponentAsDouble(2, 18, 0, 0) == 200.0);
    CHECK(image->GetScalarComponentAsDouble(20, 2, 0, 2) == 30.0);
    CHECK_THROWS_AS(canvas.write_png(folder / "no/a.png", test_provenance()), OutputError);
}

TEST_CASE("colours lie over each other by their opacity, and over nothing as themselves") {
    Canvas opaque(2, 1, Color{100, 100, 100});
    opaque.blend(0, 0, Color{200, 0, 100}, 0.5);
    CHECK(opaque.at(0, 0) == Color{150, 50, 100});
    CHECK(opaque.at(1, 0) == Color{100, 100, 100});
    Canvas clear(2, 1, palette::paper, 0.0);
    clear.blend(0, 0, Color{200, 0, 100}, 0.5);
    CHECK(clear.at(0, 0) == Color{200, 0, 100});
    clear.blend(0, 0, Color{0, 200, 100}, 1.0);
    CHECK(clear.at(0, 0) == Color{0, 200, 100});
    clear.blend(5, 0, Color{1, 1, 1});
    clear.blend(0, -1, Color{1, 1, 1});
}

TEST_CASE("a PNG has opacities only where not all is opaque") {
    const TemporaryFolder folder;
    Canvas canvas(2, 1, palette::paper, 0.0);
    canvas.blend(1, 0, palette::ink);
    canvas.write_png(folder / "a.png", test_provenance());
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName((folder / "a.png").c_str());
    reader->Update();
    REQUIRE(reader->GetOutput()->GetNumberOfScalarComponents() == 4);
    CHECK(reader->GetOutput()->GetScalarComponentAsDouble(0, 0, 0, 3) == 0.0);
    CHECK(reader->GetOutput()->GetScalarComponentAsDouble(1, 0, 0, 3) == 255.0);
}
