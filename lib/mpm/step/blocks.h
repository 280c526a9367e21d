// The blocks on which a stage of the step works: all of them, or those that a list names.
//
// This is where a step may leave blocks out. A scene that steps its blocks at several rates would give each
// stage the slots that are due; every stage loops over the slots that it gets and makes no choice of its own.
//
// Test: tests/unit/mpm/step/blocks_test.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/parallel.h"

namespace tidewater::mpm {

class Slots {
public:
    static Slots all(std::size_t count) { return Slots(count, {}); }
    // The slots in `list`, which must be ascending and outlive this.
    static Slots listed(std::span<const std::uint32_t> list) { return Slots(list.size(), list); }

    std::size_t size() const { return size_; }
    std::size_t operator[](std::size_t n) const { return list_.empty() ? n : list_[n]; }

private:
    Slots(std::size_t size, std::span<const std::uint32_t> list) : size_(size), list_(list) {}
    std::size_t size_;
    std::span<const std::uint32_t> list_;
};

// Calls work(slot) for each of the slots, in parallel.
template <class Work>
void for_each_slot(const Slots& slots, const Work& work) {
    parallel_for(slots.size(), [&](std::size_t n) { work(slots[n]); });
}

// The blocks of one step.
struct StepBlocks {
    Slots particles;  // in grid.particle_blocks
    Slots nodes;      // in grid.node_blocks
};

template <class Grid>
StepBlocks all_blocks(const Grid& grid) {
    return {Slots::all(grid.particle_blocks.size()), Slots::all(grid.node_blocks.size())};
}

}  // namespace tidewater::mpm
