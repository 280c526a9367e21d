// One material point of ice driven along a path of strain, by the engine's own kernels advance_strain and
// return_to_yield: what an ice model does before any grid is involved, for calibration and tests.
//
// The principal axes stay x, (y,) z. Strains are logarithmic, one stretch e^(dε) per axis and step:
//
//     isotropic        ε = ln J                         the same on all axes
//     uniaxial         ε = ln of the stretch along x    lateral stress zero
//     uniaxial_strain  ε = ln of the stretch along x    lateral strain zero
//     shear            γ; stretches e^(γ/2) along x and e^(−γ/2) along z, so q = √3 μγ in 3D, 2μγ in 2D
//                      volume constant, or the pressure held
//
// The return to the surface is no function of the strain but of the step. So where a stress is prescribed,
// the unknown increment x (alike on the axes it acts on) is searched for by doing the step again from the
// state before it, x bracketed, until the stress is right to 1e-9 of the step:
//
//     uniaxial               τ_lateral(x) = 0
//     shear, pressure held   p(x) = P
//
// Both rise (fall) in x from the tensile to the compressive tip, so there is a root while the surface reaches
// the wanted stress. Where it does not (p0 < P), the step compresses by |dγ|: ice that has failed is pressed
// together step by step until it carries P, and ice whose hardening is capped at p0(α0) < P goes on forever.
// Failed ice has no stress, whatever x; it takes x = 0: a crack that opens does not move its flanks sideways.
//
// Energies are per volume at rest, J/m³: a step's work is ½ (τ_old + τ_new) : dε, and what is dissipated is
// the work of the steps that yield less their change of ice_energy. Exact in the limit of short steps; a step
// that turns around and yields may be off by ¼ E dε² and so fall.
//
// Near the critical state, p = p0 (1−β)/2, and in failed ice results depend on the step: the mapping uses the
// surface of before the step, which may be off by κξ dε/2 in p0. Steps of p/(100 κξ) are short enough.
//
// Sources: Wolper et al. (2021), eqs. 2–6; lib/mpm/README.md, Ice. Symbols as in ice.h and ice_yield.h.
// Test: tests/unit/mpm/materials/single_point_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "mpm/materials/ice.h"

namespace tidewater::mpm {

enum class LoadPath { isotropic, uniaxial, uniaxial_strain, shear };

struct Loading {
    LoadPath path = LoadPath::isotropic;
    double strain = 2e-3;  // at the end, or the amplitude of cycles; negative: compression first
    int steps = 2000;      // >= 1 in all
    int cycles = 0;        // 0: straight to `strain`; else 0 → strain → −strain → 0, so many times
    std::optional<double> held_pressure;  // Pa, of shear; empty: constant volume
};

// What the return mapping did with a step. `failed`: p0 was 0, all stress was taken.
enum class YieldCase { elastic, tensile_tip, compressive_tip, softening, hardening, failed };
inline constexpr std::array<std::string_view, 6> yield_case_names{
    "elastic", "tensile_tip", "compressive_tip", "softening", "hardening", "failed"};

// Principal values; the axes are x, z in 2D and x, y, z in 3D.
template <int D, class Real>
struct IcePoint {
    std::array<Real, D> strain{};    // ε = b − 1
    std::array<double, D> stress{};  // τ, Pa
    Real alpha{};
    double log_volume = 0.0;  // ln J of the whole strain, elastic or not
    double work = 0.0;        // J/m³
    double dissipated = 0.0;  // J/m³
    YieldCase applied = YieldCase::elastic;
};

struct PointRow {
    int step = 0;
    double strain = 0.0;
    double log_volume = 0.0;
    double pressure = 0.0, q = 0.0, p0 = 0.0;  // Pa
    double alpha = 0.0;
    double damage = 0.0;      // 1 − p0(α)/p0(α0): 1 is failed; negative: stronger than at the start
    double dissipated = 0.0;  // J/m³, since the start
    YieldCase applied = YieldCase::elastic;
};

// Without stress and strain, as strong as the model says.
template <int D, class Real>
IcePoint<D, Real> intact_point(const IceModel& model);

// One step: every axis i is stretched by e^(log_stretch[i]).
template <int D, class Real>
void stretch_point(const IceModel& model, const std::array<double, D>& log_stretch, IcePoint<D, Real>& point);

// The strain of a loading after a step in [0, loading.steps].
double strain_at(const Loading& loading, int step);

// steps + 1 rows, the first of them that of `point` as it comes.
template <int D, class Real>
std::vector<PointRow> drive_point(const IceModel& model, const Loading& loading, IcePoint<D, Real> point);

// What one reads off a path first.
struct Milestones {
    std::optional<PointRow> onset;       // first row that has yielded
    std::optional<PointRow> greatest_q;  // of all rows
    std::optional<PointRow> failure;     // first row without strength, α >= 0
};
Milestones find_milestones(const std::vector<PointRow>& rows);

// Closed forms of the first yield, for comparison. See also IceModel::uniaxial_strength.
double tension_onset(const IceModel& model, int dimension);  // ln J = ½ ln(1 + 2βp0/κ), isotropic
double shear_strength(const IceModel& model);                // q = M p0 √(β/(1+2β)) at p = 0, Pa
double uniaxial_crushing_strength(const IceModel& model, int dimension);  // p = σ/d, q = σ in compression, Pa

}  // namespace tidewater::mpm
