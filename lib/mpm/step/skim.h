// Skimming: how a sponge drains the volume that waves bring.
//
// Damping alone stops a wave, but its water stays and flows back. So the sponge treats the surface as it
// treats the velocity (mpm/boundaries/sponge.h), ∂η/∂t + … = −σ η, and long waves enter without an echo.
// Columns about as wide as the water is deep hold the volume V of water (at rest, m³), and V_still in still
// water, over the area A. Each column has an account of the volume that it still has to give,
//
//     due += (1 − exp(−σ τ)) (V − V_still),    due ≥ −A Δx/2,
//
// with τ the time since the last sort and σ that of the column's middle. When particles are sorted next, the
// column's highest particles leave until `due` is less than one of them. The account is signed, so that water
// which oscillates about the level loses nothing. It forgets a deficit beyond half a cell of height, so that
// a level that sank before does not keep the sponge from draining the next wave. Water more than a cell below
// the level never leaves.
//
// Still water loses nothing, because its V is V_still. A mean level that goes up because bodies fall in or a
// piston comes forward is brought back to `level`. Bodies that float in the sponge count as missing water.
// There are no random numbers: columns and particles in their order give the same bits on any number of
// threads.
//
// Tests: tests/unit/mpm/step/skim_test.cpp, tests/validation/flume_test.cpp.
#pragma once

#include <optional>
#include <vector>

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// The columns of a sponge; numbered with y fastest.
template <int D>
struct SkimColumns {
    static constexpr int across = D - 1;
    Vector<across, double> low, high;                            // m, ends of the sponge
    std::array<int, static_cast<std::size_t>(across)> counts{};  // columns per horizontal axis

    int total() const;
    double area() const;                                          // of each column, m² (m in 2D)
    std::optional<int> at(const Vector<D, double>& point) const;  // the column; empty in front of the sponge
    Vector<across, double> middle(int column) const;              // m
};

// The columns of a sponge with a level > 0.
template <int D>
SkimColumns<D> skim_columns(const Layout<D>& layout, const Sponge& sponge);

// Drains the water that is due at `time` (s). Call it before particles are sorted. Does nothing without a
// sponge or where its level is 0.
//     grid      read for the places and velocities of the particles; the nodes stay as they are
//     bodies    lose the particles of water that are due
//     skimming  reads and writes the columns' accounts, last updated at skimming.time
//     outflow   adds the mass, momentum and energy of the drained particles
template <int D, class Real>
void skim(const Parameters<D>& parameters, double time, const Grid<D, Real>& grid,
          std::vector<Particles<D, Real>>& bodies, Skimming& skimming, Outflow<D>& outflow);

}  // namespace tidewater::mpm
