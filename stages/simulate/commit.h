// Which sources the program was built from.
#pragma once

#include <string>

namespace tidewater {

// The last commit that changed lib, stages or CMakeLists.txt, with "-dirty" behind it where they had been
// changed since; "unknown" if they were not under git. Its source is written by commit.cmake.
std::string source_commit();

}  // namespace tidewater
