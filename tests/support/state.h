// What a simulation's particles are and do, by id and in double, whatever their order.
#pragma once

#include "mpm/bodies/lift.h"
#include "mpm/particles/motion.h"
#include "mpm/state/simulation.h"

namespace tidewater::test {

template <int D>
struct State {
    std::vector<Vector<D, double>> x, v;  // m, m/s; v as read from the grid
    std::vector<Matrix<D, double>> c;     // ∂v/∂x, 1/s
    std::vector<Matrix<D, double>> b;     // I + ε_b; ice
    std::vector<double> mass, j, alpha;
    std::vector<mpm::BlockKey> block;
};

template <int D>
struct Momenta {
    double mass = 0.0;
    Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero();
};

template <int D, class Real>
State<D> read_state(const mpm::Simulation<D, Real>& s) {
    const std::size_t count = s.particle_count();
    State<D> state;
    state.x.resize(count), state.v.resize(count), state.c.resize(count), state.mass.resize(count);
    state.b.assign(count, Matrix<D, double>::Identity());
    state.j.resize(count), state.alpha.resize(count), state.block.resize(count);
    for (const auto& particles : s.bodies) {
        mpm::for_each_motion(s.grid, particles,
                             [&](std::size_t slot, const mpm::Index<D>& block, std::size_t p,
                                 const Vector<D, Real>& v, const Matrix<D, Real>& g) {
                                 const std::size_t id = particles.id[p];
                                 state.block[id] = s.grid.particle_blocks[slot];
                                 state.x[id] = mpm::global_position(s.grid.layout, block, particles, p);
                                 state.v[id] = v.template cast<double>();
                                 state.c[id] = g.template cast<double>() / s.grid.layout.cell_size;
                                 state.mass[id] = particles.mass;
                                 if (!particles.j.empty()) state.j[id] = static_cast<double>(particles.j[p]);
                                 if (!particles.alpha.empty())
                                     state.alpha[id] = static_cast<double>(particles.alpha[p]);
                                 if (particles.strain[0].empty()) return;
                                 std::size_t column = 0;
                                 for (int i = 0; i < D; ++i) {
                                     for (int k = i; k < D; ++k, ++column) {
                                         state.b[id](i, k) +=
                                             static_cast<double>(particles.strain[column][p]);
                                         state.b[id](k, i) = state.b[id](i, k);
                                     }
                                 }
                             });
    }
    return state;
}

// ε:Cᵀ, twice the axial vector of a velocity gradient.
template <int D>
Eigen::Vector3d twice_axial(const Matrix<D, double>& c) {
    if constexpr (D == 3)
        return {c(2, 1) - c(1, 2), c(0, 2) - c(2, 0), c(1, 0) - c(0, 1)};
    else
        return {0.0, c(0, 1) - c(1, 0), 0.0};
}

// Σ m, Σ m v and Σ m [x × v + (Δx²/4) ε:Cᵀ] about the box's corner.
template <int D>
Momenta<D> momenta_of(const State<D>& state, double cell_size) {
    Momenta<D> sum;
    for (std::size_t p = 0; p < state.x.size(); ++p) {
        const Eigen::Vector3d x = mpm::lift<D>(state.x[p]), v = mpm::lift<D>(state.v[p]);
        sum.mass += state.mass[p];
        sum.linear += state.mass[p] * v;
        sum.angular +=
            state.mass[p] * (x.cross(v) + 0.25 * cell_size * cell_size * twice_axial<D>(state.c[p]));
    }
    return sum;
}

template <int D, class Real>
Momenta<D> momenta_of(const mpm::Simulation<D, Real>& s) {
    Momenta<D> sum = momenta_of(read_state(s), s.grid.layout.cell_size);
    for (const mpm::RigidBody& body : s.rigid) {
        const Eigen::Vector3d impulse = body.mass * body.velocity;
        sum.mass += body.mass;
        sum.linear += impulse;
        sum.angular += body.center_in_box(s.grid.layout.cell_size).cross(impulse) + body.angular_momentum;
    }
    return sum;
}

template <int D>
bool is_finite(const State<D>& state) {
    for (std::size_t p = 0; p < state.x.size(); ++p) {
        const bool finite = state.x[p].allFinite() && state.v[p].allFinite() && state.c[p].allFinite() &&
                            state.b[p].allFinite() && std::isfinite(state.j[p]) &&
                            std::isfinite(state.alpha[p]);
        if (!finite) return false;
    }
    return true;
}

}  // namespace tidewater::test
