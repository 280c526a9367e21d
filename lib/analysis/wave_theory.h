// Closed forms of gravity waves over a flat bed: what scenes start with and what runs are compared with.
//
// x along the tank, z up from the bed, D the still depth, η the surface's height above it, a the wave's
// height, k = 2π/length, g gravity. SI units. The flow is irrotational and incompressible, exactly: it is the
// analytic function F = u − i w of x + i z that is real on the bed, where it is the bed's velocity u_b(x),
//
//     u − i w = u_b(x + i z),     ∂u/∂x = −∂w/∂z,  ∂u/∂z = ∂w/∂x
//
// standing   the first instant of a standing wave, with its crest at x = 0, at rest (linear theory):
//                η = a cos(kx),  ω² = g k tanh(kD)
//                p/ρg = D − z + η cosh(k z')/cosh(kD),  z' = z D/(D + η)
//            where z' (Wheeler's stretching) makes p zero on the displaced surface.
// solitary   towards +x with its crest at x = center, Grimshaw's third order in ε = a/D, with
//            q = sech²(α (x − center)/D), α = √(3ε/4) (1 − 5ε/8 + 71ε²/128):
//                η/D       = ε q − ¾ ε² q (1 − q) + ε³ (5/8 q (1 − q) − 101/80 q² (1 − q))
//                u_b/√(gD) = ε q + ε² (q/4 − q²) − ε³ (19/40 q + q²/5 − 6/5 q³)
//                c²/(gD)   = 1 + ε − ε²/20 − 3ε³/70
//                p/ρg      = D − z + (c u − ½ (u² + w²))/g              (Bernoulli in the wave's frame)
//            On the surface the kinematic condition is open by about 1.0 ε⁴ √(gD) and p by 1.3 ε⁴ ρgD at
//            ε = 0.2: 0.2 %. What is open is shed as a tail; Boussinesq's sech² with depth-averaged speeds
//            leaves p open by 1.7 % ρgD.
//
// Source: R. Grimshaw (1971), "The solitary wave in water of variable depth, part 2", J. Fluid Mech. 46,
// 611-622, as given by Lee, Yates & Wu (1982), J. Fluid Mech. 123; its terms in z follow from the bed's by
// the above. Test: tests/unit/analysis/wave_theory_test.cpp.
#pragma once

namespace tidewater::analysis {

enum class WaveKind { standing, solitary };

struct InitialWave {
    WaveKind kind = WaveKind::standing;
    double height = 0.0;    // a in (0, D), m; solitary waves up to highest_solitary D
    double length = 0.0;    // of a standing wave > 0, m
    double center = 0.0;    // of a solitary wave, m
    double depth = 0.0;     // D > 0, m
    double gravity = 9.81;  // g > 0, m/s²
};

// In D; beyond, the third order is open by more than 0.08 √(gD).
inline constexpr double highest_solitary = 0.4;

// ω of waves of small amplitude, rad/s; ω² = g k tanh(kD).
double angular_frequency(double wavenumber, double depth, double gravity);

// c of the solitary wave as above, m/s; √(g(D + a)) but for −0.1 % at ε = 0.2.
double solitary_celerity(const InitialWave& wave);

double elevation(const InitialWave& wave, double x);        // η, m
double elevation_slope(const InitialWave& wave, double x);  // ∂η/∂x
double elevated_area(const InitialWave& wave, double x);    // ∫ η dx from 0 to x, m²

// What the water does at a point below the surface.
struct WaveFlow {
    double head = 0.0;            // p/ρg, m
    double u = 0.0, w = 0.0;      // m/s
    double u_x = 0.0, u_z = 0.0;  // ∂u/∂x = −∂w/∂z and ∂u/∂z = ∂w/∂x, 1/s
};
WaveFlow wave_flow(const InitialWave& wave, double x, double z);

// Where still water's point (x, z) is put to make the displaced water: columns keep their area,
//     x' + ∫ η dx'/D = x,   z' = z (1 + η(x')/D),
// so that a lattice stays one of equal shares. Columns beyond the right wall of the displaced water are those
// of x > L + ∫ η dx/D.
struct Displaced {
    double x, z;
};
Displaced displace(const InitialWave& wave, double x, double z);

}  // namespace tidewater::analysis
