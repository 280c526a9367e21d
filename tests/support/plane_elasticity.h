// A reference for beams: plane linear elasticity of a rectangle clamped along x = 0, by finite elements with
// nine nodes (biquadratic, Gauss 3 × 3, consistent mass). The stress, as of mpm/ice.h for small strains, is
//
//     σ = κ tr(ε) I + 2μ dev(ε),   dev(ε) = ε − tr(ε)/2 I
#pragma once

#include <Eigen/SparseCholesky>
#include <cmath>
#include <vector>

#include "mpm/ice.h"

namespace tidewater::test {

struct Cantilever {
    double length = 100.0, height = 40.0;  // m
    double gravity = 9.81;                 // m/s²
    mpm::IceModel ice;
};

struct CantileverAnswer {
    double sag = 0.0;        // of the tip, mean over the height, m
    double frequency = 0.0;  // the lowest, Hz
};

// Timoshenko's beam with shear coefficient k = 5/6; k → ∞ is Euler–Bernoulli's. The frequency of the bending
// mode with the deflection of the weight, by Rayleigh's quotient with the rotatory inertia.
CantileverAnswer timoshenko(const Cantilever& beam, double k = 5.0 / 6.0);

// By elements of `along` × `up`.
CantileverAnswer plane_elasticity(const Cantilever& beam, int along, int up);

}  // namespace tidewater::test
