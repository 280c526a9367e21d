// Elastic ice: the advance of its strain and its stress, split neo-Hookean elasticity, batch by batch. The
// failure of ice is in ice_yield.h.
//
//     b = FᴱFᴱᵀ, J² = det b, dev b = b − (tr b/d) I;  d = 2 or 3; p is positive in compression
//     τ = μ J^(−2/d) dev b + (κ/2)(J² − 1) I          Kirchhoff stress, Pa      eqs. 2–4
//     p = −(κ/2)(J² − 1),   q = √((6−d)/2) μ J^(−2/d) |dev b|
//     W = (μ/2)(J^(−2/d) tr b − d) + (κ/2)((J² − 1)/2 − ln J)
//                                                     stored energy, J/m³ at rest; τ = 2 ∂W/∂b b
//
// A particle keeps the strain ε = b − I and the hardening variable α. It does not keep b, because near b = I
// a `float` would lose the digits of a strain of 5e-5. det b − 1 = I1(ε) + I2(ε) + I3(ε) has no cancellation.
//
// Strains and stresses are symmetric and have the columns xx, xz, zz in 2D and xx, xy, xz, yy, yz, zz in 3D.
// Every kernel works on the first `count` lanes, a multiple of `lanes` up to batch_size, and its columns must
// not overlap. Valid range of strains in float: |ε| ≤ 1e12, so that I3 is finite.
//
// Sources: Wolper et al. (2021), eqs. 2–4; lib/mpm/README.md, Ice. Test:
// tests/unit/mpm/materials/ice_test.cpp.
#pragma once

#include <array>

#include "mpm/base/batch.h"

namespace tidewater::mpm {

// The bulk modulus κ of a 2D scene. With E and ν as measured, a slice of a wide body has κ = λ + μ (plane
// strain). The paper's 2D code takes λ + 2μ/3 as in 3D; at ν = 0.3 its beams are 4 % softer and its P waves
// 5 % slower. In 3D both are λ + 2μ/3.
enum class Moduli { plane_strain, paper };

// What a return to the yield surface between its tips keeps.
//     pressure   det b and with it p, as the paper means
//     trace      tr b, as the code of the paper's authors does; p changes
enum class ShearReturn { pressure, trace };

struct IceModel {
    double density = 900.0;       // ρ, kg/m³
    double youngs_modulus = 1e9;  // E, Pa
    double poisson_ratio = 0.3;   // ν
    Moduli moduli = Moduli::plane_strain;
    bool fracture = true;    // false: ice stays elastic, and return_to_yield is never called
    double beta_p0 = 0.5e6;  // βp0, Pa, initial strength in isotropic tension
    double beta = 0.03;      // β > 0, strength in isotropic tension over that in compression (README.md)
    double friction = 1.4;   // M, slope of the critical state line q = M p
    double hardening = 3.0;  // ξ > 0, hardening rate; softening in tension is stable only if βξ < 1
    // true: α stays ≥ α0 and so p0 ≤ p0(α0). false: the paper's rule, with which the strength of ice sheared
    // under pressure grows unbounded.
    bool cap_hardening = true;
    ShearReturn shear_return = ShearReturn::pressure;

    double shear_modulus() const { return youngs_modulus / (2 * (1 + poisson_ratio)); }  // μ, Pa
    double lame_lambda() const {                                                         // λ, Pa
        return youngs_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
    }
    double bulk_modulus(int dimension) const;  // κ, Pa
    double wave_speed(int dimension) const;  // of P waves, m/s: √((κ+4μ/3)/ρ) in 3D, √((κ+μ)/ρ) in 2D
    double initial_alpha(int dimension) const;  // α0
    // Strength σt in uniaxial tension, Pa: the σ for which p = −σ/d, q = σ lies on the yield surface.
    double uniaxial_strength(int dimension) const;
};

// The ξ of the crack band (Bažant & Oh 1983). Under uniaxial tension a band of failing ice of this `width`
// (m) then dissipates `energy` (J/m²) per area of crack, so that a crack costs the same with any cell size.
// The band's strength falls to zero in proportion to −α while α, the deviatoric plastic strain, grows from α0
// to 0:
//
//     energy = width · ½ σt |α0| / √((6−d)/2),   |α0| = asinh(p0/κ)/ξ,   σt = uniaxial_strength
//
// tests/unit/mpm/materials/single_point_test.cpp measures this at one point for β from 0.1 to 1 and widths of
// 1 to 8 m in 2D and 3D: the energy is right to 0.1 % in the limit of short steps, and to 0.3 % with 500
// steps up to the strength. A band wider than 2 E energy/σt², with E that of uniaxial stress, snaps: it
// releases its stored energy of ½ σt²/E per volume, which is more than `energy`.
double crack_band_hardening(const IceModel& model, int dimension, double energy, double width);

// The constants that the kernels use. Pressures are in units of κ, so that no square overflows a float.
template <int D, class Real>
struct IceConstants {
    Real mu, half_kappa;     // Pa
    Real q2_factor;          // (q/κ)² = q2_factor J^(−4/d) |dev b|²
    Real one_plus_two_beta;  // 1 + 2β
    Real beta;
    Real friction2;   // M²
    Real xi;          // ξ
    Real min_alpha;   // α0 if hardening is capped, else −1e6, which no α reaches
    bool keep_trace;  // ShearReturn::trace
    Real max_angle;   // argument of sinh: ξ|α0| if capped, and never above asinh 0.45 (ice_yield.h)

    explicit IceConstants(const IceModel& model);
};

// The bits that the stress kernels return for a whole batch.
enum IceState : unsigned {
    ice_yielded = 1,   // some particle was outside its yield surface
    ice_unusable = 2,  // some strain is not finite or, in ice_stress, has J² outside [1e-4, 1e4]
};

// Advances b ← (I+A) b (I+A)ᵀ in the form M = A (I+ε), ε ← ε + M + Mᵀ + M Aᵀ.
//     increment   A = Δt C, D·D columns, A_ij in column i·D + j
//     strain      ε, symmetric_size<D> columns, read and written
template <int D, class Real>
void advance_strain(const Column<Real>* increment, int count, Column<Real>* strain);

// Computes τ of elastic ice. For a finite J^(−2/d), J² is held within [1e-4, 1e4] there. A J² outside returns
// ice_unusable, because without fracture nothing brings such ice back.
//     strain      ε, symmetric_size<D> columns
//     kirchhoff   τ, Pa, symmetric_size<D> columns, written
template <int D, class Real>
unsigned ice_stress(const IceConstants<D, Real>& ice, const Column<Real>* strain, int count,
                    Column<Real>* kirchhoff);

// W (J/m³) of a whole batch of strains ε with J > 0 in symmetric_size<D> columns, without cancellation down
// to strains of 1e-7.
template <int D>
void ice_energy(const IceModel& model, const Column<double>* strain, Column<double>& energy);
// The same for one strain.
template <int D>
double ice_energy(const IceModel& model, const std::array<double, symmetric_size<D>>& strain);

}  // namespace tidewater::mpm
