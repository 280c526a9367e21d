// Round values for the ticks of axes.
#pragma once

#include <string>
#include <vector>

namespace tidewater::io {

struct Ticks {
    std::vector<double> values;       // multiples of the step within [low, high]
    std::vector<std::string> labels;  // with just the decimals that the step needs; empty: no label
};

// Steps of 1, 2 or 5 times a power of ten, at most `greatest_count` >= 2 of them. low <= high, both finite;
// where they are equal, or the same but for rounding, there is one tick.
Ticks make_ticks(double low, double high, int greatest_count);

// Of a logarithmic axis from 10^low to 10^high: powers of ten, "0.01", "100", "10⁵", at most
// `greatest_count` >= 2 of them with labels. Over less than two decades 2 and 5 times a power have labels
// too, and where each power has one, all multiples of it are there without. low <= high, both finite.
Ticks make_log_ticks(double low, double high, int greatest_count);

// The smallest of 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10 times a power of ten that is not below value > 0.
double round_up(double value);

}  // namespace tidewater::io
