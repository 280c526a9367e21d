#include "core/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace tidewater {

bool progress_due(const ProgressTold& told, bool terminal, double seconds, double done, double fraction) {
    if (terminal) return seconds - told.seconds > 0.1 || fraction >= 1.0;
    constexpr double settled = 1.0;  // s, until which a rate is no rate
    const bool first_left = !told.left && fraction > done && seconds > settled;
    return std::floor(10.0 * fraction) > told.tenth || first_left || seconds - told.seconds > 600.0;
}

Progress::Progress(std::string what)
    : what_(std::move(what)), start_(Clock::now()), terminal_(::isatty(STDERR_FILENO) == 1) {}

void Progress::update(double fraction, const std::string& note) {
    const double seconds = elapsed();
    if (!progress_due(told_, terminal_, seconds, done_, fraction)) return;
    told_ = {.seconds = seconds,
             .tenth = static_cast<int>(std::floor(10.0 * fraction)),
             .left = told_.left || fraction > done_};
    char percent[16];
    std::snprintf(percent, sizeof percent, "%3.0f %%, ", std::floor(100.0 * std::min(fraction, 1.0)));
    draw(percent + format_duration(seconds) + " elapsed, " + remaining_text(seconds, done_, fraction) +
         (note.empty() ? "" : ", ") + note);
}

void Progress::prepare(const std::string& note) {
    const double seconds = elapsed();
    if (!progress_due(told_, terminal_, seconds, 0.0, 0.0)) return;
    told_ = {.seconds = seconds, .tenth = 0};
    draw(format_duration(seconds) + " elapsed, " + note);
}

void Progress::begin(double done) {
    done_ = done;
    start_ = Clock::now();
    told_ = {};
}

void Progress::draw(const std::string& text) {
    std::fprintf(stderr, "%s%s: %s%s", terminal_ ? "\r\033[K" : "", what_.c_str(), text.c_str(),
                 terminal_ ? "" : "\n");
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
