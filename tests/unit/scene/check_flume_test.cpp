#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

namespace {

const std::string flume_scene = R"(effects = ["water", "bed", "piston", "sponge"]
[domain]
size = [20, 2]
cell_size = 0.1
[water]
depth = 1
[bed]
profile = [8, 0, 10, 0.5]
[piston]
height = 0.2
[sponge]
width = 6
[simulate]
end_time = 3
snapshot_interval = 0.5
)";

// What is wrong with the scene after these --set options.
std::string flume_problem(const Sets& sets) { return problem(flume_scene, sets); }

void tells(const Sets& sets, const std::string& what) {
    const std::string line = flume_problem(sets);
    CAPTURE(line);
    CHECK(line.find(what) != std::string::npos);
}

}  // namespace

TEST_CASE("a flume with bed, piston and sponge is in order") { CHECK(flume_problem({}) == ""); }

TEST_CASE("a bed's profile is pairs with rising x inside the tank") {
    tells({"bed.profile=[1, 0, 2]"}, "has 3 numbers; it takes pairs");
    tells({"bed.profile=[4, 0, 4, 1]"}, "x must rise from corner to corner");
    tells({"bed.profile=[4, 0, 5, 2]"}, "outside the tank from 0 m to 2 m");
    tells({"bed.profile=[4, -0.1]"}, "outside the tank from 0 m to 2 m");
    tells({"bed.profile=[0, 1]"}, "1 m is nowhere above the bed");
}

TEST_CASE("a piston's motion needs its own keys and no others") {
    tells({"piston.height=0"}, "missing; motion = \"solitary\" needs it");
    tells({"piston.height=0.8"}, "above which solitary waves break");
    tells({"piston.amplitude=0.1"}, "is not read with motion = \"solitary\"");
    tells({"piston.motion=sine"}, "is not read with motion = \"sine\"");
    tells({"piston.motion=sine", "piston.height=0", "piston.amplitude=0.1"},
          "missing; motion = \"sine\" needs it");
    CHECK(flume_problem(
              {"piston.motion=sine", "piston.height=0", "piston.amplitude=0.1", "piston.period=2"}) == "");
}

TEST_CASE("a sponge and a piston need water, and the sponge leaves room for it") {
    tells({"sponge.width=20"}, "20 m fills the tank, 20 m long");
    tells({"effects=[\"bed\", \"sponge\"]"}, "so there are no waves to take");
    tells({"effects=[\"bed\", \"piston\"]"}, "so there is nothing to make waves in");
}

TEST_CASE("what takes the same place is not named together") {
    tells({"effects=[\"water\", \"bed\", \"shelf\"]", "shelf.length=12", "shelf.height=0.4"},
          "rises to 0.5 m within the shelf");
    tells({"effects=[\"water\", \"piston\", \"push\"]", "push.speed=1"}, "both take the left wall's place");
    tells({"effects=[\"water\", \"sponge\", \"shelf\"]", "shelf.length=15", "shelf.height=0.5"},
          "reaches onto the shelf");
    tells({"effects=[\"water\", \"bed\", \"wave\"]", "wave.height=0.1", "wave.kind=solitary"}, "flat bed");
}
