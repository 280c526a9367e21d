#include "core/types.h"

#include <doctest/doctest.h>

using namespace tidewater;

TEST_CASE("every material has a name, and a number that snapshots store") {
    CHECK(material_name(Material::water) == "water");
    CHECK(material_name(Material::ice) == "ice");
    CHECK(material_name(Material::rigid) == "rigid");
    CHECK(static_cast<int>(Material::rigid) == 2);
    CHECK(material_name(static_cast<Material>(9)) == "unknown");
}
