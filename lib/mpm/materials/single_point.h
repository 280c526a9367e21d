// One material point of ice driven along a path of strain by the engine's own kernels advance_strain and
// return_to_yield. It shows how an ice model behaves without a grid, for calibration and tests.
//
// The principal axes stay x, (y,) z. Strains are logarithmic, one stretch e^(dε) per axis and step:
//
//     isotropic        ε = ln J                         the same on all axes
//     uniaxial         ε = ln of the stretch along x    lateral stress zero
//     uniaxial_strain  ε = ln of the stretch along x    lateral strain zero
//     shear            γ; stretches e^(γ/2) along x and e^(−γ/2) along z, so q = √3 μγ in 3D, 2μγ in 2D;
//                      constant volume or held pressure
//
// The return to the yield surface is a function of the step, not of the strain. So where a stress is
// prescribed, the unknown increment x, equal on all axes where it acts, is found by trial: the step is
// repeated from the state before it until x is bracketed to 1e-9 of the step. x solves
//
//     uniaxial               τ_lateral(x) = 0
//     shear, pressure held   p(x) = P
//
// Between the tensile and the compressive tip τ_lateral increases and p decreases with x, so there is a root
// while the surface reaches the prescribed stress. Where it does not (p0 < P), the step compresses by |dγ|.
// Failed ice is thus compressed step by step until it carries P, while ice whose hardening is capped at
// p0(α0) < P is compressed without end. Failed ice has no stress for any x; it takes x = 0, because a crack
// that opens does not move its flanks sideways.
//
// Energies are per volume at rest, J/m³. The work of a step is ½ (τ_old + τ_new) : dε; dissipated is the work
// of the yielding steps less their change of ice_energy. This is exact in the limit of short steps. A step
// that reverses and yields may be wrong by ¼ E dε², so dissipation may decrease by that much.
//
// Near the critical state, p = p0 (1−β)/2, and in failed ice results depend on the step, because the return
// uses the surface before the step, whose p0 may be wrong by κξ dε/2. Steps of p/(100 κξ) are short enough.
//
// Sources: Wolper et al. (2021), eqs. 2–6; lib/mpm/README.md, Ice. Symbols are those of ice.h and
// ice_yield.h. Test: tests/unit/mpm/materials/single_point_test.cpp.
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
    int steps = 2000;      // >= 1, in total
    int cycles = 0;        // 0: straight to `strain`; else cycles of 0 → strain → −strain → 0
    std::optional<double> held_pressure;  // Pa, for shear; without it the volume is constant
};

// How the return mapping treated a step. `failed`: p0 was 0, and the stress became 0.
enum class YieldCase { elastic, tensile_tip, compressive_tip, softening, hardening, failed };
inline constexpr std::array<std::string_view, 6> yield_case_names{
    "elastic", "tensile_tip", "compressive_tip", "softening", "hardening", "failed"};

// The state of the point in principal values; the axes are x, z in 2D and x, y, z in 3D.
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

// The state after one step, as it is tabulated.
struct PointRow {
    int step = 0;
    double strain = 0.0;
    double log_volume = 0.0;
    double pressure = 0.0, q = 0.0, p0 = 0.0;  // Pa
    double alpha = 0.0;
    double damage = 0.0;      // 1 − p0(α)/p0(α0); 1: failed; negative: stronger than at the start
    double dissipated = 0.0;  // J/m³, since the start
    YieldCase applied = YieldCase::elastic;
};

// A point without stress and strain that has the initial strength of the model.
template <int D, class Real>
IcePoint<D, Real> intact_point(const IceModel& model);

// Advances the point by one step, which stretches every axis i by e^(log_stretch[i]).
template <int D, class Real>
void stretch_point(const IceModel& model, const std::array<double, D>& log_stretch, IcePoint<D, Real>& point);

// The strain of a loading after step `step` in [0, loading.steps].
double strain_at(const Loading& loading, int step);

// Drives `point` along the loading and returns steps + 1 rows, of which the first is the initial state.
template <int D, class Real>
std::vector<PointRow> drive_point(const IceModel& model, const Loading& loading, IcePoint<D, Real> point);

// Notable rows of a path.
struct Milestones {
    std::optional<PointRow> onset;    // the first row that has yielded
    std::optional<PointRow> max_q;    // the first row with the max. q
    std::optional<PointRow> failure;  // the first row without strength, α >= 0
};
Milestones find_milestones(const std::vector<PointRow>& rows);

// Closed forms of the first yield, for comparison; another one is IceModel::uniaxial_strength.
double tension_onset(const IceModel& model, int dimension);  // ln J = ½ ln(1 + 2βp0/κ), isotropic
double shear_strength(const IceModel& model);                // q = M p0 √(β/(1+2β)) at p = 0, Pa
double uniaxial_crushing_strength(const IceModel& model, int dimension);  // p = σ/d, q = σ in compression, Pa

}  // namespace tidewater::mpm
