// Tables of points that a scene names instead of listing them.
#pragma once

#include <filesystem>
#include <vector>

namespace tidewater::scene {

// x0, z0, x1, z1, … from a text of two columns, divided by blanks, tabs, commas or semicolons. Empty lines,
// what follows a '#' and a first line of names are left out. Throws InputError: "file: cannot be read", or
// "file:line: …" where a line has not two numbers.
std::vector<double> read_point_file(const std::filesystem::path& path);

}  // namespace tidewater::scene
