#include "analysis/energy_flux.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "analysis/dispersion.h"

using namespace tidewater::analysis;

namespace {

constexpr double pi = std::numbers::pi;

struct Record {
    std::vector<double> time, value;
};

template <class Eta>
Record sampled(double duration, double step, const Eta& eta) {
    Record record;
    for (int i = 0; i * step < duration; ++i) {
        record.time.push_back(i * step);
        record.value.push_back(eta(i * step));
    }
    return record;
}

}  // namespace

TEST_CASE("a sinusoid carries half ρ g a² at its group celerity") {
    const WaterColumn water{.depth = 2.0, .density = 1025.0, .gravity = 9.81};
    for (const double period : {1.0, 2.5, 8.0}) {
        const Record r = sampled(40.0 * period, 0.02 * period,
                                 [&](double t) { return 0.1 * std::sin(2 * pi * t / period); });
        const double expected = 0.5 * 1025.0 * 9.81 * 0.01 * group_celerity(2 * pi / period, 2.0, 9.81);
        CHECK(spectral_energy_flux(wave_spectrum(r.time, r.value), water) ==
              doctest::Approx(expected).epsilon(0.01));
    }
}

TEST_CASE("the energy of Boussinesq's solitary wave passes, less a tenth of its relative height") {
    for (const double height : {0.01, 0.1, 0.3}) {
        const double k = std::sqrt(0.75 * height), c = std::sqrt(9.81 * (1.0 + height)),
                     middle = 10.0 / k / c;
        const Record r = sampled(2.0 * middle, 0.01, [&](double t) {
            return height / std::pow(std::cosh(k * c * (t - middle)), 2);
        });
        const double closed = 1000.0 * 9.81 * 8.0 / (3.0 * std::sqrt(3.0)) * std::pow(height, 1.5);
        const double share = long_wave_energy(r.time, r.value, {.depth = 1.0}) / closed;
        CHECK(1.0 - share == doctest::Approx(0.1 * height).epsilon(0.05));
    }
}

TEST_CASE("of long waves both ways agree") {
    const Record r = sampled(4000.0, 1.0, [](double t) { return 0.01 * std::sin(2 * pi * t / 100.0); });
    const WaterColumn water{.depth = 10.0};
    const double mean = long_wave_energy(r.time, r.value, water) / r.time.back();
    CHECK(spectral_energy_flux(wave_spectrum(r.time, r.value), water) == doctest::Approx(mean).epsilon(0.01));
}

TEST_CASE("gaps carry nothing, and what is no record has no energy") {
    const WaterColumn water{.depth = 1.0};
    CHECK(std::isnan(long_wave_energy({}, {}, water)));
    CHECK(std::isnan(long_wave_energy(std::vector{0.0}, std::vector{1.0}, water)));
    CHECK(std::isnan(long_wave_energy(std::vector{0.0, 1.0}, std::vector{none, 1.0}, water)));
    const std::vector<double> time{0.0, 1.0, 2.0, 3.0}, gap{0.1, 0.1, none, 5.0};
    CHECK(long_wave_energy(time, gap, water) ==
          doctest::Approx(1000.0 * 9.81 * 0.01 * std::sqrt(9.81 * 1.1)));
    CHECK(long_wave_energy(std::vector{0.0, 1.0}, std::vector{-2.0, -2.0}, water) == 0.0);
    CHECK(std::isnan(spectral_energy_flux(Spectrum{}, water)));
}
