#include "io/body_surfaces.h"

#include <doctest/doctest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

#include "core/files.h"
#include "core/random.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

// Particles of spacing 0.5 m on a lattice in [0, 30 m)^d where inside(x, y, z) holds, moved by up to half of
// `jitter` spacings.
struct Cloud {
    int dimension;
    double spacing = 0.5;
    std::vector<float> points, volume;

    Cloud(int d, double jitter, const std::function<bool(double, double, double)>& inside) : dimension(d) {
        const auto place = [&](int i) { return (i + 0.5) * spacing; };
        for (int k = 0; k < 60; ++k) {
            for (int j = 0; j < (d == 2 ? 1 : 60); ++j) {
                for (int i = 0; i < 60; ++i) {
                    if (inside(place(i), place(j), place(k))) add({place(i), place(j), place(k)}, jitter);
                }
            }
        }
    }
    void add(std::array<double, 3> at, double jitter) {
        for (std::uint64_t axis = 0; axis < 3; ++axis) {
            const double move = jitter * spacing * (random_uniform(1, axis, volume.size()) - 0.5);
            points.push_back(dimension == 2 && axis == 1 ? 0.0f : static_cast<float>(at[axis] + move));
        }
        volume.push_back(static_cast<float>(std::pow(spacing, dimension)));
    }
    double total() const { return std::accumulate(volume.begin(), volume.end(), 0.0); }
    BodyParticles particles() const { return {dimension, spacing, points, volume}; }
    // All of it.
    Body body(std::int32_t iceberg) const {
        Body all{iceberg, 1, std::vector<std::uint32_t>(volume.size())};
        std::iota(all.particles.begin(), all.particles.end(), 0u);
        return all;
    }
};

vtkSmartPointer<vtkPolyData> written(const Cloud& cloud, const std::vector<Body>& bodies) {
    const TemporaryFolder folder;
    write_body_surfaces(folder / "a.vtp", cloud.particles(), bodies, test_provenance());
    CHECK(read_text(folder / "a.vtp").find("appended") == std::string::npos);
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName((folder / "a.vtp").c_str());
    reader->Update();
    return reader->GetOutput();
}

Eigen::Vector3d corner(vtkPolyData* data, vtkIdType cell, int c) {
    Eigen::Vector3d at;
    data->GetPoint(data->GetCell(cell)->GetPointId(c), at.data());
    return at;
}

// What is enclosed by each iceberg's triangles, by the divergence theorem; in 2D their area.
std::map<int, double> enclosed(vtkPolyData* data, int dimension) {
    std::map<int, double> volume;
    vtkDataArray* iceberg = data->GetCellData()->GetArray("iceberg");
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell) {
        REQUIRE(data->GetCell(cell)->GetNumberOfPoints() == 3);
        const Eigen::Vector3d a = corner(data, cell, 0), b = corner(data, cell, 1), c = corner(data, cell, 2);
        volume[static_cast<int>(iceberg->GetComponent(cell, 0))] +=
            dimension == 2 ? 0.5 * (b - a).cross(c - a).norm() : a.dot(b.cross(c)) / 6.0;
    }
    return volume;
}

// Of the particles' volume.
double lost_share(const Cloud& cloud) {
    const auto data = written(cloud, {cloud.body(3)});
    return 1.0 - enclosed(data, cloud.dimension).at(3) / cloud.total();
}

std::function<bool(double, double, double)> box(double edge) {
    return [edge](double x, double y, double z) { return std::max({x, y, z}) < edge; };
}
std::function<bool(double, double, double)> ball(double radius, double y0) {
    return [=](double x, double y, double z) { return std::hypot(x - 12.0, y - y0, z - 12.0) < radius; };
}

}  // namespace

