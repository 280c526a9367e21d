#include "analysis/size_distribution.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "core/random.h"

using namespace tidewater;
using namespace tidewater::analysis;

namespace {

SizeFit power_law(double a) { return {.model = SizeModel::power_law, .exponent = a}; }

SizeFit truncated(double a, double cutoff) {
    return {.model = SizeModel::truncated_power_law, .exponent = a, .cutoff = cutoff};
}

SizeFit exponential(double cutoff) { return {.model = SizeModel::exponential, .cutoff = cutoff}; }

constexpr SizeSettings known{.smallest = 2.0, .replicates = 0};

}  // namespace

TEST_CASE("exceedance and histogram count every size once") {
    const std::vector<double> sizes{3.0, 1.0, 10.0, 1.0, none, -2.0, 0.0};
    const auto over = exceedance(sizes);
    REQUIRE(over.size() == 3);
    CHECK(over[0].count == 4);
    CHECK(over[1].size == 3.0);
    CHECK(over[2].count == 1);
    const auto bins = logarithmic_histogram(sizes, 2);
    REQUIRE(bins.size() == 2);
    CHECK(bins[0].count == 3);
    CHECK(bins[1].count == 1);
    CHECK(bins[0].density * (bins[0].high - bins[0].low) == doctest::Approx(3.0));
    CHECK(bins[1].high == doctest::Approx(10.0));
    CHECK(exceedance({}).empty());
    CHECK(logarithmic_histogram({}, 3).empty());
}

TEST_CASE("a power law's exponent lies in its interval 95 times of 100") {
    std::uint64_t seed = 0;
    for (const double a : {fragment_exponent_2d, fragment_exponent_3d, 2.5}) {
        int held = 0;
        constexpr int sets = 1000;
        for (int set = 0; set < sets; ++set) {
            const SizeDistribution fit = fit_sizes(draw_sizes(power_law(a), 2.0, 200, ++seed, 9), known);
            held += fit.power_law.exponent_interval.holds(a);
        }
        MESSAGE("a = " << a << ": coverage " << held / static_cast<double>(sets));
        CHECK(held > 0.93 * sets);
        CHECK(held < 0.97 * sets);
    }
}

TEST_CASE("exponent and cut-off of a truncated power law lie in their intervals") {
    int exponents = 0, cutoffs = 0;
    constexpr int sets = 200;
    for (std::uint64_t seed = 0; seed < sets; ++seed) {
        const auto sizes = draw_sizes(truncated(1.5, 200.0), 2.0, 500, seed, 9);
        const SizeDistribution fit = fit_sizes(sizes, known);
        exponents += fit.truncated.exponent_interval.holds(1.5);
        cutoffs += fit.truncated.cutoff_interval.holds(200.0);
    }
    MESSAGE("coverage of a " << exponents / 200.0 << ", of s_c " << cutoffs / 200.0);
    CHECK(exponents > 0.9 * sets);
    CHECK(cutoffs > 0.9 * sets);
    const SizeDistribution many = fit_sizes(draw_sizes(truncated(1.67, 500.0), 2.0, 20000, 3, 9), known);
    CHECK(many.truncated.exponent == doctest::Approx(1.67).epsilon(0.02));
    CHECK(many.truncated.cutoff == doctest::Approx(500.0).epsilon(0.1));
    CHECK(many.truncated_over_power.p < 1e-6);
    CHECK(many.truncated_over_exponential.p < 1e-6);
}

