// Formulas for one particle of ice, without branches: one lane of the kernels of ice.cpp and ice_yield.cpp.
// Symbols are those of ice.h. Tests: tests/unit/mpm/materials/ice_test.cpp and ice_yield_test.cpp.
#pragma once

#include <algorithm>

#include "mpm/base/batch.h"
#include "mpm/base/lane_math.h"

namespace tidewater::mpm::ice_lane {

// Whether a kernel can work on `count` lanes.
inline bool is_batch(int count) { return count >= 0 && count <= batch_size && count % lanes == 0; }

// Whether column c holds a diagonal element of a symmetric tensor.
template <int D>
constexpr bool is_diagonal(int c) {
    return c == 0 || c == symmetric_size<D> - 1 || (D == 3 && c == 3);
}

// The column of element (i, j) of a symmetric tensor.
template <int D>
constexpr int column(int i, int j) {
    const int low = std::min(i, j), high = std::max(i, j);
    return low * D - low * (low - 1) / 2 + (high - low);
}

// One particle's strain, split as b = (1 + mean) I + dev.
template <int D, class Real>
struct Split {
    Real volume;                  // det b − 1
    Real mean;                    // tr ε / d
    Real dev[symmetric_size<D>];  // dev b
    Real dev2;                    // |dev b|²
};

template <int D, class Real>
inline Split<D, Real> split(const Column<Real>* strain, int p) {
    Split<D, Real> of;
    if constexpr (D == 2) {
        const Real xx = strain[0][p], xz = strain[1][p], zz = strain[2][p];
        of.volume = (xx + zz) + (xx * zz - xz * xz);
        of.mean = Real(0.5) * (xx + zz);
        const Real half = Real(0.5) * (xx - zz);
        of.dev[0] = half;
        of.dev[1] = xz;
        of.dev[2] = -half;
        of.dev2 = Real(2) * (half * half + xz * xz);
    } else {
        const Real xx = strain[0][p], xy = strain[1][p], xz = strain[2][p];
        const Real yy = strain[3][p], yz = strain[4][p], zz = strain[5][p];
        const Real minor = yy * zz - yz * yz;
        const Real second = minor + (xx * yy - xy * xy) + (xx * zz - xz * xz);
        const Real third = xx * minor - xy * (xy * zz - xz * yz) + xz * (xy * yz - xz * yy);
        of.volume = (xx + yy + zz) + (second + third);
        of.mean = Real(1.0 / 3.0) * (xx + yy + zz);
        of.dev[0] = xx - of.mean;
        of.dev[1] = xy;
        of.dev[2] = xz;
        of.dev[3] = yy - of.mean;
        of.dev[4] = yz;
        of.dev[5] = zz - of.mean;
        of.dev2 = of.dev[0] * of.dev[0] + of.dev[3] * of.dev[3] + of.dev[5] * of.dev[5] +
                  Real(2) * (xy * xy + xz * xz + yz * yz);
    }
    return of;
}

// det(I + r dev) − 1 = −r² |dev|²/2 + r³ det dev.
template <int D, class Real>
inline Real distortion(const Real* dev, Real dev2, Real r) {
    const Real second = -Real(0.5) * dev2;
    if constexpr (D == 2) return r * r * second;
    const Real third = dev[0] * (dev[3] * dev[5] - dev[4] * dev[4]) -
                       dev[1] * (dev[1] * dev[5] - dev[2] * dev[4]) +
                       dev[2] * (dev[1] * dev[4] - dev[2] * dev[3]);
    return r * r * (second + r * third);
}

// J² − 1 limited to the range in which J^(−2/d) is usable.
template <class Real>
inline Real clamp_volume(Real volume) {
    return std::min(std::max(volume, Real(1e-4 - 1)), Real(1e4 - 1));
}

// J^(−2/d) for volume = J² − 1 within that range.
template <int D, class Real>
inline Real inverse_stretch2(Real volume) {
    const Real j2 = Real(1) + volume;
    if constexpr (D == 2) return Real(1) / lane_sqrt(j2);
    return inverse_cbrt(j2);
}

// t − 1 with t = (1 + volume)^(1/d), without cancellation because t^d − 1 = (t − 1)(t^(d−1) + … + 1).
template <int D, class Real>
inline Real stretch2_minus_1(Real volume) {
    if constexpr (D == 2) return volume / (Real(1) + lane_sqrt(Real(1) + volume));
    const Real inverse = inverse_cbrt(Real(1) + volume);
    const Real t = (Real(1) + volume) * inverse * inverse;
    return volume / (Real(1) + t + t * t);
}

// J^(−2/d) tr b/d − 1, without cancellation: with a = 1 + mean and t = J^(2/d) it is (a − t)/t, and
// a^d − t^d = −a^d (det(I + dev/a) − 1).
template <int D, class Real>
inline Real shear_stretch(const Split<D, Real>& b) {
    const Real a = Real(1) + b.mean, j2 = Real(1) + b.volume;
    const Real fall = distortion<D>(b.dev, b.dev2, Real(1) / a);
    if constexpr (D == 2) {
        const Real t = lane_sqrt(j2);
        return -a * a * fall / (t * (a + t));
    }
    const Real inverse = inverse_cbrt(j2), t = j2 * inverse * inverse;
    return -a * a * a * fall / (t * (a * a + a * t + t * t));
}

// Stores τ = shear dev b + pull I of particle p.
template <int D, class Real>
inline void store_stress(const Split<D, Real>& b, Real shear, Real pull, Column<Real>* kirchhoff, int p) {
    for (int c = 0; c < symmetric_size<D>; ++c)
        kirchhoff[c][p] = is_diagonal<D>(c) ? shear * b.dev[c] + pull : shear * b.dev[c];
}

}  // namespace tidewater::mpm::ice_lane
