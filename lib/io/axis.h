// Round values for the ticks of axes.
#pragma once

#include <string>
#include <vector>

namespace tidewater::io {

struct Ticks {
    std::vector<double> values;       // multiples of the step within [low, high]
    std::vector<std::string> labels;  // with just the decimals that the step needs
};

// Steps of 1, 2 or 5 times a power of ten, at most `greatest_count` >= 2 of them. low <= high, both finite;
// where they are equal there is one tick.
Ticks make_ticks(double low, double high, int greatest_count);

// For a logarithmic axis, 0 < low < high: the powers of ten within, or every second, third ... of them so
// that at most `greatest_count` >= 2 are labelled; where all are, also their multiples by 2 to 9, without a
// label
// (""), or labelled at 2 and 5 where fewer than two powers lie within. Less than a third of a decade has the
// ticks of make_ticks. Powers beyond 0.001 and 1000 are labelled as "10⁻⁴".
Ticks make_log_ticks(double low, double high, int greatest_count);

// The smallest of 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10 times a power of ten that is not below value > 0.
double round_up(double value);

}  // namespace tidewater::io
