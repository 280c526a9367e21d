// Crowding: how much more water there is at a place than fits. The scheme `density` ties the volumes of
// particles to it.
//
// A particle's J follows the divergence of the flow and so accumulates the errors of every step, until it no
// longer says anything about the room that the particle has. The pressure noise stirs the water, which makes
// more noise. The mass on the nodes does know the room. With φ the filled share of a node,
//
//     φ_i = m_i / (ρw Δx^D h_i) + s_i
//     e_i = φ_i − 1 where φ_i > min_fill, or φ − s > min_fill at the node above i; else 0
//     ē_i = e_i smoothed by (¼, ½, ¼) along each axis
//     J  ←  J + r (1/(1 + Σ w ē_i) − J),   r = min(Δt / √(Δx/g), max_crowding_rate)
//
// in addition to the divergence of the flow, with J, φ and w all of the beginning of the step; with φ one
// step older than J the feedback would excite sound. h_i is ½ for every mirroring wall on which the node
// lies, since only half of the node is in the tank. s_i is the rigid bodies' share of the node
// (mpm/bodies/rigid.h), so that water keeps to the room outside of them.
//
// Where φ_i is low the water ends, and its pressure is about 0. Below water, however, a low φ_i is a void,
// which closes once its particles have the volume for which they have room. Without that a churned wake would
// keep its voids open, and level and energy would increase. A rigid body above does not make a void.
// Smoothing is needed because a chequerboard on the nodes moves no water, and so must not press either.
//
// A flow without errors keeps φ J = 1, and long waves and still water are not affected. At the surface, where
// e is cut off, waves of less than 50 cells lose about twice what they lose without crowding. √(Δx/g), the
// time in which water falls through half a cell, is much shorter than a wave's period and much longer than
// the time that sound needs for a cell.
//
// φ is unknown where the mass on the nodes is not all water or lies partly beyond a wall that does not
// mirror. Particles with such a node in reach, or the neighbour of one, follow the flow alone. The unknown
// nodes are found when particles are sorted; the marks extend one cell further, so that they hold until the
// next sort.
//
// Source: our own, of the family of volume corrections (lib/mpm/README.md, Water); measured against others in
// tests/validation/README.md.
// Tests: tests/unit/mpm/step/crowding_test.cpp, tests/unit/mpm/twin_test.cpp.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

inline constexpr double min_fill = 0.85;  // a node with a smaller φ is at a surface or in a void

// Whether particle block `slot` holds water; crowding is loaded only there.
template <int D, class Real>
bool has_water(const std::vector<Particles<D, Real>>& bodies, std::size_t slot);

// Finds the nodes with unknown φ, as Simulation::unknown_fill holds them. Call it after every sort.
//     time  s, at which moving boundaries have their place
template <int D, class Real>
std::vector<std::uint8_t> find_unknown_fill(const Parameters<D>& parameters, double time,
                                            const Grid<D, Real>& grid,
                                            const std::vector<Particles<D, Real>>& bodies);

// Writes ē into the crowding lane of a tile of velocities of particle block `slot`, infinity where φ is
// unknown. Reads the masses of the grid's nodes and the places of the rigid bodies.
//     water_density  ρw, kg/m³
//     unknown_fill   as find_unknown_fill returned it after the last sort
//     tile           Block<D>::tile_size nodes
template <int D, class Real>
void load_crowding(double water_density, const Grid<D, Real>& grid, const std::vector<RigidBody>& rigid,
                   const std::vector<std::uint8_t>& unknown_fill, std::size_t slot, Node<Real>* tile);

// Writes φ into the crowding lane of the tile, whatever the mass is that of.
template <int D, class Real>
void load_fill(double water_density, const Grid<D, Real>& grid, const std::vector<RigidBody>& rigid,
               std::size_t slot, Node<Real>* tile);

}  // namespace tidewater::mpm
