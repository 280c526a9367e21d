// printf into a string, for lines of the log. Compilers check the values against the pattern.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <string>

namespace tidewater {

[[gnu::format(printf, 1, 2)]] inline std::string format(const char* pattern, ...) {
    char text[512];
    std::va_list values;
    va_start(values, pattern);
    std::vsnprintf(text, sizeof text, pattern, values);
    va_end(values);
    return text;
}

}  // namespace tidewater
