// All that the future of a run depends on, besides what its Start already says (parameters, layout, which
// bodies there are): the one place that knows what a checkpoint must hold.
//
//     save    visit_state(s, writer)
//     load    s = make_simulation(start);  visit_state(s, reader);  relink(s)
//
// A loaded simulation goes on to the same bits as the saved one. Whoever adds a member to Simulation,
// Particles, Grid or RigidBody that the next step reads adds a line here. Test: tests/unit/mpm/state_test.cpp
#pragma once

#include <string>

#include "mpm/simulation.h"

namespace tidewater::mpm {

// Calls visit(name, value) for each value, with a name that is the same in every run: a number, an Eigen
// vector or matrix of fixed size, or a std::vector of these, which a visitor that loads may resize.
template <int D, class Real, class Visit>
void visit_state(Simulation<D, Real>& s, const Visit& visit) {
    visit("time", s.time);
    visit("step", s.step);
    visit("speeds.particle", s.speeds.particle);
    visit("speeds.sound", s.speeds.sound);
    visit("drift", s.drift);
    visit("wall_impulse", s.wall_impulse);
    visit("gravity_impulse", s.gravity_impulse);
    visit("particle_blocks", s.grid.particle_blocks);
    for (std::size_t body = 0; body < s.bodies.size(); ++body) {
        const std::string of = "body" + std::to_string(body) + ".";
        Particles<D, Real>& particles = s.bodies[body];
        visit(of + "position", particles.position);
        visit(of + "velocity", particles.velocity);
        visit(of + "gradient", particles.gradient);
        visit(of + "j", particles.j);
        visit(of + "offset", particles.offset);
        visit(of + "id", particles.id);
        visit(of + "begin", particles.begin);
    }
    for (std::size_t body = 0; body < s.rigid.size(); ++body) {
        const std::string of = "rigid" + std::to_string(body) + ".";
        RigidBody& rigid = s.rigid[body];
        visit(of + "center", rigid.center);
        visit(of + "rotation", rigid.rotation.coeffs());  // (x, y, z, w)
        visit(of + "velocity", rigid.velocity);
        visit(of + "angular_momentum", rigid.angular_momentum);
        visit(of + "angular_velocity", rigid.angular_velocity);
        visit(of + "inertia", rigid.inertia);
        visit(of + "mass", rigid.mass);
        visit(of + "radius", rigid.radius);
    }
}

// Makes what follows from the state: tiles, nodes and their links. Nodes and tiles hold nothing between
// steps.
template <int D, class Real>
void relink(Simulation<D, Real>& s) {
    activate(s.grid, std::vector<int>(s.grid.particle_blocks));
}

}  // namespace tidewater::mpm
