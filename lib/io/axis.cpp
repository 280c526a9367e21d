#include "io/axis.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "io/text.h"

namespace tidewater::io {
namespace {

double power_of_ten_below(double value) { return std::pow(10.0, std::floor(std::log10(value))); }

double tick_step(double range, int greatest_count) {
    const double least = range / greatest_count, power = power_of_ten_below(least);
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least * (1.0 - 1e-9)) return factor * power;
    }
    return 10.0 * power;
}

}  // namespace

Ticks make_ticks(double low, double high, int greatest_count) {
    assert(low <= high && greatest_count >= 2);
    if (low == high) return {{low}, {format_number(low)}};
    const double step = tick_step(high - low, greatest_count);
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    Ticks ticks;
    for (double index = std::ceil(low / step - 1e-9); index * step <= high + 1e-9 * step; index += 1.0) {
        ticks.values.push_back(index * step);
        ticks.labels.push_back(format_fixed(index * step, decimals));
    }
    return ticks;
}

double round_up(double value) {
    assert(value > 0.0);
    const double power = power_of_ten_below(value);
    for (const double factor : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0}) {
        if (factor * power >= value * (1.0 - 1e-9)) return factor * power;
    }
    return 10.0 * power;
}

}  // namespace tidewater::io
