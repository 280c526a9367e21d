// A disc or ball of elastic ice that spins, and flies if it is told to, in empty space.
#pragma once

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "support/energy.h"
#include "support/ice_body.h"

namespace tidewater::test {

struct Spin {
    int radius = 10;         // cells
    double rim_speed = 0.0;  // of P waves' speed
    double speed = 0.0;      // along x, of P waves' speed
    long steps = 1000;
};

// What a run did to a body. Momenta are relative to Σ m |v| and Σ |x| m |v|, energies to that of the start.
struct SpinResult {
    double linear = 0.0, angular = 0.0;  // what changed
    double highest = -1.0;               // the greatest energy, less that of the start
    double lost = 0.0;                   // energy at the start less that at the end
    double growth = 0.0;                 // of the radius of gyration, relative
    double oblate = 0.0;                 // greatest over least axis of gyration, less 1
    double turns = 0.0;
    bool finite = false;
};

template <int D>
mpm::Start<D> spinning_start(const Spin& spin) {
    mpm::Start<D> start;
    start.cell_size = 1.0;
    const int across = 2 * spin.radius + 12;
    start.cells.fill(across);
    start.cells[0] += static_cast<int>(spin.speed * 0.5 * static_cast<double>(spin.steps));
    start.parameters.gravity = 0.0;
    start.parameters.ice.fracture = false;
    const Vector<D, double> middle = Vector<D, double>::Constant(0.5 * across);
    const double c = start.parameters.ice.wave_speed(D);
    auto& body = add_ice<D>(ball_shape<D>(middle, spin.radius), start);
    set_motion<D>(middle, spin.speed * c * Vector<D, double>::Unit(0),
                  test::spin<D>(spin.rim_speed * c / spin.radius), body);
    return start;
}

// Axes of gyration, the least first, m.
template <int D>
Vector<D, double> gyration(const State<D>& state) {
    Vector<D, double> middle = Vector<D, double>::Zero();
    for (const auto& x : state.x) middle += x / static_cast<double>(state.x.size());
    Matrix<D, double> moments = Matrix<D, double>::Zero();
    for (const auto& x : state.x)
        moments += (x - middle) * (x - middle).transpose() / static_cast<double>(state.x.size());
    return Eigen::SelfAdjointEigenSolver<Matrix<D, double>>(moments).eigenvalues().cwiseSqrt();
}

template <int D, class Real>
SpinResult run_spin(const Spin& spin) {
    auto s = mpm::make_simulation<D, Real>(spinning_start<D>(spin));
    const auto first = read_state(s);
    const auto before = momenta_of(first, 1.0);
    const double start_energy = mpm::take_ledger(s).kinetic;
    double scale = 0.0, arm_scale = 0.0;
    for (std::size_t p = 0; p < first.x.size(); ++p) {
        scale += first.mass[p] * first.v[p].norm();
        arm_scale += first.mass[p] * first.v[p].norm() * first.x[p].norm();
    }
    SpinResult result;
    double energy = start_energy;
    const long every = std::max(spin.steps / 200, 1L);
    for (long n = 0; n < spin.steps; ++n) {
        const double dt = mpm::stable_time_step(s);
        if (n % every > 0) {
            mpm::advance(s, dt);
            continue;
        }
        energy = advance_and_weigh(s, dt);
        result.highest = std::max(result.highest, energy / start_energy - 1);
    }
    const auto last = read_state(s);
    const auto after = momenta_of(last, 1.0);
    const auto axes = gyration(last), round = gyration(first);
    result.finite = is_finite(last);
    result.linear = (after.linear - before.linear).norm() / scale;
    result.angular = (after.angular - before.angular).norm() / arm_scale;
    result.lost = 1 - energy / start_energy;
    result.growth = axes.norm() / round.norm() - 1;
    result.oblate = axes.maxCoeff() / axes.minCoeff() - 1;
    result.turns =
        spin.rim_speed * s.parameters.ice.wave_speed(D) / spin.radius * s.time / (2 * std::acos(-1.0));
    return result;
}

// What must hold for every body that spins; tolerance: of momenta and of an energy that grows.
inline void check_spin(const SpinResult& result, double tolerance) {
    MESSAGE("momentum " << result.linear << ", angular momentum " << result.angular << ", highest energy "
                        << result.highest << ", energy lost " << result.lost << ", growth " << result.growth
                        << " in " << result.turns << " turns");
    CHECK(result.finite);
    CHECK(result.linear < tolerance);
    CHECK(result.angular < tolerance);
    CHECK(result.highest < tolerance);
    CHECK(result.lost < 0.01);
    CHECK(result.oblate < 0.005);
    CHECK(result.growth < 0.01);
}

}  // namespace tidewater::test
