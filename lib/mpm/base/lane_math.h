// Roots, logarithm and hyperbolic sine that compilers vectorise: plain arithmetic without calls, branches or
// tables. They are accurate with and without fused multiply-add, but the last bits of the results differ
// between builds that fuse and builds that do not.
//
//                     valid for                            max. error of float / double
//     lane_sqrt       x ≥ 0                                correctly rounded
//     inverse_cbrt    1e-30 ≤ x ≤ 1e30                     1.5e-7 / 3e-16, relative
//     lane_log1p      −1 + ε ≤ x ≤ 1e30 (ε: one rounding)  1.5e-7 / 5e-16, relative, also as x → 0
//     small_sinh      |x| ≤ 1⁄2                            1.0e-7 / 2e-16, relative, also as x → 0
//
// Outside of its range a function returns an arbitrary number or NaN, and never traps. Test:
// tests/unit/mpm/base/lane_math_test.cpp.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace tidewater::mpm {

// √x without errno: std::sqrt sets it for x < 0 by a call, which prevents vectorisation.
template <class Real>
inline Real lane_sqrt(Real x) {
#if defined(__has_builtin) && __has_builtin(__builtin_elementwise_sqrt)
    return __builtin_elementwise_sqrt(x);
#else
    return std::sqrt(x);
#endif
}

// x^(−1/3).
//
// The bits of a float, read as an integer, are 2²³ (log2 x + 127) to within 0.09·2²³. A guess y therefore has
// the bits (4/3) 127·2²³ minus a third of those of x; the constant in the code is shifted so that the max.
// residual |r| = |1 − x y³| is minimal, 0.102. The root is y (1 − r)^(−1/3) = y (1 + r/3 + 2r²/9 + 14r³/81 +
// …). The first correction, up to r³, leaves a relative error of 1.6e-5, and the second, up to r, 5e-10. A
// double starts from the float's root and takes one correction up to r². This is the well-known bit-level
// start of the inverse square root, adapted to the cube root.
inline float inverse_cbrt(float x) {
    const float third = static_cast<float>(std::bit_cast<std::int32_t>(x)) * (1.0f / 3.0f);
    float y = std::bit_cast<float>(std::int32_t{0x54A1F600} - static_cast<std::int32_t>(third));
    float r = 1.0f - x * y * y * y;
    y += y * r * (1.0f / 3.0f + r * (2.0f / 9.0f + r * (14.0f / 81.0f)));
    r = 1.0f - x * y * y * y;
    return y + y * r * (1.0f / 3.0f);
}
inline double inverse_cbrt(double x) {
    const double y = static_cast<double>(inverse_cbrt(static_cast<float>(x)));
    const double r = 1.0 - x * y * y * y;
    return y + y * r * (1.0 / 3.0 + r * (2.0 / 9.0));
}

// ln(1 + x).
//
// 1 + x = 2^k (1 + f) with 1 + f in [√½, √2]. k is taken from the rounded sum 1 + x; f = (2^−k − 1) + 2^−k x
// is rounded once, and not at all where k = 0. With s = f/(2 + f) and z = s² ≤ 0.0295,
//     ln(1 + f) = 2 atanh s = 2s (1 + z/3 + z²/5 + …) = f − s (f − 2z (1/3 + z/5 + …)),
// a form in which only the small second term is rounded. The series ends where the next term is below 2e-9
// (float) or 5e-18 (double).
template <class Real>
inline Real lane_log1p(Real x) {
    using Bits = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;
    constexpr int fraction = std::numeric_limits<Real>::digits - 1;
    constexpr Bits bias = std::numeric_limits<Real>::max_exponent - 1;
    constexpr Real sqrt_half = Real(0.70710678118654752440), ln2 = Real(0.69314718055994530942);

    // Unsigned, because the difference may overflow for an x outside of the range.
    const auto above = std::bit_cast<std::make_unsigned_t<Bits>>(Real(1) + x) -
                       std::bit_cast<std::make_unsigned_t<Bits>>(sqrt_half);
    const Bits k = static_cast<Bits>(above) >> fraction;
    const Real scale = std::bit_cast<Real>((bias - k) << fraction);
    const Real f = (scale - Real(1)) + scale * x;
    const Real s = f / (Real(2) + f);
    const Real z = s * s;
    Real sum = Real(1.0 / 9.0);
    if constexpr (sizeof(Real) == 8)
        sum += z * (Real(1.0 / 11.0) +
                    z * (Real(1.0 / 13.0) +
                         z * (Real(1.0 / 15.0) +
                              z * (Real(1.0 / 17.0) + z * (Real(1.0 / 19.0) + z * Real(1.0 / 21.0))))));
    sum = Real(1.0 / 3.0) + z * (Real(1.0 / 5.0) + z * (Real(1.0 / 7.0) + z * sum));
    return static_cast<Real>(k) * ln2 + (f - s * (f - Real(2) * z * sum));
}

// sinh x by its series. For |x| ≤ 1⁄2 the first term left out is below 1.1e-8 (float) or 5e-17 (double).
template <class Real>
inline Real small_sinh(Real x) {
    const Real z = x * x;
    Real sum = Real(1.0 / 5040.0);
    if constexpr (sizeof(Real) == 8)
        sum += z * (Real(1.0 / 362880.0) + z * (Real(1.0 / 39916800.0) + z * Real(1.0 / 6227020800.0)));
    return x + x * z * (Real(1.0 / 6.0) + z * (Real(1.0 / 120.0) + z * sum));
}

}  // namespace tidewater::mpm
