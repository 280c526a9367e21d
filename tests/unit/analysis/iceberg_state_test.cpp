#include "analysis/iceberg_state.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>
#include <vector>

using namespace tidewater::analysis;

TEST_CASE("a turned and spinning box gives its edges, motion and spin back") {
    for (const int dimension : {2, 3}) {
        const Eigen::Vector3d center(1000.0, dimension == 3 ? 300.0 : 0.0, 50.0), drift(1.5, 0.0, -0.5);
        const Eigen::Vector3d spin =
            dimension == 3 ? Eigen::Vector3d(0.1, -0.2, 0.3) : Eigen::Vector3d(0.0, 0.2, 0.0);
        const Eigen::Vector3d axis =
            dimension == 3 ? Eigen::Vector3d(1.0, 2.0, 3.0).normalized() : Eigen::Vector3d(0.0, 1.0, 0.0);
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.6, axis).toRotationMatrix();
        std::vector<float> points, velocity, volume;
        const int across = dimension == 3 ? 20 : 1;
        for (int i = 0; i < 40; ++i) {
            for (int j = 0; j < across; ++j) {
                for (int k = 0; k < 10; ++k) {
                    const Eigen::Vector3d at(i - 19.5, j - 0.5 * (across - 1), k - 4.5);
                    const Eigen::Vector3d r = turn * at, v = drift + spin.cross(r);
                    for (int d = 0; d < 3; ++d) {
                        points.push_back(static_cast<float>(center[d] + r[d]));
                        velocity.push_back(static_cast<float>(v[d]));
                    }
                    volume.push_back(1.0f);
                }
            }
        }
        std::vector<std::uint32_t> members(volume.size());
        std::iota(members.begin(), members.end(), 0u);
        const IcebergState s =
            describe_iceberg({points, velocity, volume}, members,
                             {.dimension = dimension, .spacing = 1.0, .still_level = 52.0});
        CHECK(s.volume == static_cast<double>(volume.size()));
        CHECK(s.length == doctest::Approx(40.0).epsilon(1e-4));
        CHECK(s.height == doctest::Approx(10.0).epsilon(1e-4));
        CHECK(s.width == doctest::Approx(dimension == 3 ? 20.0 : 0.0).epsilon(1e-4));
        CHECK(std::abs(s.axes.col(0).dot(turn.col(0))) == doctest::Approx(1.0).epsilon(1e-6));
        if (dimension == 2) CHECK(s.tilt() == doctest::Approx(0.6 * 180.0 / M_PI).epsilon(1e-4));
        CHECK((s.centroid - center).norm() < 1e-4);
        CHECK((s.velocity - drift).norm() < 1e-5);
        CHECK((s.rotation - spin).norm() < 1e-5);
        const double half = 0.5 * ((s.draft + s.freeboard) - 1.0);
        CHECK(s.draft == doctest::Approx(half + 2.5).epsilon(1e-4));
    }
}

TEST_CASE("a single particle is a box of a spacing at rest in itself") {
    const std::vector<float> point{3.0f, 0.0f, 1.0f}, velocity{2.0f, 0.0f, 0.0f}, volume{0.25f};
    const IcebergState s = describe_iceberg({point, velocity, volume}, std::vector<std::uint32_t>{0},
                                            {.dimension = 2, .spacing = 0.5, .still_level = 1.0});
    CHECK(s.length == 0.5);
    CHECK(s.height == 0.5);
    CHECK(s.width == 0.0);
    CHECK(s.rotation.norm() == 0.0);
    CHECK(s.draft == 0.25);
    CHECK(s.freeboard == 0.25);
    CHECK(s.submerged == 0.5);
    CHECK(s.area == 0.5);
    CHECK(std::isnan(s.clearance));
}

TEST_CASE("a box's draft, plan and height above ground that rises are those of its particles' outlines") {
    for (const int dimension : {2, 3}) {
        std::vector<float> points, volume;
        for (int i = 0; i < 30; ++i) {
            for (int j = 0; j < (dimension == 3 ? 8 : 1); ++j) {
                for (int k = 0; k < 10; ++k) {
                    for (const double x :
                         {100.0 + 2 * i + 1.0, dimension == 3 ? 2 * j + 1.0 : 0.0, 12.0 + 2 * k + 1.0})
                        points.push_back(static_cast<float>(x));
                    volume.push_back(dimension == 3 ? 8.0f : 4.0f);
                }
            }
        }
        const std::vector<float> velocity(points.size(), 0.0f);
        std::vector<std::uint32_t> members(volume.size());
        std::iota(members.begin(), members.end(), 0u);
        const IcebergState s = describe_iceberg(
            {points, velocity, volume}, members,
            {.dimension = dimension, .spacing = 2.0, .still_level = 27.0, .ground = [](double x, double) {
                 return 0.05 * x;
             }});
        CHECK(s.draft == doctest::Approx(15.0));
        CHECK(s.freeboard == doctest::Approx(5.0));
        CHECK(s.submerged == doctest::Approx(0.75));
        CHECK(s.area == doctest::Approx(dimension == 3 ? 60.0 * 16.0 : 60.0));
        CHECK(s.clearance == doctest::Approx(12.0 - 0.05 * 159.0));
        CHECK(s.tilt() == doctest::Approx(0.0));
        CHECK(s.velocity.norm() == 0.0);
    }
}