TEST_CASE("models are told apart, by likelihood and by the distance") {
    const SizeSettings settings{.smallest = 2.0, .replicates = 100};
    const SizeDistribution even = fit_sizes(draw_sizes(exponential(10.0), 2.0, 400, 5, 9), settings);
    CHECK(even.exponential.cutoff_interval.holds(10.0));
    CHECK(even.power_over_exponential.ratio < 0.0);
    CHECK(even.power_over_exponential.p < 0.01);
    CHECK(even.power_law.p < 0.05);
    CHECK(even.exponential.p > 0.05);
    CHECK(even.truncated.log_likelihood >= even.exponential.log_likelihood);
    const SizeDistribution power = fit_sizes(draw_sizes(power_law(1.67), 2.0, 400, 5, 9), settings);
    CHECK(power.power_over_exponential.ratio > 0.0);
    CHECK(power.power_over_exponential.p < 0.01);
    CHECK(power.power_law.p > 0.05);
    CHECK(power.exponential.p == 0.0);
    CHECK(power.truncated_over_power.p > 0.05);
    CHECK(power.truncated.log_likelihood > power.power_law.log_likelihood - 0.1);
    CHECK(power.trustworthy());
}

TEST_CASE("the lower cut-off is found where the power law begins") {
    std::vector<double> found;
    int held = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        auto sizes = draw_sizes(power_law(1.8), 5.0, 1000, seed, 9);
        for (std::uint64_t i = 0; i < 300; ++i) sizes.push_back(1.0 + 4.0 * random_uniform(seed, 0, i));
        const SizeDistribution fit = fit_sizes(sizes, {.replicates = seed == 0 ? 50 : 0});
        if (seed == 0) CHECK(fit.power_law.p > 0.05);
        found.push_back(fit.smallest);
        held += fit.power_law.exponent_interval.holds(1.8);
    }
    std::ranges::sort(found);
    MESSAGE("s_min: least " << found[0] << ", median " << found[50] << ", ninth decile " << found[90]
                            << ", greatest " << found[99] << "; coverage of a " << held / 100.0);
    CHECK(found[0] > 3.5);
    CHECK(found[50] > 4.5);
    CHECK(found[50] < 7.5);
    CHECK(held > 80);
}

TEST_CASE("p is the same on any number of threads") {
    const auto sizes = draw_sizes(truncated(1.5, 50.0), 2.0, 80, 1, 9);
    std::vector<double> first;
    for (const int threads : {1, 2, 5}) {
        const ThreadLimit limit(threads);
        const SizeDistribution fit = fit_sizes(sizes, {.replicates = 40, .seed = 7});
        const std::vector<double> p{fit.power_law.p, fit.truncated.p, fit.exponential.p};
        if (first.empty()) first = p;
        CHECK(p == first);
    }
}

TEST_CASE("few fragments, a narrow range and equal sizes are doubtful") {
    CHECK_FALSE(fit_sizes(draw_sizes(power_law(1.5), 2.0, 49, 1, 9), known).trustworthy());
    CHECK_FALSE(fit_sizes(draw_sizes(power_law(9.0), 2.0, 200, 1, 9), known).trustworthy());
    CHECK_FALSE(fit_sizes({}).trustworthy());
    CHECK_FALSE(fit_sizes(std::vector<double>{4.0}).trustworthy());
    CHECK(std::isnan(fit_sizes(std::vector<double>(100, 4.0)).power_law.exponent));
    CHECK_FALSE(fit_sizes(std::vector<double>{4.0, 5.0, 9.0}).trustworthy());
}

TEST_CASE("the modelled exceedance is that of sizes drawn from the model") {
    for (const SizeFit& fit : {power_law(1.7), truncated(1.5, 80.0), exponential(20.0)}) {
        CHECK(modelled_exceedance(fit, 2.0, 2.0) == doctest::Approx(1.0));
        std::vector<double> drawn = draw_sizes(fit, 2.0, 20000, 5, 0);
        std::ranges::sort(drawn);
        for (const std::size_t rank : {5000u, 10000u, 18000u}) {
            const double share = 1.0 - static_cast<double>(rank) / 20000.0;
            CHECK(std::abs(modelled_exceedance(fit, 2.0, drawn[rank]) - share) < 0.01);
        }
    }
    CHECK(std::isnan(modelled_exceedance({.model = SizeModel::truncated_power_law}, 2.0, 3.0)));
}
