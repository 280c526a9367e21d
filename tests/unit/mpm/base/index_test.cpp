#include "mpm/base/index.h"

#include <doctest/doctest.h>

using namespace tidewater::mpm;

TEST_CASE("a place and its index say the same, with the last axis fastest") {
    int place = 0;
    for (int x = 0; x < 5; ++x) {
        for (int y = 0; y < 5; ++y) {
            for (int z = 0; z < 5; ++z, ++place) {
                const Index<3> at{x, y, z};
                CHECK(place_of<3>(at, 5) == place);
                CHECK(index_of<3>(place, 5) == at);
                CHECK(index_along<3>(place, 5, 1) == y);
            }
        }
    }
}

TEST_CASE("a place among unequal widths has its index") {
    const Index<3> widths{2, 1, 4};
    CHECK(index_of<3>(0, widths) == Index<3>{0, 0, 0});
    CHECK(index_of<3>(7, widths) == Index<3>{1, 0, 3});
    CHECK(index_of<2>(5, Index<2>{3, 2}) == Index<2>{2, 1});
}

TEST_CASE("the middle of the 3^D neighbours is the thing itself") {
    for (int axis = 0; axis < 2; ++axis) CHECK(neighbour_offset<2>(4, axis) == 0);
    for (int axis = 0; axis < 3; ++axis) CHECK(neighbour_offset<3>(13, axis) == 0);
    CHECK(neighbour_offset<3>(0, 2) == -1);
    CHECK(neighbour_offset<3>(26, 0) == 1);
}
