// What a sponge takes of the volume that waves bring.
//
// Damping alone stops a wave, but its water stays and flows back. So the sponge treats the surface as it
// treats the velocity (mpm/boundaries/sponge.h), ∂η/∂t + … = −σ η, which long waves enter without an echo.
// Columns about as wide as the water is deep hold the water V (at rest, m³) over the area A and in still
// water V_still; each has an account of what it has yet to give,
//
//     due += (1 − exp(−σ τ)) (V − V_still),    due ≥ −A Δx/2,
//
// τ being the time since particles were sorted last and σ that of the column's middle. When they are sorted
// next, the column's highest particles leave until `due` is less than one of them. The account is signed, so
// what goes up and down about the level costs nothing, and it forgets what was missing beyond half a cell of
// height, so a level that sank before does not keep the sponge from taking the next wave. What lies more than
// a cell below the level never leaves.
//
// Still water loses nothing, as its V is V_still. A mean level that rises, since bodies fall in or a piston
// comes forward, is taken back to `level`. Bodies that float in the sponge count as water that is missing.
// Without random numbers: columns and particles in their order give the same bits on any number of threads.
// Tests: tests/unit/mpm/step/skim_test.cpp, tests/validation/flume_test.cpp.
#pragma once

#include <vector>

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// The columns, `counts` per horizontal axis, in the box from `low` to `high`.
template <int D>
struct SkimColumns {
    static constexpr int across = D - 1;
    Vector<across, double> low, high;  // m
    std::array<int, static_cast<std::size_t>(across)> counts{};

    int total() const;
    double area() const;                              // of each, m² (m in 2D)
    int at(const Vector<D, double>& point) const;     // y fastest; −1 before the sponge
    Vector<across, double> middle(int column) const;  // m
};

template <int D>
SkimColumns<D> skim_columns(const Layout<D>& layout, const Sponge& sponge);

// Takes what is due at `time` (s) since skimming.time; nothing without a sponge or where its level is 0. Done
// before particles are sorted.
template <int D, class Real>
void skim(const Parameters<D>& parameters, double time, const Grid<D, Real>& grid,
          std::vector<Particles<D, Real>>& bodies, Skimming& skimming, Outflow<D>& outflow);

}  // namespace tidewater::mpm
