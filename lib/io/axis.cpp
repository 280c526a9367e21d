#include "io/axis.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>

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

// "0.01", "10⁻⁴"
std::string power_label(int exponent) {
    if (std::abs(exponent) <= 3) return format_number(std::pow(10.0, exponent));
    constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string label = exponent < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::abs(exponent)))
        label += digits[static_cast<std::size_t>(digit - '0')];
    return label;
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

Ticks make_log_ticks(double low, double high, int greatest_count) {
    assert(0.0 < low && low < high && greatest_count >= 2);
    const double decades = std::log10(high / low);
    if (decades < 1.0 / 3.0) return make_ticks(low, high, greatest_count);
    const int first = static_cast<int>(std::floor(std::log10(low) + 1e-9)),
              powers =
                  static_cast<int>(std::floor(std::log10(high) + 1e-9) - std::ceil(std::log10(low) - 1e-9)) +
                  1;
    const int every = (std::max(powers, 1) + greatest_count - 1) / greatest_count;
    Ticks ticks;
    for (int exponent = first; exponent <= std::log10(high) + 1e-9; ++exponent) {
        for (int digit = 1; digit < 10; ++digit) {
            const double value = digit * std::pow(10.0, exponent);
            if (value < low * (1.0 - 1e-9) || value > high * (1.0 + 1e-9)) continue;
            const bool power = digit == 1 && exponent % every == 0;
            if (!power && every > 1) continue;
            const bool between = powers < 2 && (digit == 2 || digit == 5);
            ticks.values.push_back(value);
            ticks.labels.push_back(power ? power_label(exponent) : between ? format_number(value) : "");
        }
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
