#include "core/progress.h"

#include <doctest/doctest.h>

using namespace tidewater;

TEST_CASE("durations are told in the two largest units") {
    CHECK(format_duration(0.0) == "0 s");
    CHECK(format_duration(12.4) == "12 s");
    CHECK(format_duration(200.0) == "3 min 20 s");
    CHECK(format_duration(3720.0) == "1 h 02 min");
}

TEST_CASE("durations round to the unit above where that is nearer") {
    CHECK(format_duration(59.4) == "59 s");
    CHECK(format_duration(59.6) == "1 min 00 s");
    CHECK(format_duration(3599.6) == "1 h 00 min");
}

TEST_CASE("the remaining time follows from what this process did, not from what was done before it") {
    CHECK(remaining_text(10.0, 0.0, 0.5) == "10 s left");
    CHECK(remaining_text(10.0, 0.5, 0.75) == "10 s left");
    CHECK(remaining_text(10.0, 0.5, 0.5) == "estimating");
    CHECK(remaining_text(0.0, 0.0, 0.0) == "estimating");
    CHECK(remaining_text(10.0, 0.5, 1.0) == "0 s left");
}

TEST_CASE(
    "outside of a terminal the remaining time is told as soon as it is known, then per tenth or 10 minutes") {
    ProgressTold told;
    const auto due = [&](double seconds, double fraction) {
        return progress_due(told, false, seconds, 0.3, fraction);
    };
    CHECK(due(0.0, 0.3));
    told = {.seconds = 0.0, .tenth = 3};
    CHECK(!due(0.5, 0.3001));  // too early for a rate
    CHECK(!due(5.0, 0.3));     // nothing is done yet
    CHECK(due(1.1, 0.3001));
    told = {.seconds = 1.1, .tenth = 3, .left = true};
    CHECK(!due(2.0, 0.31));
    CHECK(due(2.0, 0.4));
    CHECK(due(602.0, 0.31));
}

TEST_CASE("on a terminal the line is redrawn ten times a second, and at the end") {
    const ProgressTold told{.seconds = 1.0, .tenth = 3, .left = true};
    CHECK(!progress_due(told, true, 1.05, 0.0, 0.35));
    CHECK(progress_due(told, true, 1.2, 0.0, 0.35));
    CHECK(progress_due(told, true, 1.05, 0.0, 1.0));
}

TEST_CASE("a negative duration, from a clock set back, is none") { CHECK(format_duration(-5.0) == "0 s"); }
