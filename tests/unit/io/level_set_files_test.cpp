#include "io/level_set_files.h"

#include <doctest/doctest.h>
#include <openvdb/tools/LevelSetSphere.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/files.h"
#include "core/parallel.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

openvdb::FloatGrid::Ptr sphere(const char* name, double radius, const openvdb::Vec3f& center, double voxel) {
    openvdb::initialize();
    auto grid = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(static_cast<float>(radius), center,
                                                                         static_cast<float>(voxel));
    grid->setName(name);
    return grid;
}

std::vector<NumberedLevelSet> two_spheres() {
    return {{sphere("water", 2.0, {1.0f, 0.0f, 3.0f}, 0.1), 2},
            {sphere("ice", 1.0, {8.0f, 1.0f, 3.0f}, 0.1), 3}};
}

template <class Reader>
vtkNew<Reader> read(const std::filesystem::path& path) {
    vtkNew<Reader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader;
}

std::string field(vtkDataObject* data, const char* name) {
    auto* array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
    return array == nullptr ? "" : static_cast<std::string>(array->GetValue(0));
}

// By the divergence theorem, of the polygons of one body: positive if they go around as they should.
double enclosed_volume(vtkPolyData* data, int body) {
    double volume = 0.0;
    auto* bodies = data->GetPointData()->GetArray("body");
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell) {
        vtkNew<vtkIdList> ids;
        data->GetCellPoints(cell, ids);
        if (bodies->GetTuple1(ids->GetId(0)) != body) continue;
        using Vector3 = Vector<3, double>;
        std::vector<Vector3> at;
        for (vtkIdType n = 0; n < ids->GetNumberOfIds(); ++n)
            at.push_back(Eigen::Map<const Vector3>(data->GetPoint(ids->GetId(n))));
        for (std::size_t n = 2; n < at.size(); ++n) volume += at[0].dot(at[n - 1].cross(at[n])) / 6.0;
    }
    return volume;
}

}  // namespace

TEST_CASE("surfaces lie where the level sets are zero and face outward") {
    const TemporaryFolder folder;
    write_surfaces(folder / "surfaces.vtp", two_spheres(), test_provenance());
    const auto reader = read<vtkXMLPolyDataReader>(folder / "surfaces.vtp");
    vtkPolyData* data = reader->GetOutput();
    REQUIRE(data->GetNumberOfPoints() > 1000);
    auto* body = data->GetPointData()->GetArray("body");
    double worst = 0.0;
    for (vtkIdType n = 0; n < data->GetNumberOfPoints(); ++n) {
        const double* p = data->GetPoint(n);
        const bool water = body->GetTuple1(n) == 2;
        const double distance = water ? std::hypot(p[0] - 1.0, p[1], p[2] - 3.0) - 2.0
                                      : std::hypot(p[0] - 8.0, p[1] - 1.0, p[2] - 3.0) - 1.0;
        worst = std::max(worst, std::abs(distance));
    }
    CHECK(worst < 0.02);
    CHECK(enclosed_volume(data, 2) == doctest::Approx(32.0 / 3.0 * std::numbers::pi).epsilon(0.01));
    CHECK(enclosed_volume(data, 3) == doctest::Approx(4.0 / 3.0 * std::numbers::pi).epsilon(0.02));
    CHECK(field(data, "bodies") == "2 water, 3 ice");
    CHECK(field(data, "format") == "tidewater-surfaces");
    CHECK(field(data, "scene_hash") == "00ff");
}

