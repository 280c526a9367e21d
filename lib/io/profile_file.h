// Heights along a line from a text file: two columns, x and z in m.
#pragma once

#include <filesystem>
#include <vector>

namespace tidewater::io {

struct ProfileTable {
    std::vector<double> x, z;  // m; x rises
};

// One point per line, separated by a comma, a semicolon, blanks or tabs. What follows a # is a comment, empty
// lines do not count, and the first line may name the columns. With semicolons or blanks between, a comma
// may not stand for a decimal point. Throws InputError, with file:line, if a line is not two finite numbers
// or x does not rise, and with the file if it is missing or has fewer than two points. Test:
// tests/unit/io/profile_file_test.cpp.
ProfileTable read_profile(const std::filesystem::path& path);

}  // namespace tidewater::io
