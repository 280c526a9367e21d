// Numbers and names as text, the same in every locale.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace tidewater::io {

// The shortest text that reads back to the same number: "0.1", "1e-09", "nan".
std::string format_number(double value);

// With a fixed number of decimals: format_fixed(2.5, 2) is "2.50"; never "-0.00".
std::string format_fixed(double value, int decimals);

// With so many significant digits, for people: format_digits(0.0012345, 3) is "0.00123", of 1234567
// "1.23e+06".
std::string format_digits(double value, int digits);

// The whole text as a number, blanks around it allowed; nothing if it is not one.
std::optional<double> parse_number(std::string_view text);

// With &, <, >, " and ' replaced, for XML text and attributes.
std::string escape_xml(std::string_view text);

// "frame_0007.hdf" of ("frame", 7, "hdf"): the name of a file of one frame; more digits from frame 10000 on.
std::string numbered_name(std::string_view stem, std::size_t frame, std::string_view extension);

// As base64 (RFC 4648), without line ends.
std::string encode_base64(std::string_view bytes);

}  // namespace tidewater::io
