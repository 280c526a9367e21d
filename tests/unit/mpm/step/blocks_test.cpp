// The seams of the step: stages work on the blocks that they are given, and nodes take tiles as they find
// them.
#include "mpm/step/blocks.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <span>
#include <vector>

#include "mpm/step/nodes.h"
#include "mpm/step/pass.h"
#include "support/mixed_tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

template <int D>
Simulation<D, float> moving_tank() {
    auto s = make_simulation<D, float>(test::mixed_tank<D>());
    for (int n = 0; n < 20; ++n) advance(s, stable_time_step(s));
    return s;
}

template <int D>
Findings pass(const Slots& slots, Simulation<D, float>& s) {
    return pass_over_blocks(s.interval(s.dt), s.parameters, slots, s.rigid, s.unknown_fill, s.grid, s.bodies,
                            s.drift, s.accounts.wall_impulse)
        .all;
}

template <int D>
bool same_tiles(const Simulation<D, float>& a, const Simulation<D, float>& b) {
    const auto bytes = [](const auto& s) { return std::as_bytes(std::span(s.grid.tiles)); };
    return std::ranges::equal(bytes(a), bytes(b));
}

}  // namespace

TEST_CASE("all slots count up, listed ones are those of the list") {
    const Slots all = Slots::all(3);
    CHECK(all.size() == 3);
    CHECK(all[2] == 2);
    const std::vector<std::uint32_t> list{1, 4};
    const Slots some = Slots::listed(list);
    CHECK(some.size() == 2);
    CHECK(some[1] == 4);
    CHECK(Slots::listed({}).size() == 0);
}

TEST_CASE_TEMPLATE("a pass over every other block and then over the rest has the bits of one over all",
                   Dimension, std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    auto whole = moving_tank<D>(), parts = whole;
    const std::size_t count = whole.grid.particle_blocks.size();
    REQUIRE(count > 2);
    pass(Slots::all(count), whole);
    std::vector<std::uint32_t> odd, even;
    for (std::uint32_t slot = 0; slot < count; ++slot) (slot % 2 == 0 ? even : odd).push_back(slot);
    pass(Slots::listed(odd), parts);
    CHECK(state_hash(parts) != state_hash(whole));  // the rest has not moved
    pass(Slots::listed(even), parts);
    CHECK(state_hash(parts) == state_hash(whole));
    CHECK(same_tiles(parts, whole));
}

TEST_CASE("nodes have the same bits, whoever filled the tiles") {
    auto here = moving_tank<2>(), there = here;
    const std::size_t count = here.grid.particle_blocks.size();
    pass(Slots::all(count), here);
    pass(Slots::all(count), there);
    std::ranges::fill(here.grid.tiles, Node<float>::Zero());
    here.grid.tiles = there.grid.tiles;  // as they would come from other machines
    for (std::size_t slot = 0; slot < here.grid.node_blocks.size(); ++slot) {
        sum_momenta(-1.0f, slot, here.grid);
        sum_momenta(-1.0f, slot, there.grid);
    }
    CHECK(state_hash(here) == state_hash(there));
}
