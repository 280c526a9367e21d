#include "io/places.h"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace tidewater::io;

TEST_CASE("places are named by their axes, and read back") {
    CHECK(place_name({.x = 2.0}) == "x=2");
    CHECK(place_name({.x = 2.0, .y = 0.5}) == "x=2 y=0.5");
    CHECK(place_name({.x = 1.61, .z = 0.003}) == "x=1.61 z=0.003");
    for (const char* name : {"x=2", "x=2 y=0.5", "x=1.61 z=0.003", "x=1 y=2 z=0"}) {
        const auto place = parse_place(name);
        REQUIRE(place);
        CHECK(place_name(*place) == name);
    }
}

TEST_CASE("other columns name no place") {
    for (const char* name : {"", "time", "x", "x=", "x=a", "y=2", "x=1 x=2", "x=1  y=2", "x=1,y=2", "q=1"})
        CHECK_MESSAGE(!parse_place(name), name);
}
