#include "core/hash.h"

#include <doctest/doctest.h>

using namespace tidewater;

TEST_CASE("hashes are those of the published FNV-1a test vectors") {
    CHECK(hash_text("") == 0xcbf29ce484222325ULL);
    CHECK(hash_text("a") == 0xaf63dc4c8601ec8cULL);
    CHECK(hash_text("foobar") == 0x85944171f73967e8ULL);
}

TEST_CASE("hashing in pieces gives the hash of the whole") {
    CHECK(hash_text("glacier", hash_text("tidewater ")) == hash_text("tidewater glacier"));
    CHECK(hash_text("", hash_text("ice")) == hash_text("ice"));
}

TEST_CASE("a hash prints as sixteen hexadecimal digits") {
    CHECK(hash_hex(0) == "0000000000000000");
    CHECK(hash_hex(hash_text("a")) == "af63dc4c8601ec8c");
    CHECK(hash_hex(~0ULL) == "ffffffffffffffff");
}
