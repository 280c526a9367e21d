#include "io/water_surface.h"

#include <doctest/doctest.h>
#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>

#include "core/files.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

constexpr float dry = std::numeric_limits<float>::quiet_NaN();

vtkSmartPointer<vtkPolyData> written(const Surface& surface, const std::vector<float>& speed) {
    const TemporaryFolder folder;
    write_water_surface(folder / "a.vtp", surface, speed, test_provenance());
    CHECK(read_text(folder / "a.vtp").find("appended") == std::string::npos);
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName((folder / "a.vtp").c_str());
    reader->Update();
    return reader->GetOutput();
}

// η = 0.1 x on 4 × 3 places, the ground at 1 m, the still level at 5 m.
Surface slope() {
    Surface surface;
    surface.still_level = 5.0;
    surface.x = {0.0, 2.0, 4.0, 6.0};
    surface.y = {1.0, 3.0, 5.0};
    for (std::size_t place = 0; place < 12; ++place) {
        surface.elevation.push_back(0.1f * static_cast<float>(surface.x[place % 4]));
        surface.bed.push_back(1.0f);
    }
    return surface;
}

// Seen from above; negative where corners go around clockwise.
double area(vtkPolyData* data) {
    double sum = 0.0;
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell) {
        double p[3][3];
        for (int c = 0; c < 3; ++c) data->GetPoint(data->GetCell(cell)->GetPointId(c), p[c]);
        sum += 0.5 * ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]));
    }
    return sum;
}

}  // namespace

TEST_CASE("a water surface in 3D covers its places with triangles that look upward") {
    const auto data = written(slope(), std::vector<float>(12, 2.0f));
    CHECK(data->GetNumberOfPoints() == 12);
    CHECK(data->GetNumberOfPolys() == 12);
    CHECK(area(data) == doctest::Approx(6.0 * 4.0));
    CHECK(data->GetPoint(3)[0] == 6.0);
    CHECK(data->GetPoint(3)[1] == 1.0);
    CHECK(data->GetPoint(3)[2] == doctest::Approx(5.6));
    CHECK(data->GetPointData()->GetArray("elevation")->GetComponent(3, 0) == doctest::Approx(0.6));
    CHECK(data->GetPointData()->GetArray("depth")->GetComponent(3, 0) == doctest::Approx(4.6));
    CHECK(data->GetPointData()->GetArray("speed")->GetComponent(3, 0) == 2.0);
}

TEST_CASE("dry and covered places are holes") {
    Surface surface = slope();
    surface.elevation[0] = dry;  // a corner: half of a square is left
    const auto corner = written(surface, std::vector<float>(12, 0.0f));
    CHECK(corner->GetNumberOfPoints() == 11);
    CHECK(area(corner) == doctest::Approx(24.0 - 2.0));
    surface.elevation[5] = dry;  // inside: the half beside the corner too, and half of three other squares
    CHECK(area(written(surface, std::vector<float>(12, 0.0f))) == doctest::Approx(24.0 - 4.0 - 6.0));
    surface.elevation.assign(12, dry);
    CHECK(written(surface, std::vector<float>(12, dry))->GetNumberOfPoints() == 0);
}

TEST_CASE("in 2D the surface is a line, which a dry place cuts") {
    Surface surface = slope();
    surface.y = {0.0};
    surface.elevation.resize(4);
    surface.bed.resize(4);
    const std::vector<float> speed(4, 1.0f);
    const auto whole = written(surface, speed);
    CHECK(whole->GetNumberOfLines() == 1);
    CHECK(whole->GetCell(0)->GetNumberOfPoints() == 4);
    surface.elevation[2] = dry;
    const auto cut = written(surface, speed);
    CHECK(cut->GetNumberOfLines() == 1);  // the last place has no neighbour
    CHECK(cut->GetCell(0)->GetNumberOfPoints() == 2);
}

TEST_CASE("columns of another length are refused, and a folder that is not there gives an error") {
    const TemporaryFolder folder;
    const std::vector<float> speed(12, 0.0f);
    CHECK_THROWS_AS(write_water_surface(folder / "a.vtp", slope(), {}, test_provenance()),
                    std::invalid_argument);
    CHECK_THROWS_AS(write_water_surface(folder / "no/a.vtp", slope(), speed, test_provenance()), OutputError);
    CHECK(folder.file_count() == 0);
}
