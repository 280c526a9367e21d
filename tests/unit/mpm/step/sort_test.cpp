#include "mpm/step/sort.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "mpm/step/step.h"
#include "support/ice_body.h"
#include "support/mixed_tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

// How far the particles lie outside of their blocks along an axis, at most, cells.
template <int D, class Real>
double farthest_out(const Simulation<D, Real>& s) {
    double out = 0.0;
    for (const auto& particles : s.bodies) {
        for (std::size_t p = 0; p < particles.size(); ++p) {
            const Vector<D, double> cells = local_position(particles, p);
            out = std::max({out, -cells.minCoeff(), cells.maxCoeff() - Block<D>::width});
        }
    }
    return out;
}

// A drop of water that flies at 30 m/s, and 20 blocks away ice that stands.
Start<2> drop_and_ice() {
    Start<2> start;
    start.cell_size = 1.0;
    start.cells = {400, 64};
    start.parameters.gravity = 0.0;
    start.parameters.water.sound_speed = 50.0;
    start.parameters.ice.fracture = false;
    auto& drop = start.bodies.emplace_back();
    drop.points = test::lattice<2>(1.0, start.cells, 2, 0.0, test::ball_shape<2>({40.0, 30.0}, 2.0));
    drop.volume = 0.25 * static_cast<double>(drop.points.size());
    drop.mass = 1000.0 * drop.volume;
    drop.head.assign(drop.points.size(), 0.0);
    drop.velocity.assign(drop.points.size(), Vector<2, double>(30.0, 0.0));
    test::add_ice<2>(test::box_shape<2>({360.0, 20.0}, {380.0, 40.0}), start);
    return start;
}

}  // namespace

TEST_CASE_TEMPLATE("between sorts no particle leaves the margin of its block", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    auto s = make_simulation<D, float>(test::mixed_tank<D>());
    int sorts = 0;
    for (int n = 0; n < 400; ++n) {
        const std::vector<double> before = s.drift;
        advance(s, stable_time_step(s));
        const bool sorted =
            s.drift.size() != before.size() || std::ranges::max(s.drift) < std::ranges::max(before);
        sorts += sorted;
        REQUIRE(farthest_out(s) < 0.5);
        REQUIRE(std::ranges::max(s.drift) <= sorting_margin);
    }
    CHECK(sorts > 0);
    CHECK(sorts < 200);
}

TEST_CASE("a drift is the way of the block's own fastest particle, and a sort begins when one would leave") {
    auto s = make_simulation<2, double>(drop_and_ice());
    const std::size_t flying = 0;
    double way = 0.0;
    while (way + 30.0 * stable_time_step(s) <= sorting_margin) {
        const double dt = stable_time_step(s);
        way += 30.0 * s.dt;
        advance(s, dt);
        CHECK(s.drift[flying] == doctest::Approx(way).epsilon(1e-9));
        CHECK(s.drift.back() < 1e-9);  // the ice
    }
    for (int n = 0; n < 2; ++n) advance(s, stable_time_step(s));
    CHECK(s.drift[flying] < 0.1);
}

TEST_CASE("what is fast and what is stiff elsewhere do not shorten the step together") {
    auto s = make_simulation<2, double>(drop_and_ice());
    advance(s, 1e-6);
    const double ice = s.parameters.ice.wave_speed(2);
    CHECK(s.speeds.particle == doctest::Approx(30.0));
    CHECK(s.speeds.signal.sound == doctest::Approx(ice));
    CHECK(s.speeds.signal.material == Material::ice);
    CHECK(s.speeds.signal.motion < 1e-6);
    CHECK(stable_time_step(s) == doctest::Approx(0.5 / ice).epsilon(1e-9));
    // Where the drop alone is, its own sound and motion count.
    auto start = drop_and_ice();
    start.bodies.pop_back();
    auto drop = make_simulation<2, double>(start);
    advance(drop, 1e-6);
    CHECK(drop.speeds.signal.material == Material::water);
    CHECK(stable_time_step(drop) == doctest::Approx(std::min(0.5 / 80.0, 0.4 / 30.0)).epsilon(1e-9));
}
