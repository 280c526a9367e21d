// printf into a string, for lines of the log.
#pragma once

#include <cstdio>
#include <string>

namespace tidewater {

template <class... Values>
std::string format(const char* pattern, Values... values) {
    char text[512];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

}  // namespace tidewater
