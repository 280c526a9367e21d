// Tables of points that a scene names instead of listing them.
#pragma once

#include <filesystem>
#include <vector>

namespace tidewater::scene {

// Reads x0, z0, x1, z1, … from a text of two columns, which blanks, tabs, commas or semicolons divide. Leaves
// out empty lines, comments from '#' on, and a first line of names. Throws InputError if the file cannot be
// read or, with "file:line: …", if a line does not have two numbers.
std::vector<double> read_point_file(const std::filesystem::path& path);

}  // namespace tidewater::scene
