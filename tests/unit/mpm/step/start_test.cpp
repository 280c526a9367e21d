#include "mpm/step/start.h"
#include "mpm/step/step.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include "support/flight.h"
#include "support/state.h"
#include "support/tank.h"

using namespace tidewater;
using namespace tidewater::mpm;
using test::Scene;

namespace {

template <int D>
Simulation<D, float> simulation_of(Scene scene) {
    return make_simulation<D, float>(test::flying_start<D>(scene, D == 2 ? 40 : 16, 4.0));
}

template <int D>
bool has_strain(const Particles<D, float>& particles) {
    for (const auto& column : particles.strain) {
        if (column.size() == particles.size()) continue;
        CHECK(column.empty());
        return false;
    }
    return true;
}

}  // namespace

TEST_CASE_TEMPLATE("particles have the columns of their material and no others", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    for (const Scene scene : {Scene::elastic_ice, Scene::mixed}) {
        auto s = simulation_of<D>(scene);
        for (int n = 0; n < 30; ++n) advance(s, stable_time_step(s));
        for (const auto& particles : s.bodies) {
            CAPTURE(material_name(particles.material));
            const bool ice = particles.material == Material::ice, fracture = s.parameters.ice.fracture;
            CHECK(has_strain(particles) == ice);
            CHECK(particles.alpha.size() == (ice && fracture ? particles.size() : 0));
            CHECK(particles.j.size() == (particles.material == Material::water ? particles.size() : 0));
            for (const auto& column : particles.position) CHECK(column.size() == particles.size());
        }
    }
}

TEST_CASE("a scene without ice has no ice columns") {
    const auto s = simulation_of<3>(Scene::water);
    for (const auto& particles : s.bodies) {
        CHECK_FALSE(has_strain(particles));
        CHECK(particles.alpha.empty());
    }
}

TEST_CASE_TEMPLATE("a start has the momenta that were asked for and affine motion at its points", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    for (const Scene scene : {Scene::water, Scene::elastic_ice}) {
        const auto start = test::flying_start<D>(scene, D == 2 ? 40 : 16, 4.0);
        const auto s = make_simulation<D, double>(start);
        CHECK(s.time == 0.0);
        CHECK(s.dt == 0.0);
        const auto state = test::read_state(s);
        const auto& body = start.bodies[0];
        test::State<D> asked = state;
        asked.v = body.velocity, asked.c = body.gradient;
        const auto is = test::momenta_of(state, start.cell_size),
                   shall = test::momenta_of(asked, start.cell_size);
        CHECK((is.linear - shall.linear).norm() < 1e-13 * shall.linear.norm());
        CHECK((is.angular - shall.angular).norm() < 1e-13 * shall.linear.norm());
        for (std::size_t p = 0; p < state.x.size(); ++p) {
            CHECK((state.v[p] - body.velocity[p]).norm() < 1e-13);
            CHECK((state.c[p] - body.gradient[p]).norm() < 1e-12);
        }
    }
}

TEST_CASE(
    "water starts with the pressure of the depth below its surface, or of the head that each point is "
    "given") {
    auto start = test::tank_start<2>(0.1, {10, 10}, 0.5, 62.0);
    auto& water = start.bodies[0];
    const auto plain = make_simulation<2, double>(start);
    for (const auto& point : water.points) water.head.push_back(0.5 - point[1]);
    CHECK(state_hash(make_simulation<2, double>(start)) == state_hash(plain));
    for (double& head : water.head) head *= 2.0;
    start.parameters.water.scheme = WaterScheme::paper;
    const auto pressed = make_simulation<2, double>(start);
    const auto& model = start.parameters.water;
    for (std::size_t p = 0; p < pressed.bodies[0].size(); ++p) {
        const double head = water.head[pressed.bodies[0].id[p]];
        CHECK(pressed.bodies[0].j[p] == hydrostatic_j(head, start.parameters.gravity, model));
    }
}

TEST_CASE("water of the scheme density starts compressed: level, weight and volumes agree") {
    const double depth = 4.0, c = 10.0 * std::sqrt(9.81 * depth);
    const auto start = test::tank_start<2>(0.1, {10, 50}, depth, c);
    const auto s = make_simulation<2, double>(start);
    const auto& water = s.bodies[0];
    const double weighed = weighed_depth(depth, 9.81, start.parameters.water);
    CHECK(weighed / depth == doctest::Approx(1.005).epsilon(2e-4));  // 1 + g D/2c²
    CHECK(water.mass == doctest::Approx(1000.0 * 0.05 * 0.05 * weighed / depth).epsilon(1e-12));
    CHECK(water.volume == doctest::Approx(water.mass / 1000.0).epsilon(1e-12));
    double lowest = depth, highest = 0.0;
    for_each_particle(s.grid, water, [&](std::size_t, const Index<2>& block, std::size_t p) {
        const double z = global_position(s.grid.layout, block, water, p)[1];
        lowest = std::min(lowest, z);
        highest = std::max(highest, z);
        const double above = weighed_depth(depth - z, 9.81, start.parameters.water);  // m of water
        CHECK(water_pressure(water.j[p], start.parameters.water) ==
              doctest::Approx(9810.0 * above).epsilon(1e-9));
    });
    CHECK(lowest == doctest::Approx(0.025).epsilon(0.01));
    CHECK(highest == doctest::Approx(depth - 0.025).epsilon(1e-4));
}

TEST_CASE_TEMPLATE("ice starts with the share of its strength that was asked for", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    auto start = test::flying_start<D>(Scene::fracturing_ice, D == 2 ? 40 : 16, 4.0);
    auto& body = start.bodies[0];
    body.strength.assign(body.points.size(), 1.0f);
    body.strength[0] = 0.0f, body.strength[1] = 0.25f, body.strength[2] = 0.75f;
    const auto s = make_simulation<D, double>(start);
    const IceModel& ice = s.parameters.ice;
    const auto& particles = s.bodies[0];
    const double kappa = ice.bulk_modulus(D);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double share = body.strength[particles.id[p]];
        const double strength = ice.beta * kappa * std::sinh(-ice.hardening * particles.alpha[p]);
        CHECK(strength == doctest::Approx(share * ice.beta_p0).epsilon(1e-9));
        CHECK((particles.failure_time[p] == 0.0) == (share == 0.0));
    }
}