TEST_CASE("an image tells each voxel's material and distances") {
    const TemporaryFolder folder;
    const ImageExtent extent{3, {-1.5, -2.0, 0.0}, {9.0, 2.0, 5.5}};
    write_image(folder / "image.vti", two_spheres(), extent, true, test_provenance());
    const auto reader = read<vtkXMLImageDataReader>(folder / "image.vti");
    vtkImageData* data = reader->GetOutput();
    CHECK(data->GetDimensions()[0] == 106);
    CHECK(data->GetDimensions()[1] == 41);
    CHECK(data->GetDimensions()[2] == 56);
    CHECK(data->GetOrigin()[0] == doctest::Approx(-1.5));
    CHECK(data->GetSpacing()[2] == doctest::Approx(0.1));
    auto* material = data->GetPointData()->GetArray("material");
    auto* water = data->GetPointData()->GetArray("water");
    REQUIRE(material != nullptr);
    REQUIRE(water != nullptr);
    int wrong = 0;
    double worst = 0.0;
    for (vtkIdType n = 0; n < data->GetNumberOfPoints(); ++n) {
        double p[3];
        data->GetPoint(n, p);
        const double to_water = std::hypot(p[0] - 1.0, p[1], p[2] - 3.0) - 2.0;
        const double to_ice = std::hypot(p[0] - 8.0, p[1] - 1.0, p[2] - 3.0) - 1.0;
        if (std::abs(to_water) < 1e-4 || std::abs(to_ice) < 1e-4) continue;
        wrong += material->GetTuple1(n) != (to_ice < 0.0 ? 3 : to_water < 0.0 ? 2 : 0);
        worst = std::max(worst, std::abs(water->GetTuple1(n) - std::clamp(to_water, -0.3, 0.3)));
    }
    CHECK(wrong == 0);
    CHECK(worst < 1e-4);
    CHECK(field(data, "format") == "tidewater-image");
    CHECK(field(data, "bodies") == "2 water, 3 ice");
}

TEST_CASE("in 2D an image is one slice, without distances one byte a voxel") {
    const TemporaryFolder folder;
    write_image(folder / "image.vti", two_spheres(), {2, {-1.0, -7.0, 1.0}, {3.0, 7.0, 5.0}}, false,
                test_provenance());
    const auto reader = read<vtkXMLImageDataReader>(folder / "image.vti");
    vtkImageData* data = reader->GetOutput();
    CHECK(data->GetDimensions()[0] == 41);
    CHECK(data->GetDimensions()[1] == 1);
    CHECK(data->GetDimensions()[2] == 41);
    CHECK(data->GetOrigin()[1] == 0.0);
    CHECK(data->GetPointData()->GetNumberOfArrays() == 1);
    CHECK(data->GetScalarComponentAsDouble(20, 0, 20, 0) == 2.0);
    CHECK(data->GetScalarComponentAsDouble(0, 0, 0, 0) == 0.0);
}

TEST_CASE("both files are inline binary and the same bytes again, on any number of threads") {
    const TemporaryFolder folder;
    const ImageExtent extent{3, {-1.5, -2.0, 0.0}, {9.0, 2.0, 5.5}};
    const auto write = [&](int threads) {
        const ThreadLimit limit(threads);
        write_surfaces(folder / "surfaces.vtp", two_spheres(), test_provenance());
        write_image(folder / "image.vti", two_spheres(), extent, true, test_provenance());
        return std::array{read_text(folder / "surfaces.vtp"), read_text(folder / "image.vti")};
    };
    const auto first = write(1);
    CHECK(first == write(3));
    for (const auto& text : first) {
        CHECK(text.find("format=\"binary\"") != std::string::npos);
        CHECK(text.find("appended") == std::string::npos);
    }
    CHECK(folder.file_count() == 2);
    CHECK_THROWS_AS(write_surfaces("/nowhere/a.vtp", two_spheres(), test_provenance()), OutputError);
}

TEST_CASE("a level set without a surface gives a file without polygons") {
    const TemporaryFolder folder;
    openvdb::initialize();
    auto empty = openvdb::FloatGrid::create(0.3f);
    empty->setTransform(openvdb::math::Transform::createLinearTransform(0.1));
    empty->setGridClass(openvdb::GRID_LEVEL_SET);
    empty->setName("ice");
    write_surfaces(folder / "empty.vtp", {{empty, 3}}, test_provenance());
    CHECK(read<vtkXMLPolyDataReader>(folder / "empty.vtp")->GetOutput()->GetNumberOfCells() == 0);
}
