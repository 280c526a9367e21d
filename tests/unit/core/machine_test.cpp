#include "core/machine.h"

#include <doctest/doctest.h>

#include <regex>
#include <vector>

TEST_CASE("the machine has cores, and memory that holds this process") {
    const tidewater::Machine machine = tidewater::this_machine();
    CHECK(machine.cores > 0);
    REQUIRE(machine.memory_bytes);
    const auto peak = tidewater::peak_memory_bytes();
    REQUIRE(peak);
    CHECK(*peak > 1'000'000);
    CHECK(*peak < *machine.memory_bytes);
}

TEST_CASE("the peak of memory stays when the memory is given back") {
    const auto before = *tidewater::peak_memory_bytes();
    {
        const std::vector<char> block(200'000'000, 'x');
        const volatile char* seen = block.data();  // else a compiler may do without the block
        CHECK(seen[block.size() - 1] == 'x');
    }
    CHECK(*tidewater::peak_memory_bytes() >= before);
    CHECK(*tidewater::peak_memory_bytes() > 200'000'000);
}

TEST_CASE("now is a time of ISO 8601 in UTC") {
    CHECK(std::regex_match(tidewater::utc_now(), std::regex(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)")));
}
