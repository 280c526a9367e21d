#include "scene/text.h"

#include <doctest/doctest.h>

#include <array>
#include <cstdlib>
#include <limits>

using namespace tidewater::scene;

TEST_CASE("numbers print in their shortest form that reads back") {
    CHECK(number_text(0.0) == "0");
    CHECK(number_text(-0.0) == "0");
    CHECK(number_text(16.0) == "16");
    CHECK(number_text(100000.0) == "100000");
    CHECK(number_text(0.01) == "0.01");
    CHECK(number_text(-1.0 / 3.0) == "-0.3333333333333333");
    CHECK(number_text(1e10) == "10000000000");
    CHECK(number_text(1e-7) == "1e-07");
    for (const double hard : {5e-324, std::numeric_limits<double>::max(), 0.1 + 0.2, 1.0 / 3.0, 1e22, 1e23,
                              12345678901234567890.0}) {
        CHECK(std::strtod(number_text(hard).c_str(), nullptr) == hard);
    }
}

TEST_CASE("a large number does not print as digits alone, which TOML would take as an integer") {
    CHECK(number_text(12345678901234567890.0).find('e') != std::string::npos);
}

TEST_CASE("lists print in brackets, empty ones too") {
    CHECK(list_text(std::array{16.0, 0.5}) == "[16, 0.5]");
    CHECK(list_text(std::array<std::string, 2>{"water", "a\"b"}) == "[\"water\", \"a\\\"b\"]");
    CHECK(list_text(std::span<const double>()) == "[]");
}

TEST_CASE("text is quoted with quotes, backslashes and control characters escaped") {
    CHECK(quoted_text("") == "\"\"");
    CHECK(quoted_text("a\"b\\c") == R"("a\"b\\c")");
    CHECK(quoted_text("a\nb\x7f") == R"("a\u000ab\u007f")");
    CHECK(quoted_text("Δx") == "\"Δx\"");
}

TEST_CASE("enumerations read as a sentence does") {
    CHECK(enumeration(std::array<std::string, 1>{"a"}) == "a");
    CHECK(enumeration(std::array<std::string, 2>{"a", "b"}) == "a or b");
    CHECK(enumeration(std::array<std::string, 3>{"a", "b", "c"}, "and") == "a, b and c");
    CHECK(enumeration({}) == "");
}

TEST_CASE("trimming takes blanks off both ends") {
    CHECK(trimmed("  a b\t\r") == "a b");
    CHECK(trimmed("   ") == "");
    CHECK(trimmed("") == "");
}

TEST_CASE("the edit distance counts insertions, removals and replacements") {
    CHECK(edit_distance("kitten", "sitting") == 3);
    CHECK(edit_distance("", "abc") == 3);
    CHECK(edit_distance("abc", "") == 3);
    CHECK(edit_distance("same", "same") == 0);
}

TEST_CASE("the nearest candidate is found by its whole or by its last part, if it is near") {
    const std::array<std::string, 3> keys{"domain.size", "block.size", "water.depth"};
    CHECK(nearest("water.dpeth", keys) == "water.depth");
    CHECK(nearest("blok.size", keys) == "block.size");
    CHECK(nearest("depth", keys) == "water.depth");
    CHECK(nearest("ice.depth", keys) == "water.depth");
    CHECK(nearest("viscosity", keys) == "");
    CHECK(nearest("", keys) == "");
}
