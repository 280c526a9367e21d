#include "core/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace tidewater {

Progress::Progress(std::string what, double done)
    : what_(std::move(what)),
      done_(done),
      start_(Clock::now()),
      last_draw_(start_ - std::chrono::hours(1)),
      terminal_(::isatty(STDERR_FILENO) == 1) {}

void Progress::update(double fraction, const std::string& note) {
    const auto now = Clock::now();
    const int tenth = static_cast<int>(std::floor(10.0 * fraction));
    const bool due = terminal_ ? now - last_draw_ > std::chrono::milliseconds(100) || fraction >= 1.0
                               : tenth > last_tenth_;
    if (!due) return;
    last_draw_ = now;
    last_tenth_ = tenth;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const std::string left = remaining_text(elapsed, done_, fraction);
    std::fprintf(stderr, "%s%s: %3.0f %%, %s elapsed, %s%s%s%s", terminal_ ? "\r\033[K" : "", what_.c_str(),
                 std::floor(100.0 * std::min(fraction, 1.0)), format_duration(elapsed).c_str(), left.c_str(),
                 note.empty() ? "" : ", ", note.c_str(), terminal_ ? "" : "\n");
    std::fflush(stderr);
    drawn_ = true;
}

void Progress::finish() {
    if (terminal_ && drawn_) std::fputc('\n', stderr);
    drawn_ = false;
}

std::string remaining_text(double seconds, double done, double fraction) {
    if (fraction <= done) return "estimating";
    return format_duration(seconds * (1.0 - fraction) / (fraction - done)) + " left";
}

std::string format_duration(double seconds) {
    const long whole = std::lround(std::max(seconds, 0.0));
    char text[64];
    if (whole >= 3600) {
        std::snprintf(text, sizeof text, "%ld h %02ld min", whole / 3600, whole % 3600 / 60);
    } else if (whole >= 60) {
        std::snprintf(text, sizeof text, "%ld min %02ld s", whole / 60, whole % 60);
    } else {
        std::snprintf(text, sizeof text, "%ld s", whole);
    }
    return text;
}

}  // namespace tidewater
