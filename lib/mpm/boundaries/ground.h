// How the ground acts on what touches it: ice rubs, water glides. Bed and shelf share these rules.
//
// Of a velocity v at a node of the ground, whose outward normal is n, the part into the ground is taken away,
// and what leaves the ground may do so:
//
//     v_n' = max(v·n, 0),    N Δt/m = v_n' − v·n ≥ 0        N: the force that presses on the ground, m: mass
//
// Ice. The speed u along the ground falls by friction, which never turns it round,
//
//     m (u − u')/Δt = min(μ N_e (u'/(u' + u_0))^(1/q),  C u'^(1/q) A),      N_e = max(N − λ p_w A, 0)
//
//     μ    Coulomb's coefficient: 0 slides freely, infinity does not slide where it presses
//     u_0  m/s, speed of the regularised law (Joughin, Smith & Schoof 2019, eq. 2); 0: Coulomb's own law
//     C    Pa (s/m)^(1/q), of Weertman's law; 0: without it. Where both are given the smaller resists (Tsai,
//          Stewart & Thompson 2015, eq. 6); with μ = 0 Weertman's resists alone
//     q    exponent of sliding, 3 by Weertman (1957)
//     λ    share of the sea's hydrostatic pressure p_w at the ground that carries the ice; 0: dry
//     A    m² (m in 2D), the ground that the node stands for: the nodes of a column share that of their
//          column, Δx^(D−1)/n_z, by the spline's values at the ground. A constant stress on the ground loads
//          its nodes by just these shares. At the rim of a body A is less, by the node's mass over nine
//          tenths of that of ice that filled the node's room above the ground
//
// The law is solved for u' (implicit Euler), so that a small u is not thrown to and fro. Total friction on
// a body that slides is μ times the whole force that presses: on a plane slope its centre of mass
// accelerates by g (sin α − μ cos α).
//
// The work of friction is its impulse times the speed u' that is left, with which places and strains advance:
// a node that stands takes none, however its forces pull, and steady sliding −μ N_e u' a second. (The change
// of kinetic energy, ½ m (u'² − u²), would book ½ m u² in each step that holds a node against a force.)
//
// Water glides along the ground and may part from it. What resists it is drag on its whole column
// (mpm/boundaries/drag.h). Where a scene holds it, its nodes keep no velocity at all. That layer of held
// water grows with the steps: after n transfers of Δx cells it is about δ = (0.024 n)^¼ Δx thick, by
// the loss of the transfer (lib/mpm/README.md, Grid and transfer).
//
// While ice and water share one velocity at a node, the node is ice if more than half of its mass is
// (mpm/step/matter.h).
//
// Tests: tests/unit/mpm/boundaries/ground_test.cpp, tests/validation/ground_test.cpp.
#pragma once

#include "mpm/boundaries/wall.h"

namespace tidewater::mpm {

// What resists ice that slides on the ground; symbols and units above.
struct Sliding {
    double friction = 0.0;       // μ ≥ 0
    double regular_speed = 0.0;  // u_0 ≥ 0, m/s
    double weertman = 0.0;       // C ≥ 0, Pa (s/m)^(1/q)
    double exponent = 3.0;       // q ≥ 1
    double pore_pressure = 0.0;  // λ, 0 … 1
    bool resists() const { return friction > 0.0 || weertman > 0.0; }
    bool needs_area() const { return weertman > 0.0 || pore_pressure > 0.0; }
};

// The rule of one piece of ground.
struct GroundRule {
    Sliding ice;
    bool holds_water = false;    // water's nodes keep no velocity
    bool holds_down = false;     // what presses and what lifts off stays on the ground
    double sea_level = 0.0;      // m, of the water whose pressure ice's λ takes a share of
    double sea_weight = 0.0;     // N/m³, ρw g
    double ice_density = 900.0;  // kg/m³

    // Whether it treats ice and water differently.
    bool tells_matter() const { return ice.resists() || holds_water; }
};

// The ground below one node.
template <int D>
struct Footing {
    Vector<D, double> normal;  // n, of length 1
    double height = 0.0;       // m, of the ground
    double area = 0.0;         // m², A of a node that is covered; read, as is room, where the law needs it
    double room = 0.0;         // m³, of the node above the ground
};

// u', m/s.
//     speed      u ≥ 0, m/s
//     grip       what Coulomb's law can take, μ N_e Δt/m, m/s, ≥ 0
//     viscous    what Weertman's law takes at 1 m/s, C A Δt/m, m/s
double sliding_speed(const Sliding& law, double speed, double grip, double viscous);

// Applies the rule to the velocity of a node of the ground, and books the work of friction. What Coulomb's
// law could still take is left in at.grip, from where a second call in the same step goes on.
template <int D, class Real>
void meet_ground(const GroundRule& rule, const Footing<D>& footing, double dt, const NodeAt<D>& at,
                 Node<Real>& velocity, WallAction<D>& action);

}  // namespace tidewater::mpm
