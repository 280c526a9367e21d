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

TEST_CASE("a negative duration, from a clock set back, is none") { CHECK(format_duration(-5.0) == "0 s"); }
