// What a checkpoint must contain: everything that the further course of a run depends on, except what its
// Start provides (parameters, layout, the list of bodies).
//
//     save    visit_state(s, writer)
//     load    s = make_simulation(start);  visit_state(s, reader);  relink(s)
//
// A loaded simulation continues bit by bit as the saved one would have. Whoever adds a member to Simulation,
// Particles, Grid or RigidBody that the next step reads adds a line here. A change of Block, of fraction_bits
// or of the meaning of a value needs a new format_version of checkpoints. Test:
// tests/unit/mpm/state/state_test.cpp.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// Calls visit(name, value) for each value, with a name that is the same in every run. A value is a number, an
// Eigen vector or matrix of fixed size, or a std::vector of these, which a loading visitor may resize.
template <int D, class Real, class Visit>
void visit_state(Simulation<D, Real>& s, const Visit& visit) {
    visit("time", s.time);
    visit("dt", s.dt);
    visit("step", s.step);
    visit("speeds.particle", s.speeds.particle);
    visit("speeds.sound", s.speeds.sound);
    visit("signal.sound", s.speeds.signal.sound);
    visit("signal.motion", s.speeds.signal.motion);
    long material = static_cast<long>(s.speeds.signal.material);  // visitors take numbers only
    visit("signal.material", material);
    s.speeds.signal.material = static_cast<Material>(material);
    visit("near_speed", s.near_speed);
    visit("drift", s.drift);
    visit("unknown_fill", s.unknown_fill);
    visit("wall_impulse", s.accounts.wall_impulse);
    visit("gravity_impulse", s.accounts.gravity_impulse);
    visit("boundary_work", s.accounts.boundary_work);
    visit("friction_work", s.accounts.friction_work);
    visit("drag_work", s.accounts.drag_work);
    visit("outflow.mass", s.accounts.outflow.mass);
    visit("outflow.momentum", s.accounts.outflow.momentum);
    visit("outflow.kinetic", s.accounts.outflow.kinetic);
    visit("outflow.potential", s.accounts.outflow.potential);
    visit("skimming.time", s.skimming.time);
    visit("skimming.due", s.skimming.due);
    long going = s.settling.going ? 1 : 0;
    visit("settling.going", going);
    s.settling.going = going != 0;
    visit("settling.stress", s.settling.stress);
    visit("settling.energy", s.settling.energy);
    visit("settling.quiet", s.settling.quiet);
    visit("settling.time", s.settling.time);
    visit("particle_blocks", s.grid.particle_blocks);
    for (std::size_t body = 0; body < s.bodies.size(); ++body) {
        const std::string of = "body" + std::to_string(body) + ".";
        Particles<D, Real>& particles = s.bodies[body];
        for_each_column(particles, [&](const std::string& name, auto& column) { visit(of + name, column); });
        visit(of + "begin", particles.begin);
    }
    visit("nodes", s.grid.nodes);
    for (std::size_t body = 0; body < s.rigid.size(); ++body) {
        const std::string of = "rigid" + std::to_string(body) + ".";
        RigidBody& rigid = s.rigid[body];
        for (std::size_t axis = 0; axis < rigid.anchor.size(); ++axis) {
            visit(of + "anchor" + std::to_string(axis), rigid.anchor[axis]);
        }
        visit(of + "center", rigid.center);
        visit(of + "rotation", rigid.rotation.coeffs());  // (x, y, z, w)
        visit(of + "velocity", rigid.velocity);
        visit(of + "angular_momentum", rigid.angular_momentum);
        visit(of + "angular_velocity", rigid.angular_velocity);
        visit(of + "water_impulse", rigid.water_impulse);
        visit(of + "water_turn", rigid.water_angular_impulse);
        visit(of + "contact_impulse", rigid.contact_impulse);
    }
}

// Rebuilds what a checkpoint leaves out because it follows from the state: the tiles and their links to
// nodes. Returns false if the arrays do not match, as when they come from a build with another Block; the
// simulation cannot be used then.
template <int D, class Real>
bool relink(Simulation<D, Real>& s) {
    const auto& keys = s.grid.particle_blocks;
    for (std::size_t slot = 1; slot < keys.size(); ++slot) {
        if (keys[slot - 1] >= keys[slot]) return false;
    }
    for (const auto& particles : s.bodies) {
        const auto& begin = particles.begin;
        if (begin.size() != keys.size() + 1 || !std::is_sorted(begin.begin(), begin.end())) return false;
        if (begin.front() != 0 || begin.back() != particles.size()) return false;
        bool fits = true;
        for_each_column(particles, [&](const std::string&, const auto& column) {
            fits = fits && (column.empty() || column.size() == particles.size());
        });
        if (!fits || particles.position[0].size() != particles.size()) return false;
    }
    std::vector<BlockKey> blocks = std::move(s.grid.particle_blocks);
    std::vector<Node<Real>> nodes = std::move(s.grid.nodes);
    s.grid.particle_blocks.clear();
    s.grid.node_blocks.clear();
    s.grid.nodes.clear();
    activate(s.grid, std::move(blocks));
    if (s.grid.nodes.size() != nodes.size()) return false;
    const std::size_t count = s.grid.particle_blocks.size();
    if (s.near_speed.size() != count || s.drift.size() != count) return false;
    s.grid.nodes = std::move(nodes);
    return true;
}

}  // namespace tidewater::mpm
