// What all readings of the water surface share: φ on one vertical line (surface.h), and where it falls
// through one half.
#pragma once

#include <cstddef>
#include <span>

#include "analysis/surface.h"

namespace tidewater::analysis {

// c: the share of the spline centred at `center` that lies in [low, high].
double spline_share(double center, double low, double high, double cell_size);

// The samples of a line; sample k is at z = k · spacing.
struct LineSamples {
    double spacing = 0.0;  // m
    std::size_t count = 0;

    explicit LineSamples(const Tank& tank);
};

// Adds amount · N((z - z_k)/Δx) to every sample k of a line, which is not yet divided by Δx^D and shares.
void spread_on_line(double z, double amount, double cell_size, const LineSamples& samples,
                    std::span<double> line);

// Δx^D c(x) c(y) of a place.
double full_line(const Place& place, const Tank& tank);

// z where φ, from the bed upward, first falls through one half; NaN without water on the bed.
double find_surface(std::span<const double> line, const LineSamples& samples, double full, double bed,
                    const Tank& tank);

}  // namespace tidewater::analysis
