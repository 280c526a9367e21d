// Indices of nodes, blocks and columns along several axes, and their places in flat arrays. The last axis is
// always contiguous in memory.
//
//     place = Σ_axis at[axis] · stride(axis),   stride(axis) = product of the widths of all later axes
//
// Test: tests/unit/mpm/base/index_test.cpp.
#pragma once

#include <array>
#include <cstddef>

namespace tidewater::mpm {

constexpr int power(int base, int exponent) { return exponent == 0 ? 1 : base * power(base, exponent - 1); }

template <int D>
using Index = std::array<int, static_cast<std::size_t>(D)>;  // D cannot be deduced from an Index argument

// The index along `axis` of a place in an array of width^D.
template <int D>
constexpr int index_along(int place, int width, int axis) {
    return place / power(width, D - 1 - axis) % width;
}

// The place of an index in an array of width^D.
template <int D>
constexpr int place_of(const Index<D>& at, int width) {
    int place = 0;
    for (int axis = 0; axis < D; ++axis) place = place * width + at[static_cast<std::size_t>(axis)];
    return place;
}

// The index of a place in an array of widths[0] × … × widths[D − 1].
template <int D>
constexpr Index<D> index_of(int place, const Index<D>& widths) {
    Index<D> at{};
    for (std::size_t axis = D; axis-- > 0; place /= widths[axis]) at[axis] = place % widths[axis];
    return at;
}

// The index of a place in an array of width^D.
template <int D>
constexpr Index<D> index_of(int place, int width) {
    Index<D> at{};
    for (std::size_t axis = D; axis-- > 0; place /= width) at[axis] = place % width;
    return at;
}

// The offset (−1, 0 or 1) along an axis of neighbour k in a neighbourhood of 3^D, whose middle is the block
// or node itself.
template <int D>
constexpr int neighbour_offset(int k, int axis) {
    return index_along<D>(k, 3, axis) - 1;
}

}  // namespace tidewater::mpm
