// The greatest principal stress of ice: where it is greatest, ice under tension cracks first.
//
//     σ  = τ/J                                    Cauchy stress, Pa; τ and J = √det b as in mpm/materials/ice.h
//     σ1 = (κ/2)(J² − 1)/J + μ J^(−2/d−1) e1      its greatest eigenvalue; e1: that of dev b
//
// Tension is positive. In 2D the stress across the plane is left out: σ1 is the greatest within the plane. J
// is that of the elastic strain; it is that of the whole strain but for what failing ice has opened. Under
// uniaxial tension σ1 is that tension; under equal pressure from all sides it is −p/J; beside a wall that the
// weight presses the ice against, −ρ g h ν/(1−ν) at depth h. Loose ice has 0.
//
// Test: tests/unit/mpm/readings/principal_stress_test.cpp.
#pragma once

#include <array>
#include <vector>

#include "mpm/materials/ice.h"
#include "mpm/particles/particles.h"

namespace tidewater::mpm {

// σ1 of a strain ε = b − I, Pa. J² counts as within [1e-4, 1e4], as in ice_stress.
template <int D>
double greatest_principal_stress(const IceModel& model, const std::array<double, symmetric_size<D>>& strain);

// The same of every particle of a body of ice, in their present order: each particle's own, not averaged over
// the grid. Empty for a body of another material.
template <int D, class Real>
std::vector<float> principal_stress(const IceModel& model, const Particles<D, Real>& particles);

}  // namespace tidewater::mpm
