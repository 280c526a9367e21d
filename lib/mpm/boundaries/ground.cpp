#include "mpm/boundaries/ground.h"

#include <cmath>

#include "mpm/base/instantiate.h"

namespace tidewater::mpm {
namespace {

// Of the mass of ice that fills a node's room, from which on the node counts as covered: within a body the
// masses of nodes at the ground scatter by a tenth.
constexpr double full_share = 0.9;

// Newton's method for a convex, rising f from a start at or above its root: the steps go down to the root.
template <class Step>
double descend(double x, const Step& newton_step) {
    constexpr int max_steps = 60;
    constexpr double enough = 1e-14;
    for (int n = 0; n < max_steps; ++n) {
        const double step = newton_step(x);
        if (!(step > enough * x)) break;
        x -= step;
    }
    return x;
}

// u' of m (u − u')/Δt = μ N_e (u'/(u' + u_0))^(1/q), with s = (u'/(u' + u_0))^(1/q) as the unknown.
double regularised_speed(const Sliding& law, double speed, double grip) {
    if (std::isinf(grip)) return 0.0;
    if (!(grip > 0.0)) return speed;
    const double q = law.exponent, u0 = law.regular_speed;
    const double s = descend(std::pow(speed / (speed + u0), 1.0 / q), [&](double x) {
        const double power = std::pow(x, q), rest = 1.0 - power;
        return (u0 * power / rest + grip * x - speed) / (u0 * q * power / (x * rest * rest) + grip);
    });
    const double power = std::pow(s, q);
    return power < 0.5 ? u0 * power / (1.0 - power) : speed - grip * s;  // whichever keeps its digits
}

// u' of u − u' = viscous u'^(1/q), with w = u'^(1/q) as the unknown.
double weertman_speed(const Sliding& law, double speed, double viscous) {
    if (!(viscous > 0.0)) return speed;
    const double q = law.exponent;
    const double w = descend(std::pow(speed, 1.0 / q), [&](double x) {
        const double power = std::pow(x, q);
        return (power + viscous * x - speed) / (q * power / x + viscous);
    });
    return std::pow(w, q);
}

// What resists the ice of a node, as sliding_speed takes it.
struct Resistance {
    double grip = 0.0, viscous = 0.0;  // m/s
};

//     mass     kg, of the node
//     pressed  N Δt/m, m/s; below 0 where the node leaves the ground
//     left     m/s, what the step's first meeting left of the grip
template <int D>
Resistance resistance_of(const GroundRule& rule, const Footing<D>& footing, double dt, double mass,
                         double pressed, float left) {
    const Sliding& law = rule.ice;
    double area_dt = 0.0;  // A Δt/m
    if (law.needs_area()) {
        const double full = full_share * rule.ice_density * footing.room;
        area_dt = footing.area * std::min(1.0, mass / full) * dt / mass;
    }
    const double sea = rule.sea_weight * std::max(rule.sea_level - footing.height, 0.0);
    if (pressed > 0.0) pressed = std::max(pressed - law.pore_pressure * sea * area_dt, 0.0);
    double grip = law.friction * pressed;
    if (std::isinf(law.friction)) grip = pressed > 0.0 ? law.friction : 0.0;  // ∞ · 0 is no number
    return {.grip = std::max(grip + static_cast<double>(left), 0.0), .viscous = law.weertman * area_dt};
}

}  // namespace

double sliding_speed(const Sliding& law, double speed, double grip, double viscous) {
    if (!(speed > 0.0)) return 0.0;
    double left = 0.0;
    if (law.friction > 0.0) {
        const bool regularised = law.regular_speed > 0.0;
        left = regularised ? regularised_speed(law, speed, grip) : std::max(speed - grip, 0.0);
    }
    if (law.weertman > 0.0) left = std::max(left, weertman_speed(law, speed, viscous));
    return left;
}

template <int D, class Real>
void meet_ground(const GroundRule& rule, const Footing<D>& footing, double dt, const NodeAt<D>& at,
                 Node<Real>& velocity, WallAction<D>& action) {
    if (at.matter == Material::water && rule.holds_water) {
        velocity.template head<D>().setZero();
        return;
    }
    const Vector<D, Real> n = footing.normal.template cast<Real>();
    const Real outward = n.dot(velocity.template head<D>().matrix());
    const bool leaves = outward >= Real(0) && !rule.holds_down;
    const bool rubs = at.matter == Material::ice && rule.ice.resists();
    const bool gripped = at.grip != nullptr && *at.grip > 0.0f;
    if (leaves && !(rubs && gripped)) return;
    if (!leaves) velocity.template head<D>() -= outward * n.array();
    if (!rubs) return;

    const Resistance resistance = resistance_of(rule, footing, dt, static_cast<double>(velocity[mass_lane]),
                                                -static_cast<double>(outward), gripped ? *at.grip : 0.0f);
    Vector<D, double> along = velocity.template head<D>().template cast<double>().matrix();
    if (leaves) along -= static_cast<double>(outward) * footing.normal;
    const double speed = along.norm();
    const double slower = sliding_speed(rule.ice, speed, resistance.grip, resistance.viscous);
    if (speed > 0.0)
        velocity.template head<D>() -= ((1.0 - slower / speed) * along).template cast<Real>().array();
    action.friction_work -= static_cast<double>(velocity[mass_lane]) * (speed - slower) * slower;
    const bool coulomb = rule.ice.friction > 0.0 && !(rule.ice.regular_speed > 0.0);
    if (at.grip != nullptr && coulomb)
        *at.grip = static_cast<float>(std::max(resistance.grip - (speed - slower), 0.0));
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                     \
    template void meet_ground(const GroundRule&, const Footing<D>&, double, const NodeAt<D>&, Node<Real>&, \
                              WallAction<D>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
