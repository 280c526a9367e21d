// The quadratic B-spline, by which particles and nodes, and what is drawn of them, share what they have.
//
//     N(t) = ¾ − t²            for |t| ≤ ½        t: distance in widths of the spline
//            ½ (3/2 − |t|)²    for ½ ≤ |t| ≤ 3/2
//            0                 beyond
//     Φ(t) = ∫ N from −∞ to t
//
// N sums to 1 over any row of nodes that lie a width apart. Source: Jiang et al. (2016), "The material point
// method for simulating continuum materials", §7. Test: tests/unit/core/spline_test.cpp.
#pragma once

#include <algorithm>
#include <cmath>

namespace tidewater {

// N(t).
inline double quadratic_spline(double t) {
    const double a = std::abs(t);
    if (a < 0.5) return 0.75 - a * a;
    return a < 1.5 ? 0.5 * (1.5 - a) * (1.5 - a) : 0.0;
}

// Φ(t). It is computed from the nearer end, so that the tails keep their digits.
inline double quadratic_spline_integral(double t) {
    const double a = std::min(std::abs(t), 1.5), rest = 1.5 - a;
    const double beyond = a < 0.5 ? 0.5 - 0.75 * a + a * a * a / 3.0 : rest * rest * rest / 6.0;  // 1 − Φ(a)
    return t < 0.0 ? beyond : 1.0 - beyond;
}

// The weights of the three nodes that a point touches along one axis.
template <class Real>
struct SplineWeights {
    Real below, at, above;  // of the nodes n − 1, n and n + 1
};

// f is the point's distance from its nearest node n, in [−½, ½) node spacings.
template <class Real>
constexpr SplineWeights<Real> spline_weights(Real f) {
    const Real before = Real(0.5) - f, after = Real(0.5) + f;
    return {Real(0.5) * before * before, Real(0.75) - f * f, Real(0.5) * after * after};
}

// The same weights, with ¾ − f² written so that the three sum to 1 but for one rounding: particles that step
// many times keep their mass by it.
template <class Real>
constexpr SplineWeights<Real> closed_spline_weights(Real f) {
    const Real before = Real(0.5) - f, after = Real(0.5) + f;
    const Real below = Real(0.5) * before * before, above = Real(0.5) * after * after;
    return {below, Real(1) - (below + above), above};
}

}  // namespace tidewater
