#include "core/random.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

using namespace tidewater;

namespace {

constexpr std::uint64_t count = 100'000;

std::vector<double> numbers(std::uint64_t seed, std::uint64_t stream) {
    std::vector<double> values;
    for (std::uint64_t i = 0; i < count; ++i) values.push_back(random_uniform(seed, stream, i));
    return values;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - 0.5) * (b[i] - 0.5);
    return 12.0 * sum / static_cast<double>(a.size());
}

}  // namespace

TEST_CASE("the mixing function is SplitMix64's") {
    // The first outputs of the reference implementation seeded with 0, whose state advances by the golden
    // gamma.
    CHECK(mix64(0) == 0xe220a8397b1dcdafULL);
    CHECK(mix64(0x9e3779b97f4a7c15ULL) == 0x6e789e6aa1b965f4ULL);
}

TEST_CASE("random numbers lie from 0 up to but not at 1, and fill it evenly") {
    std::array<int, 20> bins{};
    for (const double value : numbers(1, 0)) {
        REQUIRE(value >= 0.0);
        REQUIRE(value < 1.0);
        ++bins[static_cast<std::size_t>(20.0 * value)];
    }
    double chi_squared = 0.0;
    const double expected = static_cast<double>(count) / 20.0;
    for (const int bin : bins) chi_squared += (bin - expected) * (bin - expected) / expected;
    CHECK(chi_squared < 43.8);  // 19 degrees of freedom, exceeded by chance once in a thousand seeds
}

TEST_CASE("neighbours in counter, stream and seed are independent") {
    const auto values = numbers(1, 0);
    std::vector<double> shifted(values.begin() + 1, values.end());
    shifted.push_back(values.front());
    const double bound = 4.0 / std::sqrt(static_cast<double>(count));
    CHECK(std::abs(correlation(values, shifted)) < bound);
    CHECK(std::abs(correlation(values, numbers(1, 1))) < bound);
    CHECK(std::abs(correlation(values, numbers(2, 0))) < bound);
}

TEST_CASE("a random number does not depend on the order of the calls") {
    const auto forward = numbers(7, 3);
    for (std::uint64_t i = count; i-- > 0;) REQUIRE(random_uniform(7, 3, i) == forward[i]);
}

TEST_CASE("seed, stream and counter do not stand in for each other") {
    std::set<double> values;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        for (std::uint64_t stream = 0; stream < 10; ++stream) {
            for (std::uint64_t i = 0; i < 10; ++i) values.insert(random_uniform(seed, stream, i));
        }
    }
    CHECK(values.size() == 1000);
}
