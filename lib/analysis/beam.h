// Icebergs by beam theory: how far ice of even height reaches over deep water before it breaks off.
//
// The overhang is a cantilever under its weight and the water's pressure from below, a load per length and
// width of
//     w = ρi g H − ρw g D = ρi g H n,       n = 1 − ρw D / (ρi H)
// by which it bends down (n > 0), floats in balance (n = 0, D/H = ρi/ρw) or bends up (n < 0). With the moment
// w L²/2 at its root and the section modulus H²/6 per width, Euler and Bernoulli's stress at the surface is
//     σ = 3 ρi g L² |n| / H                                                     (beam)
// and reaches the strength σt at
//     L/H = √( σt / (3 ρi g H |n|) ).
// Wolper et al. (2021), eqs. 1 and 10, take half of that stress, so their lengths are √2 as great:
//     Li/H = √( 2 σt / (3 ρi g H |n|) )                                         (eq. 1)
//
// All take n as it is written, also for D > H, where the water's surface lies above the ice: the paper's
// cases go up to D/H = 1.2. There n counts buoyancy of more water than ice displaces, for the water on top of
// it presses down again; of submerged ice n is that of D = H, 1 − ρw/ρi, however deep it is. `submerged`
// gives that.
//
// Table: lib/analysis/README.md, Beams and icebergs. Test: tests/unit/analysis/beam_test.cpp.
#pragma once

namespace tidewater::analysis {

struct Overhang {
    double height = 0.0;            // H of the ice > 0, m
    double depth = 0.0;             // D of the water above the ice's base ≥ 0, m
    double ice_density = 900.0;     // ρi, kg/m³
    double water_density = 1000.0;  // ρw, kg/m³
    double gravity = 9.81;          // g, m/s²
};

// The same with D no greater than H.
Overhang submerged(const Overhang& overhang);

// n, the share of the weight that the water leaves.
double load_share(const Overhang& overhang);

// σ of a beam of length L m, Pa.
double surface_stress(const Overhang& overhang, double length);

// L/H at which the beam's stress is the strength (Pa); infinite where n = 0.
double beam_length_ratio(const Overhang& overhang, double strength);

// Li/H of eq. 1, likewise.
double paper_length_ratio(const Overhang& overhang, double strength);

}  // namespace tidewater::analysis
