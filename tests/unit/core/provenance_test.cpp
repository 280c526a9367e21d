#include "core/provenance.h"

#include <doctest/doctest.h>

#include <vector>

using namespace tidewater;

namespace {

std::string command(const std::vector<const char*>& words) {
    return reproducible_command(static_cast<int>(words.size()), words.data());
}

}  // namespace

TEST_CASE("the command leaves out the folders of the program and of the scene, and no part of a value") {
    CHECK(command({"/opt/bin/tidewater-simulate", "configs/a.toml"}) == "tidewater-simulate a.toml");
    CHECK(command({"x", "--set", "title=a/b", "../c/a.toml"}) == "x --set title=a/b a.toml");
    CHECK(command({"x", "--set=title=a/b", "/a.toml"}) == "x --set=title=a/b a.toml");
}

TEST_CASE("the command leaves out the threads and the folder of the run, in both spellings") {
    CHECK(command({"x", "a.toml", "--threads", "4", "--set", "b=1"}) == "x a.toml --set b=1");
    CHECK(command({"x", "--threads=4", "--run=c", "a.toml"}) == "x a.toml");
    CHECK(command({"x", "a.toml", "--run", "c"}) == "x a.toml");
}

TEST_CASE("the command leaves out from where and until when, so that pieces of a run carry the same one") {
    CHECK(command({"x", "a.toml", "--from", "start", "--until", "3"}) == "x a.toml");
    CHECK(command({"x", "--from=old/checkpoint.h5", "--until=3", "a.toml"}) == "x a.toml");
}

TEST_CASE("the program's fingerprint is that of one file, and does not change while it runs") {
    CHECK(program_fingerprint().size() == 16);
    CHECK(program_fingerprint() == program_fingerprint());
}

TEST_CASE("a command that ends with an option without its value, or is empty, is no trouble") {
    CHECK(command({"x", "--threads"}) == "x");
    CHECK(command({"x", "--set"}) == "x --set");
    CHECK(command({}) == "");
}

TEST_CASE("the fields come in a fixed order") {
    const auto fields = provenance_fields({"program", "1.0", "program a.toml", "00ff", 7});
    const std::vector<std::pair<std::string, std::string>> expected{{"program", "program"},
                                                                    {"version", "1.0"},
                                                                    {"command", "program a.toml"},
                                                                    {"scene_hash", "00ff"},
                                                                    {"seed", "7"}};
    CHECK(fields == expected);
}

TEST_CASE("a line break in a field cannot begin a line of its own") {
    const auto fields = provenance_fields({"p", "1.0", "p a.toml --set title=\"ü\na\r\tb\x7f\"", "00ff", 7});
    CHECK(fields[2].second == "p a.toml --set title=\"ü\\x0aa\\x0d\\x09b\\x7f\"");
}
