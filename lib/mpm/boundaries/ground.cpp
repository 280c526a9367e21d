#include "mpm/boundaries/ground.h"

#include <cmath>
#include <limits>

#include "mpm/base/instantiate.h"

namespace tidewater::mpm {
namespace {

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
    if (leaves && !(rubs && at.grip != nullptr && *at.grip > 0.0f)) return;
    if (!leaves) velocity.template head<D>() -= outward * n.array();
    if (!rubs) return;

    const auto mass = static_cast<double>(velocity[mass_lane]);
    double area_dt = 0.0;  // A Δt/m
    if (rule.ice.needs_area())
        area_dt = footing.area * std::min(1.0, mass / (rule.ice_density * footing.room)) * dt / mass;
    const double head = rule.sea_weight * std::max(rule.sea_level - footing.height, 0.0);
    double pressed = -static_cast<double>(outward);  // N_e Δt/m
    if (pressed > 0.0) pressed = std::max(pressed - rule.ice.pore_pressure * head * area_dt, 0.0);
    const double left_before = at.grip != nullptr ? static_cast<double>(*at.grip) : 0.0;
    double grip = std::isinf(rule.ice.friction)
                      ? (pressed > 0.0 ? std::numeric_limits<double>::infinity() : 0.0)
                      : rule.ice.friction * pressed;
    grip = std::max(grip + left_before, 0.0);
    const Vector<D, double> along =
        velocity.template head<D>().template cast<double>().matrix() -
        (leaves ? static_cast<double>(outward) * footing.normal : Vector<D, double>::Zero().eval());
    const double speed = along.norm();
    const double slower = sliding_speed(rule.ice, speed, grip, rule.ice.weertman * area_dt);
    const double before = kinetic_energy_of<D>(velocity);
    if (speed > 0.0) {
        velocity.template head<D>() -= ((1.0 - slower / speed) * along).template cast<Real>().array();
        action.friction_work += kinetic_energy_of<D>(velocity) - before;
    }
    const bool coulomb = rule.ice.friction > 0.0 && !(rule.ice.regular_speed > 0.0);
    if (at.grip != nullptr && coulomb) *at.grip = static_cast<float>(std::max(grip - (speed - slower), 0.0));
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                     \
    template void meet_ground(const GroundRule&, const Footing<D>&, double, const NodeAt<D>&, Node<Real>&, \
                              WallAction<D>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
