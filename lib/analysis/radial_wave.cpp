#include "analysis/radial_wave.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace tidewater::analysis {
namespace {

double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180.0); }

bool within(double value, double least, double greatest) { return value >= least && value <= greatest; }

}  // namespace

double Slide::froude() const { return speed / std::sqrt(gravity * depth); }
double Slide::thickness_ratio() const { return thickness / depth; }
double Slide::mass_ratio() const { return mass / (water_density * width * depth * depth); }

double radial_factor(const Slide& slide, double distance_ratio, double angle) {
    assert(distance_ratio > 0.0 && std::abs(angle) <= 90.0);
    const double exponent = 2.0 * (1.0 + std::exp(-0.2 * distance_ratio));
    const double beside = std::pow(cosine(2.0 * angle / 3.0), exponent);
    return 1.5 * std::pow(distance_ratio, -5.0 / 6.0) * std::pow(slide.froude(), 0.4) *
           std::sqrt(slide.thickness_ratio() * slide.mass_ratio()) * beside;
}

double ImpulseProduct::height(double distance_ratio) const {
    assert(distance_ratio > 0.0);
    return 0.75 * std::pow(value * std::cbrt(1.0 / distance_ratio), 0.8) * depth;
}

ImpulseProduct impulse_product(const Slide& slide, double slope) {
    assert(slope >= 0.0 && slope <= 90.0);
    const double f = slide.froude(), s = slide.thickness_ratio(), m = slide.mass_ratio();
    const double p = f * std::sqrt(s) * std::pow(m, 0.25) * std::sqrt(cosine(6.0 * slope / 7.0));
    return {.value = p,
            .amplitude = 4.0 / 9.0 * std::pow(p, 0.8) * slide.depth,
            .depth = slide.depth,
            .froude_is_valid = within(f, 0.86, 6.83),
            .thickness_is_valid = within(s, 0.09, 1.64),
            .mass_is_valid = within(m, 0.11, 10.02),
            .value_is_valid = within(p, 0.17, 8.13)};
}

}  // namespace tidewater::analysis
