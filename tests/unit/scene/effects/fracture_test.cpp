#include <doctest/doctest.h>

#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;

TEST_CASE("an effect that has nothing to act on is told") {
    CHECK(problem(block_scene, {"effects=[\"water\", \"rigid\", \"fracture\"]"}) ==
          "--set effects=[\"water\", \"rigid\", \"fracture\"]: names \"fracture\" but not \"ice\", so there "
          "is nothing "
          "that could fracture; add \"ice\" or remove \"fracture\"");
}

TEST_CASE("a crack band needs its energy, and ice that would snap is told") {
    CHECK(set_problem("fracture.softening=\"crack_band\"", slab_scene).find("fracture.energy: missing") !=
          std::string::npos);
    const auto band =
        read_text_as_scene(slab_scene, {"fracture.softening=\"crack_band\"", "fracture.energy=2000"});
    const auto twice =
        read_text_as_scene(slab_scene, {"fracture.softening=\"crack_band\"", "fracture.energy=4000"});
    CHECK(ice_model(band).hardening == doctest::Approx(2 * ice_model(twice).hardening));
    CHECK(ice_model(read_text_as_scene(slab_scene)).hardening == 3.0);
    const auto snaps = scene_warnings(read_text_as_scene(slab_scene, {"fracture.beta=0.5"}));
    REQUIRE(!snaps.empty());
    CHECK(snaps[0].find("βξ = 1.5") != std::string::npos);
}

TEST_CASE("an energy that is not read and a strength beyond the surface's tip are told") {
    CHECK(set_problem("fracture.energy=800", slab_scene).find("is not read with softening") !=
          std::string::npos);
    CHECK(set_problem("ice.youngs_modulus=1e7", slab_scene).find("fracture.strength: over fracture.beta") !=
          std::string::npos);
}
