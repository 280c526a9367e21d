#include "cases.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace tidewater;
using namespace tidewater::benchmark;

namespace {

template <int D>
std::size_t count_of(const mpm::Start<D>& scene) {
    std::size_t count = 0;
    for (const auto& body : scene.bodies) count += body.points.size();
    return count;
}

template <int D>
void check_scene(std::string_view name, long particles) {
    CAPTURE(name);
    const mpm::Start<D> scene = make_scene<D>(name, particles);
    const std::size_t count = count_of(scene);
    CHECK(static_cast<double>(count) == doctest::Approx(static_cast<double>(particles)).epsilon(0.1));
    const double share = std::pow(scene.cell_size / 2, D);
    for (const auto& body : scene.bodies) {
        CHECK(!body.points.empty());
        CHECK(body.velocity.size() == body.points.size());
        CHECK(body.volume == doctest::Approx(share * static_cast<double>(body.points.size())));
        const double density = body.mass / body.volume;
        CHECK(density == doctest::Approx(body.material == Material::water ? 1000.0
                                         : body.material == Material::ice ? 900.0
                                                                          : 920.0));
        for (const auto& point : body.points) {
            REQUIRE(point.minCoeff() > 0.0);
            for (int axis = 0; axis < D; ++axis) {
                REQUIRE(point[axis] < scene.cell_size * scene.cells[static_cast<std::size_t>(axis)]);
            }
        }
    }
    double fastest = 0.0;
    for (const auto& body : scene.bodies) {
        for (const auto& velocity : body.velocity) fastest = std::max(fastest, velocity.norm());
    }
    CHECK(fastest > 5.0);
    CHECK(fastest < 25.0);
}

template <int D>
double mean_speed(const mpm::Start<D>& scene) {
    Vector<D, double> sum = Vector<D, double>::Zero();
    for (const auto& velocity : scene.bodies[0].velocity) sum += velocity;
    return sum.norm() / static_cast<double>(scene.bodies[0].velocity.size());
}

// The share of ice whose α is no longer that of the start.
template <int D>
double changed_share(const mpm::Simulation<D, float>& s) {
    const auto initial = static_cast<float>(s.parameters.ice.initial_alpha(D));
    const auto& alpha = s.bodies[0].alpha;
    const auto changed = std::ranges::count_if(alpha, [&](float a) { return a != initial; });
    return static_cast<double>(changed) / static_cast<double>(alpha.size());
}

template <int D>
void check_yields_in_part(std::string_view name, long particles) {
    auto s = mpm::make_simulation<D, float>(make_scene<D>(name, particles));
    REQUIRE(s.bodies[0].alpha.size() > 0);
    CHECK(changed_share<D>(s) == 0.0);
    for (const int steps : {25, 60}) {
        while (s.step < steps) advance(s, stable_time_step(s));
        const double share = changed_share<D>(s);
        MESSAGE(name << ": " << 100.0 * share << " % of " << s.particle_count()
                     << " particles have another α after " << steps << " steps");
        if (steps == 60) CHECK((share > 0.05 && share < 0.8));
    }
}

}  // namespace

TEST_CASE("every case has about the wanted number of particles, in the box, with their body's density") {
    for (const auto name : {"water2d", "ice2d"}) check_scene<2>(name, 60000);
    for (const auto name : {"water3d", "ice3d", "mixed3d"}) check_scene<3>(name, 100000);
}

TEST_CASE("the smallest scenes have all their bodies") {
    CHECK(count_of(make_scene<2>("water2d", 1)) > 64);
    CHECK(count_of(make_scene<2>("ice2d", 1)) > 64);
    const mpm::Start<3> mixed = make_scene<3>("mixed3d", 1);
    REQUIRE(mixed.bodies.size() == 2);
    REQUIRE(mixed.rigid.size() == 1);
    for (const auto& body : mixed.bodies) CHECK(!body.points.empty());
}

TEST_CASE("turning water has no momentum") {
    CHECK(mean_speed(make_scene<2>("water2d", 20000)) < 0.05);
    CHECK(mean_speed(make_scene<3>("water3d", 20000)) < 0.05);
}

TEST_CASE("water comes first, the iceberg floats level and no two bodies share space") {
    const mpm::Start<3> scene = make_scene<3>("mixed3d", 100000);
    const auto& bodies = scene.bodies;
    REQUIRE(bodies.size() == 2);
    REQUIRE(scene.rigid.size() == 1);
    CHECK(bodies[0].material == Material::water);
    CHECK(bodies[1].material == Material::ice);
    CHECK(bodies[0].surface == doctest::Approx(80.0));
    const mpm::RigidStart<3>& iceberg = scene.rigid[0];
    const Vector<3, double> low = iceberg.center - 0.5 * iceberg.size, high = low + iceberg.size;
    CHECK(iceberg.size.isConstant(40.0));
    CHECK(low[2] == doctest::Approx(80.0 - 0.92 * 40.0));
    for (const auto& point : bodies[0].points) {
        REQUIRE((point[0] >= 100.0 && point[2] < 80.0));
        REQUIRE(((point - low).minCoeff() < 0.0 || (high - point).minCoeff() < 0.0));
    }
    for (const auto& point : bodies[1].points) REQUIRE(point[0] < 100.0);
    CHECK(iceberg.velocity.isZero());
}

TEST_CASE("the same case is the same scene") {
    const mpm::Start<2> first = make_scene<2>("water2d", 5000), second = make_scene<2>("water2d", 5000);
    CHECK(first.bodies[0].points == second.bodies[0].points);
    CHECK(first.bodies[0].velocity == second.bodies[0].velocity);
}

TEST_CASE("ice2d and ice3d yield in part") {
    check_yields_in_part<2>("ice2d", 20000);
    check_yields_in_part<3>("ice3d", 20000);
}
