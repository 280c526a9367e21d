#include "io/axis.h"

#include <doctest/doctest.h>

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
}

TEST_CASE("a logarithmic axis has its powers of ten labelled, and ticks between them") {
    const Ticks ticks = make_log_ticks(0.01, 100.0, 8);
    std::vector<std::string> labels = ticks.labels;
    std::erase(labels, "");
    CHECK(labels == std::vector<std::string>{"0.01", "0.1", "1", "10", "100"});
    CHECK(ticks.values.size() == 4 * 9 + 1);
    CHECK(ticks.values.front() == doctest::Approx(0.01));
    CHECK(ticks.values.back() == doctest::Approx(100.0));
}

TEST_CASE("a logarithmic axis of many decades leaves powers out, one of few has numbers between") {
    const Ticks many = make_log_ticks(1e-9, 1e9, 5);
    CHECK(many.labels == std::vector<std::string>{"10⁻⁸", "10⁻⁴", "1", "10⁴", "10⁸"});
    std::vector<std::string> few = make_log_ticks(1.5, 25.0, 8).labels;
    std::erase(few, "");
    CHECK(few == std::vector<std::string>{"2", "5", "10", "20"});
    CHECK(make_log_ticks(3.0, 4.0, 5).labels == make_ticks(3.0, 4.0, 5).labels);
}

TEST_CASE("rounds up to a round number that is hardly greater") {
    CHECK(round_up(1.0) == doctest::Approx(1.0));
    CHECK(round_up(1.01) == doctest::Approx(1.5));
    CHECK(round_up(0.83) == doctest::Approx(1.0));
    CHECK(round_up(7.0) == doctest::Approx(8.0));
    CHECK(round_up(340.0) == doctest::Approx(400.0));
}
