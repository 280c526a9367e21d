// Crowding: how much more water there is at a place than fits, and how the scheme `density` ties the volumes
// of particles to it.
//
// A particle's J follows the divergence of the flow and so adds up the errors of every step, until it says
// nothing any more of the room that the particle has: pressure noise, which stirs the water, which makes more
// noise. The mass on the nodes does know the room. With φ the filled share of a node,
//
//     φ_i = m_i / (ρw Δx^D h_i) + s_i
//     e_i = φ_i − 1 where φ_i > min_fill, or φ − s > min_fill at the node above i; else 0
//     ē_i = e_i smoothed by (¼, ½, ¼) along each axis
//     J  ←  J + r (1/(1 + Σ w ē_i) − J),   r = min(Δt / √(Δx/g), max_crowding_rate)
//
// in addition to what the flow does, with J, φ and w all of the beginning of the step. (With φ one step older
// than J the feedback excites sound.) h_i is ½ for every mirroring wall on which the node lies, since only
// half of it is in the tank, and s_i is what rigid bodies have of it (mpm/bodies/rigid.h): so water keeps to
// the room outside of them. Where φ_i is low the water ends, and its pressure is about 0; but not below
// water, where it is a void, which closes once its particles have the volume that they have room for.
// (Without that a churned wake keeps its voids open: the level rises, and the energy.) A rigid body above
// does not make a void. A chequerboard on the nodes moves no water, so it must not press either: hence the
// smoothing.
//
// In a flow without errors φ J = 1 stays so, and long waves and still water notice nothing; at the surface,
// where e is cut off, waves of less than 50 cells lose about twice what they lose without. √(Δx/g), the time
// in which water falls through half a cell, is much shorter than a wave's period and much longer than sound
// needs for a cell.
//
// Where the mass on the nodes is not all water or partly lies beyond a wall that does not mirror, φ is not
// known; particles that touch such nodes, or whose nodes' neighbours are such, follow the flow alone. Which
// nodes these are is found when particles are sorted; the marks reach a cell further, so they hold until the
// next sort.
//
// Source: our own, of the family of volume corrections (lib/mpm/README.md, Water); measured against others in
// tests/validation/README.md. Test: tests/unit/mpm/step/crowding_test.cpp.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

inline constexpr double min_fill = 0.85;  // below it a node's φ counts as a surface or a void

// Whether there is water in particle block `slot`; elsewhere nobody asks for the crowding.
template <int D, class Real>
bool has_water(const std::vector<Particles<D, Real>>& bodies, std::size_t slot);

// Finds the nodes with unknown φ, as Simulation::unknown_fill holds them. Called when particles were sorted.
template <int D, class Real>
std::vector<std::uint8_t> find_unknown_fill(const Parameters<D>& parameters, double time,
                                            const Grid<D, Real>& grid,
                                            const std::vector<Particles<D, Real>>& bodies);

// Writes ē into the crowding lane of a tile of velocities of particle block `slot`; infinite where φ is not
// known.
//     unknown_fill  as found when particles were sorted
template <int D, class Real>
void load_crowding(double water_density, const Grid<D, Real>& grid, const std::vector<RigidBody>& rigid,
                   const std::vector<std::uint8_t>& unknown_fill, std::size_t slot, Node<Real>* tile);

}  // namespace tidewater::mpm
