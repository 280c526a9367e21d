// The same bits whatever the number of threads, and wherever the scene lies.
#include <doctest/doctest.h>

#include <initializer_list>

#include <algorithm>
#include <utility>
#include <vector>

#include "mpm/state/ledger.h"
#include "support/mixed_tank.h"
#include "support/rough_ground.h"
#include "support/state.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

template <int D, class Real>
Simulation<D, Real> run(const Start<D>& start, int steps, int threads) {
    const ThreadLimit limit(threads);
    auto s = make_simulation<D, Real>(start);
    for (int n = 0; n < steps; ++n) advance(s, stable_time_step(s));
    return s;
}

// A mixed scene in free flight in the middle of a large box, moved by some blocks; its walls move along.
template <int D>
Start<D> moved_scene(const Index<D>& blocks) {
    const int cells = 8 * Block<D>::width;
    auto start = test::flying_start<D>(test::Scene::mixed, cells, D == 2 ? 42.0 : 13.0);
    for (std::size_t axis = 0; axis < D; ++axis) {
        const int shift = blocks[axis] * Block<D>::width;
        start.cells[axis] += shift;
        for (auto& body : start.bodies) {
            for (auto& point : body.points) point[static_cast<int>(axis)] += shift * start.cell_size;
        }
        for (auto& body : start.rigid) body.center[static_cast<int>(axis)] += shift * start.cell_size;
    }
    return start;
}

// Each particle's position in its block and that block, by id.
template <int D, class Real>
std::vector<std::pair<Vector<D, double>, Index<D>>> places(const Simulation<D, Real>& s) {
    std::vector<std::pair<Vector<D, double>, Index<D>>> by_id(s.particle_count());
    for (const auto& particles : s.bodies) {
        for_each_particle(s.grid, particles, [&](std::size_t, const Index<D>& block, std::size_t p) {
            by_id[particles.id[p]] = {local_position(particles, p), block};
        });
    }
    return by_id;
}

// The same bits, whatever the order of blocks, in b's blocks moved by `moved`.
template <int D, class Real>
void check_moved(const Simulation<D, Real>& a, const Simulation<D, Real>& b, const Index<D>& moved) {
    auto here = places(a);
    for (auto& [position, block] : here) {
        for (std::size_t axis = 0; axis < D; ++axis) block[axis] += moved[axis];
    }
    CHECK(here == places(b));
    const auto state_a = test::read_state(a), state_b = test::read_state(b);
    CHECK(state_a.v == state_b.v);
    CHECK(state_a.c == state_b.c);
    CHECK(state_a.b == state_b.b);
    CHECK(state_a.j == state_b.j);
    CHECK(state_a.alpha == state_b.alpha);
    CHECK(a.time == b.time);
    CHECK(a.rigid[0].center == b.rigid[0].center);
    CHECK(a.rigid[0].rotation.coeffs() == b.rigid[0].rotation.coeffs());
    CHECK(a.rigid[0].angular_momentum == b.rigid[0].angular_momentum);
}

// Sorting has moved particles of all bodies among blocks since the start.
template <int D, class Real>
void check_sorted(const Simulation<D, Real>& s, const Start<D>& start) {
    const auto initial = make_simulation<D, Real>(start);
    for (std::size_t body = 0; body < s.bodies.size(); ++body) {
        CAPTURE(body);
        CHECK(s.bodies[body].id != initial.bodies[body].id);
    }
}

template <int D, class Real>
void check_threads(const Start<D>& start, std::initializer_list<int> counts) {
    const auto serial = run<D, Real>(start, 300, 1);
    const auto serial_ledger = take_ledger(serial);
    REQUIRE(serial.bodies.size() == 2);
    REQUIRE(serial.rigid.size() == 1);
    check_sorted(serial, start);
    const auto& alpha = serial.bodies[1].alpha;
    const auto initial = static_cast<Real>(start.parameters.ice.initial_alpha(D));
    CHECK(std::any_of(alpha.begin(), alpha.end(), [&](Real a) { return a != initial; }));
    for (const int threads : counts) {
        CAPTURE(threads);
        const auto parallel = run<D, Real>(start, 300, threads);
        CHECK(state_hash(parallel) == state_hash(serial));
        CHECK(take_ledger(parallel).kinetic == serial_ledger.kinetic);
        CHECK(parallel.accounts.wall_impulse == serial.accounts.wall_impulse);
        CHECK(parallel.accounts.friction_work == serial.accounts.friction_work);
        CHECK(parallel.accounts.drag_work == serial.accounts.drag_work);
    }
}

}  // namespace

TEST_CASE_TEMPLATE("gives the same bits with 1, 2, 5 and 16 threads, for all kinds in one tank", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    check_threads<D, float>(test::mixed_tank<D>(), {2, 5, 16});
    check_threads<D, double>(test::mixed_tank<D>(), {2, 5, 16});
}

TEST_CASE_TEMPLATE("gives the same bits with 1, 2 and 5 threads on ground that rubs and drags", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    auto start = test::on_rough_ground(test::mixed_tank<D>());
    check_threads<D, float>(start, {2, 5});
    start.parameters.transfer = Transfer::restored;
    check_threads<D, double>(start, {2, 5});
}

TEST_CASE_TEMPLATE("a scene moved by whole blocks gives the same bits", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    // Blocks come in another order along the Morton curve; nothing may depend on it.
    constexpr int D = Dimension::value;
    for (const int blocks : {1, 3, 64}) {
        Index<D> moved{};
        moved[0] = blocks;
        moved[D - 1] = blocks / 2;
        check_moved(run<D, double>(moved_scene<D>({}), 200, 2), run<D, double>(moved_scene<D>(moved), 200, 2),
                    moved);
        check_moved(run<D, float>(moved_scene<D>({}), 200, 2), run<D, float>(moved_scene<D>(moved), 200, 2),
                    moved);
    }
}
