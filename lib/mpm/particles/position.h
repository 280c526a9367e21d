// The storage of positions: in cells, relative to the first node of the particle's block.
//
// `float` runs store a 32-bit fixed-point number in units of 2⁻²⁶ cells. Its resolution is 1.5e-8 of a cell
// everywhere, where a `float` would round by up to 5e-7 at the far side of a block. Motion of less than a
// unit per step is not lost either, because each step rounds down after adding a shift d_n, which is the same
// for all particles and fills [0, 1) evenly:
//
//     X ← X + ⌊2²⁶ Δt v/Δx + d_n⌋,   d_n = fraction of n (√5 − 1)/2
//
// Over many steps the rounding errors then sum to a few units at most. `double` runs store a double.
// Test: tests/unit/mpm/particles/position_test.cpp.
#pragma once

#include <cmath>
#include <cstdint>

#include "mpm/base/batch.h"

namespace tidewater::mpm {

template <class Real>
struct StoredPosition;
template <>
struct StoredPosition<float> {
    using Type = std::int32_t;
};
template <>
struct StoredPosition<double> {
    using Type = double;
};
template <class Real>
using Stored = typename StoredPosition<Real>::Type;

inline constexpr int fraction_bits = 26;  // whoever changes it raises the format_version of checkpoints
inline constexpr double units_per_cell = 1 << fraction_bits;

inline double cells_of(std::int32_t position) { return position / units_per_cell; }
inline double cells_of(double position) { return position; }

// The nearest position that can be stored, for |cells| < 31.
template <class Real>
inline Stored<Real> stored(double cells) {
    if constexpr (sizeof(Real) == 4)
        return static_cast<std::int32_t>(std::lround(cells * units_per_cell));
    else
        return cells;
}

// d_n of step n ≥ 0.
inline double rounding_shift(long step) {
    const double turns = static_cast<double>(step) * 0.6180339887498949;
    return turns - std::floor(turns);
}

// X += Δt v/Δx for a whole batch; `shift` is the step's d_n.
template <class Real>
inline void advance_positions(const Column<Real>& velocity, Real cells_per_speed, Real shift,
                              Column<Stored<Real>>& position) {
    for (int p = 0; p < batch_size; ++p) {
        if constexpr (sizeof(Real) == 4) {
            const Real units = velocity[p] * (cells_per_speed * static_cast<Real>(units_per_cell));
            position[p] += static_cast<std::int32_t>(std::floor(units + shift));
        } else {
            position[p] += velocity[p] * cells_per_speed;
        }
    }
}

// The node of the block (0 … width) that is nearest to a position ≥ −½.
inline std::int32_t nearest_node(std::int32_t position) {
    return (position + (1 << (fraction_bits - 1))) >> fraction_bits;
}
inline std::int32_t nearest_node(double position) { return static_cast<std::int32_t>(position + 1.5) - 1; }

// The distance of a position from its nearest node, in [−½, ½) cells.
inline float from_node(std::int32_t position, std::int32_t node) {
    return static_cast<float>(position - (node << fraction_bits)) * static_cast<float>(1 / units_per_cell);
}
inline double from_node(double position, std::int32_t node) { return position - node; }

}  // namespace tidewater::mpm
