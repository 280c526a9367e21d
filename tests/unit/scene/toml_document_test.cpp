#include "scene/toml_document.h"

#include <doctest/doctest.h>

using namespace tidewater::scene;

TEST_CASE("entries come in the order of the text with their sections and lines") {
    const Document document = parse_toml("b = 1\n[z]\ny = 2.5\n\n[a]\nx = \"t\"\n");
    REQUIRE(document.entries.size() == 3);
    CHECK(document.entries[0].key == "b");
    CHECK(document.entries[1].key == "z.y");
    CHECK(document.entries[2].key == "a.x");
    CHECK(document.entries[2].line == 6);
    CHECK(std::get<double>(document.entries[1].value) == 2.5);
    CHECK(document.readable);
}

TEST_CASE("an empty text is an empty document") {
    CHECK(parse_toml("").entries.empty());
    CHECK(parse_toml("# nothing\n[section]\n").entries.empty());
    CHECK(parse_toml("").readable);
}

TEST_CASE("values are described for messages") {
    CHECK(describe(parse_value("3")) == "3");
    CHECK(describe(parse_value("3.50")) == "3.5");
    CHECK(describe(parse_value("abc")) == "text \"abc\"");
    CHECK(describe(parse_value("[]")) == "an empty list");
    CHECK(describe(parse_value("[1]")) == "a list of 1 number");
    CHECK(describe(parse_value("[\"a\", \"b\"]")) == "a list of 2 words");
    CHECK(describe(parse_value("[[1], [2]]")) == "a list of 2 points");
    CHECK(describe(parse_value("[1, [2, 3]]")) == "a list of 2 points");
    CHECK(describe(parse_value("[[1], true]")) == "a list of other things");
    CHECK(describe(parse_value("[[[1]], [2]]")) == "a list of other things");
    CHECK(describe(parse_value("[{a = 1}]")) == "a list of sections");
    CHECK(describe(parse_value("true")) == "true");
    CHECK(describe(parse_value("07:32:00")) == "a date or time");
}

TEST_CASE("integers and numbers mix in a list") {
    CHECK(std::get<std::vector<double>>(parse_value("[1, 2.5]")) == std::vector<double>{1.0, 2.5});
}

TEST_CASE("what is not a TOML value is text") {
    CHECK(std::get<std::string>(parse_value("a b")) == "a b");
    CHECK(std::get<std::string>(parse_value("1 # one\n x = 2")) == "1 # one\n x = 2");
    CHECK(std::get<std::string>(parse_value("{a = 1}")) == "{a = 1}");
    CHECK(std::get<std::string>(parse_value("")) == "");
}

TEST_CASE("reading goes on after duplicate keys and values without quotes") {
    const Document document = parse_toml("a = 1\nb = word # why\na = 2\n[s]\nc = 1\nc = 2\nd = 4\n");
    CHECK(document.readable);
    REQUIRE(document.problems.size() == 2);
    CHECK(document.problems[0].line == 3);
    CHECK(document.problems[1].text == "s.c: duplicate key; keep one of them");
    REQUIRE(document.entries.size() == 4);
    CHECK(std::get<std::int64_t>(document.entries[0].value) == 1);
    CHECK(describe(document.entries[1].value) == "word, which is not a TOML value (text needs quotes)");
    CHECK(document.entries[3].key == "s.d");
}

TEST_CASE("reading ends where taking out a line could change what the others mean") {
    for (const char* text :
         {"a = [1,\n2\nb = 3\n", "a = \"open\n", "[s]\na = 1\n[t]\n[s]\nb = 1\n", "= 1\n", "a\n"}) {
        const Document document = parse_toml(text);
        CHECK_MESSAGE(!document.readable, text);
        CHECK_MESSAGE(document.problems.size() == 1, text);
    }
}

TEST_CASE("a list that spans lines and is given twice ends the reading, and does not hang") {
    CHECK_FALSE(parse_toml("a = 1\na = [1,\n2]\n").readable);
    CHECK_FALSE(parse_toml("a = [x,\ny]\n").readable);
}
