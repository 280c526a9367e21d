#include "io/text.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace tidewater::io;

TEST_CASE("numbers are written as short as they read back") {
    CHECK(format_number(0.1) == "0.1");
    CHECK(format_number(3.0) == "3");
    CHECK(format_number(-1e-9) == "-1e-09");
    CHECK(format_number(-std::nan("")) == "nan");
}

TEST_CASE("fixed decimals never give a negative zero") {
    CHECK(format_fixed(2.5, 2) == "2.50");
    CHECK(format_fixed(-0.001, 2) == "0.00");
    CHECK(format_fixed(-0.006, 2) == "-0.01");
    CHECK(format_fixed(1e300, 1).size() == 303);
    CHECK(format_fixed(7.6, 0) == "8");
}

TEST_CASE("only a whole number is a number") {
    CHECK(parse_number(" 2.5\t") == 2.5);
    CHECK(std::isnan(parse_number("nan").value()));
    for (const char* text : {"", " ", "2.5m", "2,5", "x", "1 2"}) CHECK_FALSE(parse_number(text).has_value());
}

TEST_CASE("XML's own letters are replaced") {
    CHECK(escape_xml("a < b & \"c\" > 'd' η") == "a &lt; b &amp; &quot;c&quot; &gt; &apos;d&apos; η");
}

TEST_CASE("base64 is that of RFC 4648") {
    CHECK(encode_base64("").empty());
    CHECK(encode_base64("f") == "Zg==");
    CHECK(encode_base64("fo") == "Zm8=");
    CHECK(encode_base64("foo") == "Zm9v");
    CHECK(encode_base64("foobar") == "Zm9vYmFy");
    CHECK(encode_base64("\xff\xfe\xfb") == "//77");
    CHECK(encode_base64(std::string("\0\0\0", 3)) == "AAAA");
}

TEST_CASE("a file of a frame is named by its number") {
    CHECK(numbered_name("frame", 0, "hdf") == "frame_0000.hdf");
    CHECK(numbered_name("a_b", 123, "csv") == "a_b_0123.csv");
    CHECK(numbered_name("frame", 10000, "hdf") == "frame_10000.hdf");
}

TEST_CASE("significant digits are those asked for") {
    CHECK(format_digits(0.0012345, 3) == "0.00123");
    CHECK(format_digits(1234567.0, 3) == "1.23e+06");
    CHECK(format_digits(1234567.0, 6) == "1.23457e+06");
    CHECK(format_digits(-2.0, 3) == "-2");
}
