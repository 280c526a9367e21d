#include "mpm/boundaries/piston.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tidewater::mpm {
namespace {

constexpr double tail = 3.8;  // κ(ct − X) at the ends of the stroke

// Goring's law, with time and position counted from mid-stroke.
struct Solitary {
    double height, depth, kappa, celerity, half_stroke;

    explicit Solitary(const Piston& piston)
        : height(piston.height),
          depth(piston.depth),
          kappa(std::sqrt(0.75 * height / (depth * depth * depth))),
          celerity(std::sqrt(piston.gravity * (depth + height))),
          half_stroke(height / (kappa * depth) * std::tanh(tail)) {}

    double half_time() const { return (tail / kappa + half_stroke) / celerity; }

    // Solves X = (H/κD) tanh(κ(ct − X)); each iteration reduces the error to (H/D)/(1 + H/D) of it or less.
    double place(double time) const {
        if (std::abs(time) >= half_time()) return std::copysign(half_stroke, time);
        double x = 0.0;
        for (int n = 0; n < 64; ++n) {
            const double excess = x - height / (kappa * depth) * std::tanh(kappa * (celerity * time - x));
            x -= excess / (1.0 + height / depth);
        }
        return x;
    }

    double speed(double time) const {
        if (std::abs(time) >= half_time()) return 0.0;
        const double cosh = std::cosh(kappa * (celerity * time - place(time)));
        const double eta = height / (cosh * cosh);
        return celerity * eta / (depth + eta);
    }
};

}  // namespace

double Piston::position(double time) const {
    if (time <= 0.0 || !exists()) return 0.0;
    if (motion == PistonMotion::solitary) {
        const Solitary wave(*this);
        return wave.half_stroke + wave.place(time - wave.half_time());
    }
    const double omega = 2.0 * std::numbers::pi / period;
    const double share = time >= ramp ? 1.0 : 0.5 * (1.0 - std::cos(std::numbers::pi * time / ramp));
    return amplitude * share * (1.0 - std::cos(omega * time));
}

double Piston::velocity(double time) const {
    if (time <= 0.0 || !exists()) return 0.0;
    if (motion == PistonMotion::solitary) {
        const Solitary wave(*this);
        return wave.speed(time - wave.half_time());
    }
    const double omega = 2.0 * std::numbers::pi / period, pi = std::numbers::pi;
    const double share = time >= ramp ? 1.0 : 0.5 * (1.0 - std::cos(pi * time / ramp));
    const double growth = time >= ramp ? 0.0 : 0.5 * pi / ramp * std::sin(pi * time / ramp);
    return amplitude * (growth * (1.0 - std::cos(omega * time)) + share * omega * std::sin(omega * time));
}

}  // namespace tidewater::mpm
