// The start of a simulation: bodies of particles, and rigid bodies, in a box.
//
// Test: tests/unit/mpm/step/start_test.cpp.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// What a simulation starts from. Points are in m, in the box from 0 to cells Δx.
template <int D>
struct Start {
    struct Body {
        Material material = Material::water;
        std::vector<Vector<D, double>> points;
        std::vector<Vector<D, double>> velocity;  // [point] m/s; empty: at rest
        std::vector<Matrix<D, double>> gradient;  // [point] ∂v/∂x, 1/s; empty: zero
        double mass = 0.0;                        // kg, of the whole body
        double volume = 0.0;                      // m³, of the whole body at rest
        double surface = 0.0;                     // water: height of the still surface, m
        std::vector<double> head;                 // water: [point] p/ρg, m; empty: depth below surface
        std::vector<float> strength;              // ice: [point] p0 over that of intact ice, in [0, 1];
                                                  // 0: has failed; empty: all are intact
    };
    double cell_size = 0.0;  // Δx, m
    Index<D> cells{};        // of the box
    Parameters<D> parameters;
    std::vector<Body> bodies;  // of particles; those without points are left out
    std::vector<RigidStart<D>> rigid;
};

// Makes a simulation at time 0 with s.dt = 0 and the given velocities on the nodes. Water starts hydrostatic.
//
// Water of the scheme `density` is compressed by its weight (mpm/materials/water.h): points move down within
// their column, which stands on z = 0 or the bed and ends at the surface, and the body's mass becomes that of
// columns so filled. Points move by at most 1/8 of the compression at the bottom (1 % at c0 = 10 √(gD)) times
// the depth.
//
// Throws a NumericsError if a point lies outside of the box or a velocity is not a number.
template <int D, class Real>
Simulation<D, Real> make_simulation(Start<D> start);

}  // namespace tidewater::mpm
