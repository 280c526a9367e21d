// How a simulation begins: bodies of particles in a box.
#pragma once

#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// What a simulation starts from. Points in m, in the box from 0 to cells Δx.
template <int D>
struct Start {
    struct Body {
        Material material = Material::water;
        std::vector<Vector<D, double>> points;
        std::vector<Vector<D, double>> velocity;  // of each point, m/s; empty: at rest
        std::vector<Matrix<D, double>> gradient;  // ∂v/∂x of each point, 1/s; empty: zero
        double mass = 0.0;                        // of the whole body, kg
        double volume = 0.0;                      // of the whole body at rest, m³
        double surface = 0.0;      // water: height of the still surface, from which it starts hydrostatic, m
        std::vector<double> head;  // water: p/ρg that each point starts with, m; empty: depth below surface
        std::vector<float> strength;  // ice: p0 that each point starts with over that of intact ice, in
                                      // [0, 1]; empty: 1; 0 has failed
    };
    double cell_size = 0.0;
    Index<D> cells{};
    Parameters<D> parameters;
    std::vector<Body> bodies;  // of water and ice; those without points are left out
    std::vector<RigidStart<D>> rigid;
};

// Time 0, s.dt = 0, velocities as given. Water of the scheme `density` is compressed by its weight: its
// points move by up to 1/8 of the compression at its bottom (1 % at c0 = 10 √(gD)) times its depth within
// their column, from its bottom at z = 0 or the bed to the surface, and its mass is that of columns so filled
// (mpm/materials/water.h). Throws NumericsError if a point lies outside of the box.
template <int D, class Real>
Simulation<D, Real> make_simulation(Start<D> start);

}  // namespace tidewater::mpm
