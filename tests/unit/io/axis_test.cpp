#include "io/axis.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace tidewater::io;

TEST_CASE("ticks are round, within the range, and not too many") {
    const Ticks ticks = make_ticks(-0.13, 0.52, 8);
    CHECK(ticks.labels == std::vector<std::string>{"-0.1", "0.0", "0.1", "0.2", "0.3", "0.4", "0.5"});
    CHECK(make_ticks(0.0, 16.0, 16).values.size() == 17);
    for (double high = 1e-6; high < 1e9; high *= 1.7) {
        const Ticks found = make_ticks(0.0, high, 5);
        CHECK(found.values.size() >= 2);
        CHECK(found.values.size() <= 6);
        CHECK(found.values.back() <= high * (1.0 + 1e-9));
    }
}

TEST_CASE("labels have just the decimals of the step") {
    CHECK(make_ticks(0.0, 1.0, 4).labels == std::vector<std::string>{"0.0", "0.5", "1.0"});
    CHECK(make_ticks(0.0, 3.0, 3).labels == std::vector<std::string>{"0", "1", "2", "3"});
    CHECK(make_ticks(0.0, 0.04, 2).labels == std::vector<std::string>{"0.00", "0.02", "0.04"});
}

TEST_CASE("a range of no length has one tick") {
    CHECK(make_ticks(2.5, 2.5, 5).labels == std::vector<std::string>{"2.5"});
    CHECK(make_ticks(2132.0, std::nextafter(2132.0, 1e4), 5).labels == std::vector<std::string>{"2132"});
}

TEST_CASE("a logarithmic axis has powers of ten, and more where there are few") {
    const auto labels = [](double low, double high, int count) {
        std::vector<std::string> found;
        for (const auto& label : make_log_ticks(low, high, count).labels) {
            if (!label.empty()) found.push_back(label);
        }
        return found;
    };
    CHECK(labels(-2.5, 2.0, 10) == std::vector<std::string>{"0.01", "0.1", "1", "10", "100"});
    CHECK(labels(3.0, 6.5, 10) == std::vector<std::string>{"1000", "10⁴", "10⁵", "10⁶"});
    CHECK(labels(-12.0, -10.0, 10) == std::vector<std::string>{"10⁻¹²", "10⁻¹¹", "10⁻¹⁰"});
    CHECK(labels(0.0, 1.0, 10) == std::vector<std::string>{"1", "2", "5", "10"});
    CHECK(labels(0.0, 20.0, 5).size() <= 6);
    CHECK(make_log_ticks(0.0, 1.0, 10).values.size() == 10);
    CHECK(make_log_ticks(0.0, 20.0, 5).values.size() == 21);  // none between powers
    CHECK(make_log_ticks(1.0, 1.0, 2).values == std::vector<double>{10.0});
    CHECK(make_log_ticks(0.1, 0.2, 2).values.empty());
}

TEST_CASE("rounds up to a round number that is hardly greater") {
    CHECK(round_up(1.0) == doctest::Approx(1.0));
    CHECK(round_up(1.01) == doctest::Approx(1.5));
    CHECK(round_up(0.83) == doctest::Approx(1.0));
    CHECK(round_up(7.0) == doctest::Approx(8.0));
    CHECK(round_up(340.0) == doctest::Approx(400.0));
}
