// The ends of a wave flume: what the piston makes, and what the sponge sends back. Water 1 m deep, sound at
// 30 m/s.
#include <doctest/doctest.h>

#include <initializer_list>

#include "support/wave_tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

TEST_CASE("a sponge of six depths absorbs a solitary wave") {
    const auto echo = test::echo_of(6.0, 12);
    MESSAGE("crest ", 100.0 * echo.crest, " %, trough ", 100.0 * echo.trough, " %, level at the end ",
            100.0 * echo.last, " %, water taken ", 100.0 * echo.taken, " % of the wave's");
    CHECK(echo.crest <= 0.03);
    CHECK(echo.trough >= -0.03);
    CHECK(echo.taken == doctest::Approx(1.0).epsilon(0.05));
}

TEST_CASE("a piston makes solitary waves of the height that was asked for") {
    for (const double height : {0.1, 0.2}) {
        auto s = make_simulation<2, float>(test::piston_start(24.0, 16, {.height = height}, 0.0));
        const auto levels = test::record_levels({10.0}, 0.05, 8.0, s).front();
        const double made = *std::ranges::max_element(levels) - 1.0;
        MESSAGE("asked for ", height, " m, after 10 D ", made, " m: ", 100.0 * (made / height - 1.0), " %");
        CHECK(made == doctest::Approx(height).epsilon(0.05));
    }
}
