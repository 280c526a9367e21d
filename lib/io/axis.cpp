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

std::string superscript(int exponent) {
    static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const char c : std::to_string(exponent)) text += c == '-' ? "⁻" : digits[c - '0'];
    return text;
}

// Of factor * 10^exponent, factor from 1 to 9.
std::string log_label(int factor, int exponent) {
    if (-4 < exponent && exponent < 4)
        return format_fixed(factor * std::pow(10.0, exponent), -std::min(exponent, 0));
    return (factor == 1 ? "" : std::to_string(factor) + "·") + "10" + superscript(exponent);
}

}  // namespace

Ticks make_ticks(double low, double high, int greatest_count) {
    assert(low <= high && greatest_count >= 2);
    const bool apart = high - low > 1e-12 * std::max(std::abs(low), std::abs(high));  // or no step is
    if (!apart) return {{low}, {format_number(low)}};
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
    assert(low <= high && greatest_count >= 2);
    constexpr double little = 1e-9;
    const int first = static_cast<int>(std::floor(low + little)),
              last = static_cast<int>(std::floor(high + little));
    const int step = (last - first) / greatest_count + 1;  // between powers with labels
    const bool short_axis = high - low < 2.0;
    Ticks ticks;
    for (int exponent = first; exponent <= last; ++exponent) {
        const bool labelled = exponent % step == 0;
        for (int factor = 1; factor <= (step == 1 ? 9 : 1); ++factor) {
            const double at = exponent + std::log10(factor);
            if (at < low - little || at > high + little) continue;
            ticks.values.push_back(factor * std::pow(10.0, exponent));
            const bool told = labelled && (factor == 1 || (short_axis && (factor == 2 || factor == 5)));
            ticks.labels.push_back(told ? log_label(factor, exponent) : "");
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
