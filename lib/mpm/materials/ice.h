// Ice: batch by batch, the advance of its strain and the stress of split neo-Hookean elasticity.
// Its failure is in ice_yield.h.
//
//     b = FᴱFᴱᵀ, J² = det b, dev b = b − (tr b/d) I;  d = 2 or 3; p is positive in compression
//     τ = μ J^(−2/d) dev b + (κ/2)(J² − 1) I          Kirchhoff stress, Pa      eqs. 2–4
//     p = −(κ/2)(J² − 1),   q = √((6−d)/2) μ J^(−2/d) |dev b|
//     W = (μ/2)(J^(−2/d) tr b − d) + (κ/2)((J² − 1)/2 − ln J)
//                                                     stored energy, J/m³ at rest; τ = 2 ∂W/∂b b
//
// Kept per particle: the strain ε = b − I, because b near 1 would lose the digits of a strain of 5e-5 in
// `float`, and the hardening α. det b − 1 = I1(ε) + I2(ε) + I3(ε) has no cancellation.
//
// Strains and stresses are symmetric: columns xx, xz, zz in 2D; xx, xy, xz, yy, yz, zz in 3D. Every kernel
// works on the first `count` lanes, a multiple of `lanes` up to batch_size; its columns must not overlap.
// Valid range of strains: |ε| ≤ 1e12 in float (I3 must be finite).
//
// Sources: Wolper et al. (2021), eqs. 2–4; lib/mpm/README.md, Ice. Test: tests/unit/mpm/materials/ice_test.cpp.
#pragma once

#include <array>

#include "mpm/base/batch.h"

namespace tidewater::mpm {

// κ of a 2D scene. A slice of a wide body, E and ν as measured, has λ + μ (plane strain); the paper's 2D code
// takes the λ + 2μ/3 of three dimensions, which makes beams 4 % and P waves 5 % softer at ν = 0.3. In 3D both
// are λ + 2μ/3.
enum class Moduli { plane_strain, paper };

// What the return to the surface between its tips keeps of b: det b and so p, which the paper means, or tr b
// as its authors' code does, by which p moves.
enum class ShearReturn { pressure, trace };

struct IceModel {
    double density = 900.0;       // ρ, kg/m³
    double youngs_modulus = 1e9;  // E, Pa
    double poisson_ratio = 0.3;   // ν
    Moduli moduli = Moduli::plane_strain;
    bool fracture = true;       // false: elastic, and return_to_yield is never called
    double beta_p0 = 0.5e6;     // βp0, strength under isotropic tension at the start, Pa
    double beta = 0.03;         // β > 0, strength in isotropic tension over that in compression; see README
    double friction = 1.4;      // M, slope of the critical state line q = M p
    double hardening = 3.0;     // ξ > 0; softening in tension is stable only if βξ < 1
    bool cap_hardening = true;  // keep α ≥ α0 and so p0 ≤ p0(α0); false is the paper's rule, by which ice
                                // sheared under pressure gains strength without bound
    ShearReturn shear_return = ShearReturn::pressure;

    double shear_modulus() const { return youngs_modulus / (2 * (1 + poisson_ratio)); }  // μ, Pa
    double lame_lambda() const {                                                         // λ, Pa
        return youngs_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
    }
    double bulk_modulus(int dimension) const;  // κ, Pa
    double wave_speed(int dimension) const;  // of P waves, m/s: √((κ+4μ/3)/ρ) in 3D, √((κ+μ)/ρ) in 2D
    double initial_alpha(int dimension) const;      // α0
    double uniaxial_strength(int dimension) const;  // in tension, Pa: where p = −σ/d, q = σ meets the surface
};

// Crack band (Bažant & Oh 1983): the ξ by which a band of failing ice as wide as `width` (m) dissipates
// `energy` (J/m²) per area of crack under uniaxial tension, so that cracks of different cells cost the same.
// The band's strength falls as −α to zero while α, the deviatoric plastic strain, runs from α0 to 0:
//
//     energy = width · ½ σt |α0| / √((6−d)/2),   |α0| = asinh(p0/κ)/ξ,   σt = uniaxial_strength
//
// Measured at one point (tests/unit/mpm/materials/single_point_test.cpp; β from 0.1 to 1, widths 1 to 8 m, 2D and 3D):
// right to 0.1 % in the limit of short steps, to 0.3 % with 500 steps to the strength. A band wider than
// 2 E energy/σt², E of uniaxial stress, snaps: it frees the ½ σt²/E that it stores per volume, more than
// asked.
double crack_band_hardening(const IceModel& model, int dimension, double energy, double width);

// What the kernels need of a model. Pressures are in units of κ, so that no square overflows a float.
template <int D, class Real>
struct IceConstants {
    Real mu, half_kappa;     // Pa
    Real q2_factor;          // (q/κ)² = q2_factor J^(−4/d) |dev b|²
    Real one_plus_two_beta;  // 1 + 2β
    Real beta;
    Real friction2;      // M²
    Real xi;             // ξ
    Real least_alpha;    // α0 if hardening is capped, else −1e6
    bool keep_trace;     // ShearReturn::trace
    Real largest_angle;  // of the sinh: ξ|α0| if capped; never above asinh 0.45, see ice_yield.h

    explicit IceConstants(const IceModel& model);
};

// Bits that the stress kernels return for a whole batch.
enum IceState : unsigned {
    ice_yielded = 1,   // some particle was outside its yield surface
    ice_unusable = 2,  // some strain is not finite or, in ice_stress, has J² outside [1e-4, 1e4]
};

// b ← (I+A) b (I+A)ᵀ, as M = A (I+ε), ε ← ε + M + Mᵀ + M Aᵀ.
//     increment   A = Δt C, D·D columns, A_ij in column i·D + j
//     strain      ε, symmetric_size<D> columns, read and written
template <int D, class Real>
void advance_strain(const Column<Real>* increment, int count, Column<Real>* strain);

// τ of elastic ice. J^(−2/d) is kept finite by holding J² within [1e-4, 1e4]; a J² outside returns
// ice_unusable: without fracture nothing mends such ice.
//     strain      ε, symmetric_size<D> columns
//     kirchhoff   τ, Pa, symmetric_size<D> columns, written
template <int D, class Real>
unsigned ice_stress(const IceConstants<D, Real>& ice, const Column<Real>* strain, int count,
                    Column<Real>* kirchhoff);

// W, J/m³, of one strain with J > 0. Without cancellation down to strains of 1e-7.
template <int D>
double ice_energy(const IceModel& model, const std::array<double, symmetric_size<D>>& strain);

}  // namespace tidewater::mpm
