#include "schedule.h"

#include <doctest/doctest.h>

using namespace tidewater;

TEST_CASE("what is due comes up once, however many of its times a step passes") {
    Schedule frames(0.1);
    CHECK(frames.due(0.0));
    CHECK(!frames.due(0.05));
    CHECK(frames.due(0.1004));
    CHECK(frames.next() == 0.2);
    CHECK(frames.due(0.55));
    CHECK(!frames.due(0.599));
    CHECK(frames.next() == 0.6);
    CHECK(frames.past() == 6);
}

TEST_CASE("times far closer together than steps are passed at once") {
    Schedule frames(1e-9);
    CHECK(frames.due(0.0));
    CHECK(frames.due(7.0));
    CHECK(frames.next() > 7.0);
    CHECK(frames.past() == 7'000'000'001);
}
