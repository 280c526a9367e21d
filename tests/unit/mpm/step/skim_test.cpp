#include "mpm/step/skim.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "mpm/state/ledger.h"
#include "support/tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

// A tank 4 m long with water `depth` m deep and a sponge in its right half that keeps a level of 0.5 m.
template <int D>
Start<D> sponge_start(double depth) {
    Index<D> cells;
    cells.fill(10);
    cells[0] = 40;
    auto start = test::tank_start<D>(0.1, cells, depth, 30.0);
    start.parameters.boundaries.sponge = {.from = 2.0, .width = 2.0, .rate = 5.0, .level = 0.5};
    return start;
}

// A wave that runs into it.
template <int D>
Start<D> wave_start() {
    auto start = sponge_start<D>(0.5);
    for (const auto& point : start.bodies[0].points) {
        start.bodies[0].velocity.push_back(Vector<D, double>::Unit(0) *
                                           (0.8 * std::exp(-std::pow(point[0] - 1.0, 2))));
    }
    return start;
}

}  // namespace

TEST_CASE("a sponge's columns are as wide as the water is deep and fill it") {
    const auto s = make_simulation<3, float>(sponge_start<3>(0.5));
    const auto columns = skim_columns(s.grid.layout, s.parameters.boundaries.sponge);
    CHECK(columns.counts == std::array{4, 2});
    CHECK(columns.total() == 8);
    CHECK(columns.area() == doctest::Approx(0.25));
    CHECK(!columns.at({1.99, 0.1, 0.0}));
    CHECK(columns.at({2.0, 0.0, 0.0}) == 0);
    CHECK(columns.at({2.6, 0.6, 0.9}) == 3);
    CHECK(columns.at({4.01, 1.01, 0.2}) == 7);  // beyond the walls by less than a cell
    CHECK(columns.middle(3).isApprox(Vector<2, double>(2.75, 0.75)));
}

TEST_CASE_TEMPLATE("a sponge takes from the top what stands above its level, and books it", Real, float,
                   double) {
    const auto check = [&]<int D>(std::integral_constant<int, D>) {
        auto s = make_simulation<D, Real>(sponge_start<D>(0.6));
        const auto before = take_ledger(s);
        const auto columns = skim_columns(s.grid.layout, s.parameters.boundaries.sponge);
        const auto all = static_cast<double>(s.particle_count());
        s.time = 0.3;
        skim(s.parameters, s.time, s.grid, s.bodies, s.skimming, s.accounts.outflow);
        const double particle = s.bodies[0].volume, level = 0.5;
        const auto& parameters = s.parameters;
        const double spare =
            columns.area() * (weighed_depth(level + 0.1, parameters.gravity, parameters.water) -
                              weighed_depth(level, parameters.gravity, parameters.water));
        double expected = 0.0;
        REQUIRE(s.skimming.due.size() == static_cast<std::size_t>(columns.total()));
        for (int column = 0; column < columns.total(); ++column) {
            const double due = s.skimming.due[static_cast<std::size_t>(column)];
            const double sigma = s.parameters.boundaries.sponge.damping(columns.middle(column)[0]);
            const double asked = spare * (1.0 - std::exp(-0.3 * sigma));
            CHECK(due >= 0.0);
            CHECK(due < particle);
            expected += asked - due;
        }
        CHECK(particle * (all - static_cast<double>(s.particle_count())) == doctest::Approx(expected));
        const auto after = take_ledger(s);
        CHECK(s.accounts.outflow.mass == doctest::Approx(before.mass - after.mass));
        CHECK(s.accounts.outflow.momentum.isApprox(before.momentum - after.momentum));
        CHECK(after.gravitational + after.elastic + after.kinetic + s.accounts.outflow.energy() ==
              doctest::Approx(before.gravitational + before.elastic + before.kinetic));
        // The row of particles at the top is what went.
        CHECK(s.accounts.outflow.energy() > s.accounts.outflow.mass * 9.81 * 0.55);
        CHECK(s.bodies[0].begin.back() == s.bodies[0].size());
        const auto hash = state_hash(s);
        skim(s.parameters, s.time, s.grid, s.bodies, s.skimming, s.accounts.outflow);
        CHECK(state_hash(s) == hash);
    };
    check(std::integral_constant<int, 2>{});
    check(std::integral_constant<int, 3>{});
}

