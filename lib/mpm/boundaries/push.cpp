#include "mpm/boundaries/push.h"

#include <numbers>

namespace tidewater::mpm {

double Push::velocity(double time) const {
    if (time >= 0.0 && time >= ramp) return speed;
    return time <= 0.0 ? 0.0 : 0.5 * speed * (1.0 - std::cos(std::numbers::pi * time / ramp));
}

double Push::position(double time) const {
    if (time >= 0.0 && time >= ramp) return speed * (time - 0.5 * ramp);
    if (time <= 0.0) return 0.0;
    return 0.5 * speed * (time - ramp / std::numbers::pi * std::sin(std::numbers::pi * time / ramp));
}

}  // namespace tidewater::mpm