TEST_CASE("a surface encloses the volume of its particles") {
    for (const double jitter : {0.0, 0.5}) {
        for (const int n : {3, 8, 24}) {
            CAPTURE(jitter);
            CAPTURE(n);
            const double size = 0.5 * n;
            CHECK(std::abs(lost_share({3, jitter, box(size)})) < 1.1e-3);
            CHECK(std::abs(lost_share({3, jitter, ball(0.5 * size, 12.0)})) < 1.1e-3);
            CHECK(std::abs(lost_share({2, jitter, box(size)})) < 1.1e-3);
            CHECK(std::abs(lost_share({2, jitter, ball(0.5 * size, 0.25)})) < 1.1e-3);
        }
    }
}

TEST_CASE("a box's faces lie where its particles' share of space ends, to 0.3 of their spacing") {
    for (const int n : {8, 24}) {
        const Cloud cloud(3, 0.0, box(0.5 * n));
        const auto data = written(cloud, {cloud.body(1)});
        for (int side = 0; side < 6; ++side) {
            CHECK(std::abs(data->GetBounds()[side] - (side % 2 == 0 ? 0.0 : 0.5 * n)) < 0.3 * 0.5);
        }
    }
    const Cloud disc(2, 0.0, ball(5.0, 0.25));
    const auto data = written(disc, {disc.body(1)});
    CHECK(data->GetBounds()[2] == 0.0);
    CHECK(data->GetBounds()[3] == 0.0);
    CHECK(data->GetBounds()[4] == doctest::Approx(7.0).epsilon(0.02));
    CHECK(data->GetBounds()[1] == doctest::Approx(17.0).epsilon(0.01));
}

TEST_CASE("bodies that touch have a surface each, with their number, material and volume") {
    for (const int d : {2, 3}) {
        const Cloud cloud(d, 0.0, box(6.0));
        Body left{7, 1, {}}, right{-1, 2, {}};
        for (std::uint32_t p = 0; p < cloud.volume.size(); ++p)
            (cloud.points[3 * p] < 4.0f ? left : right).particles.push_back(p);
        const auto data = written(cloud, {left, right, {9, 1, {}}});
        const auto volume = enclosed(data, d);
        CHECK(volume.size() == 2);
        CHECK(volume.at(7) == doctest::Approx(cloud.total() * 2 / 3).epsilon(1.1e-3));
        CHECK(volume.at(-1) == doctest::Approx(cloud.total() / 3).epsilon(1.1e-3));
        vtkCellData* cells = data->GetCellData();
        CHECK(cells->GetArray("material")->GetComponent(0, 0) == 1.0);
        CHECK(cells->GetArray("volume")->GetComponent(0, 0) == doctest::Approx(cloud.total() * 2 / 3));
        const vtkIdType last = data->GetNumberOfCells() - 1;
        CHECK(cells->GetArray("material")->GetComponent(last, 0) == 2.0);
    }
}

TEST_CASE("a hole within a body stays open, also in 2D") {
    for (const int d : {2, 3}) {
        const Cloud ring(d, 0.0, [](double x, double y, double z) {
            const double from = std::max(std::abs(x - 6.0), std::abs(z - 6.0));
            return from < 6.0 && from > 2.0 && y < 6.0;
        });
        CHECK(std::abs(lost_share(ring)) < 1.1e-3);
    }
}

TEST_CASE("no bodies make an empty file, one particle a drop of its volume") {
    Cloud drop(3, 0.0, [](double, double, double) { return false; });
    CHECK(written(drop, {})->GetNumberOfPoints() == 0);
    CHECK(written(drop, {drop.body(1)})->GetNumberOfPoints() == 0);
    drop.add({-3.1, 4.2, -0.3}, 0.0);
    CHECK(std::abs(lost_share(drop)) < 1.1e-3);
}

TEST_CASE("a folder that is not there gives an error, and no file of surfaces") {
    const TemporaryFolder folder;
    const Cloud cloud(2, 0.0, box(2.0));
    CHECK_THROWS_AS(write_body_surfaces(folder / "no/a.vtp", cloud.particles(), {}, test_provenance()),
                    OutputError);
    CHECK(folder.file_count() == 0);
}
