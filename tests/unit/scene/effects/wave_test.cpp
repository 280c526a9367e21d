#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

TEST_CASE("a wave needs open water, a length that the tank holds and a height within its theory") {
    const std::string standing = R"(effects = ["water", "wave"]
domain.size = [4, 2]
domain.cell_size = 0.05
water.depth = 1
wave.height = 0.1
wave.length = 8
simulate.end_time = 10
simulate.snapshot_interval = 0.1
)";
    const auto told = [&](const Sets& sets) {
        const std::string text = problem(standing, sets);
        return text.substr(text.find(": ") + 2);
    };
    const Sets solitary{"wave.kind=\"solitary\"", "wave.length=0", "wave.center=2"};
    CHECK(problem(standing) == "");
    CHECK(problem(standing, solitary) == "");
    CHECK(problem(standing, {"wave.length=4"}) == "");
    CHECK(told({"wave.length=5"}) ==
          "5 m: the tank of 4 m holds no whole number of halves of it; the nearest length is 4 m");
    CHECK(told({"wave.length=0"}) == "missing; a standing wave needs its length, e.g. length = 8 (m)");
    CHECK(told({"wave.center=1"}) == "is not read with kind = \"standing\"; remove it");
    CHECK(told({"wave.height=0.6"}) ==
          "0.6 m is more than 0.5 of the water's depth, up to which the theory holds; lower it to 0.5 m");
    CHECK(told({"domain.size=[4, 1.05]"}).find("the crest at 1.1 m is above the tank's top at 1.05 m") !=
          std::string::npos);
    CHECK(told({"water.length=3"}) == "3 m is not the whole tank, which a wave needs; remove it");
    CHECK(told({"domain.gravity=0"}).starts_with("0 m/s² makes no waves"));
    CHECK(
        problem(standing, {solitary[0], solitary[1], "wave.center=5"}).find("beyond the tank's end at 4 m") !=
        std::string::npos);
    CHECK(problem(block_scene,
                  {"effects=[\"water\", \"rigid\", \"wave\"]", "wave.height=0.1", "wave.length=32"})
              .find("names \"wave\" and \"rigid\"") != std::string::npos);
}

TEST_CASE("a wave starts on a flat bed") {
    tells(flume_scene, {"effects=[\"water\", \"bed\", \"wave\"]", "wave.height=0.1", "wave.kind=solitary"},
          "flat bed");
}
