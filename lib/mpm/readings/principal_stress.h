// The maximum principal stress of ice. Under tension, ice cracks first where it is highest.
//
//     σ  = τ/J                                Cauchy stress, Pa; τ and J = √det b as in mpm/materials/ice.h
//     σ1 = (κ/2)(J² − 1)/J + μ J^(−2/d−1) e1  its max. eigenvalue; e1: that of dev b
//
// Tension is positive. In 2D, σ1 is the maximum within the plane; the stress normal to the plane is left out.
// J is the elastic volume ratio, which differs from the total one by what failing ice has opened. Under
// uniaxial tension σ1 is that tension, under equal pressure from all sides −p/J, and in ice that walls
// confine laterally under its own weight −ρ g h ν/(1−ν) at depth h. It is 0 in loose ice.
//
// Test: tests/unit/mpm/readings/principal_stress_test.cpp.
#pragma once

#include <array>
#include <vector>

#include "mpm/materials/ice.h"
#include "mpm/particles/particles.h"

namespace tidewater::mpm {

// σ1 of a strain ε = b − I, Pa. As in ice_stress, powers of J are taken with J² held within [1e-4, 1e4].
template <int D>
double max_principal_stress(const IceModel& model, const std::array<double, symmetric_size<D>>& strain);

// σ1 of every particle of a body of ice, in their present order and not averaged over the grid, Pa. Empty for
// a body of another material.
template <int D, class Real>
std::vector<float> principal_stress(const IceModel& model, const Particles<D, Real>& particles);

}  // namespace tidewater::mpm
