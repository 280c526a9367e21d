#include "io/column_map.h"

#include <doctest/doctest.h>

#include "core/error.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

// The line of the SceneError that `work` throws; empty if it throws none.
template <class Work>
std::string scene_error(const Work& work) {
    try {
        work();
    } catch (const SceneError& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("a column is an array, an array for each component, a component of one or a number") {
    const ColumnMap map = parse_column_map("velocity=u:v:w,damage=state[2],volume=0.25,material=water");
    REQUIRE(map.size() == 4);
    const ColumnSource velocity = column_source(map, "velocity");
    REQUIRE(velocity.size() == 3);
    CHECK(velocity[0].array == "u");
    CHECK(velocity[2].array == "w");
    CHECK(velocity[2].component == -1);
    CHECK(column_source(map, "damage")[0].array == "state");
    CHECK(column_source(map, "damage")[0].component == 2);
    CHECK(column_source(map, "volume")[0].array == "0.25");
    CHECK(column_source(map, "material")[0].array == "water");
}

TEST_CASE("a column that is not named is the array of its own name") {
    const ColumnSource source = column_source(parse_column_map("damage=D"), "velocity");
    REQUIRE(source.size() == 1);
    CHECK(source[0].array == "velocity");
}

TEST_CASE("an unknown column is told with those that there are") {
    CHECK(scene_error([] { parse_column_map("vel=v"); })
              .starts_with("--map: \"vel\" is no column; the columns are velocity, pressure, volume, "
                           "material, id, principal_stress, "));
}

TEST_CASE("what is no entry of a map is told") {
    for (const char* text : {"", "velocity", "velocity=", "=v", "velocity=v,", "damage=state[",
                             "damage=state[-1]", "damage=state[1.5]", "damage=[1]",
                             "velocity=u:", "velocity=a:b:c:d", "damage=a:b", "damage=a,damage=b"}) {
        CAPTURE(text);
        CHECK(scene_error([&] { parse_column_map(text); }).starts_with("--map: "));
    }
}

TEST_CASE("materials are known by the numbers that another program gave them") {
    const MaterialNumbers numbers = parse_material_numbers("water=3,ice=1,ice=-2");
    CHECK(numbers.at(3) == Material::water);
    CHECK(numbers.at(1) == Material::ice);
    CHECK(numbers.at(-2) == Material::ice);
    for (const char* text : {"snow=1", "water=x", "water=1.5", "water=1,ice=1", "water"}) {
        CAPTURE(text);
        CHECK(scene_error([&] { parse_material_numbers(text); }).starts_with("--materials: "));
    }
}