TEST_CASE("what was missing is held against what comes, up to half a cell of height") {
    auto s = make_simulation<2, double>(sponge_start<2>(0.4));
    s.time = 100.0;
    skim(s.parameters, s.time, s.grid, s.bodies, s.skimming, s.accounts.outflow);
    for (const double due : s.skimming.due) CHECK(due == doctest::Approx(-0.05 * 0.5));
    CHECK(s.accounts.outflow.mass == 0.0);
}

TEST_CASE("a sponge over a bed knows how much water is still there") {
    auto start = sponge_start<2>(0.5);
    auto& bed = start.parameters.boundaries.bed;
    bed.spacing = 0.1;
    bed.points = {41};
    for (int n = 0; n <= 40; ++n) bed.heights.push_back(std::max(0.0, 0.4 * (0.1 * n - 2.5)));
    auto s = make_simulation<2, double>(start);
    skim(s.parameters, s.time, s.grid, s.bodies, s.skimming, s.accounts.outflow);
    const std::vector<double> depths{0.5, 0.4, 0.2, 0.025};  // on average; the last ends at the shore
    REQUIRE(s.skimming.still.size() == depths.size());
    for (std::size_t column = 0; column < depths.size(); ++column)
        CHECK(s.skimming.still[column] == doctest::Approx(0.5 * depths[column]).epsilon(0.05));
}

TEST_CASE("still water loses nothing to a sponge, however long") {
    for (const double jitter : {0.0, 0.5}) {
        auto start = sponge_start<2>(0.5);
        start.bodies[0].points =
            test::lattice<2>(0.1, start.cells, 2, jitter, [](const auto& point) { return point[1] < 0.5; });
        // While the scheme density orders seeds that are off their rows, columns give 0.5 % once, in 40 s.
        if (jitter > 0.0) start.parameters.water.scheme = WaterScheme::paper;
        auto s = make_simulation<2, float>(start);
        while (s.time < 20.0) advance(s, stable_time_step(s));
        skim(s.parameters, s.time, s.grid, s.bodies, s.skimming,
             s.accounts.outflow);  // in rows nothing is ever sorted
        CHECK(s.skimming.time > 1.0);
        CHECK(s.accounts.outflow.mass < 1e-4 * take_ledger(s).mass);
    }
}

TEST_CASE("a sponge gives the same bits on any number of threads") {
    const auto check = [&]<int D>(std::integral_constant<int, D>) {
        std::uint64_t hash = 0;
        for (const int threads : {1, 2, 5}) {
            const ThreadLimit limit(threads);
            auto s = make_simulation<D, float>(wave_start<D>());
            while (s.time < (D == 2 ? 2.0 : 1.0)) advance(s, stable_time_step(s));
            CHECK(s.accounts.outflow.mass > 0.0);
            if (hash == 0) hash = state_hash(s);
            CHECK(state_hash(s) == hash);
        }
    };
    check(std::integral_constant<int, 2>{});
    check(std::integral_constant<int, 3>{});
}

TEST_CASE("water that a sponge takes leaves closed ledgers of mass, momentum and energy") {
    auto s = make_simulation<2, double>(wave_start<2>());
    const auto before = take_ledger(s);
    const auto energy = [&](const Ledger<2>& of) {
        return of.kinetic + of.gravitational + of.elastic - s.accounts.boundary_work +
               s.accounts.outflow.energy();
    };
    const double start = energy(before);
    while (s.time < 3.0) advance(s, stable_time_step(s));
    const auto after = take_ledger(s);
    CHECK(s.accounts.outflow.mass > 1e-3 * before.mass);
    CHECK(after.mass + s.accounts.outflow.mass == doctest::Approx(before.mass).epsilon(1e-12));
    Vector<2, double> open =
        after.momentum + s.accounts.outflow.momentum - before.momentum - s.accounts.wall_impulse;
    open[1] -= s.accounts.gravity_impulse;
    CHECK(open.norm() < 1e-9 * std::abs(s.accounts.gravity_impulse));
    CHECK(energy(after) < start + 1e-3 * before.kinetic);
}
