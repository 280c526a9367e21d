// Progress of long work on standard error: one line that is redrawn on a terminal, else one plain line per 10
// %.
#pragma once

#include <chrono>
#include <string>

namespace tidewater {

class Progress {
public:
    // `what` leads every line, e.g. "simulate". `done` is the fraction that was done before, in another
    // process: the remaining time is told from what is done since.
    explicit Progress(std::string what, double done = 0.0);

    // fraction in [0, 1] of the work done; note is appended, e.g. "t = 1.20 s". Cheap to call often.
    void update(double fraction, const std::string& note = {});

    // Ends the terminal's line. Called by the destructor too.
    void finish();
    ~Progress() { finish(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

private:
    using Clock = std::chrono::steady_clock;
    std::string what_;
    double done_;
    Clock::time_point start_;
    Clock::time_point last_draw_;
    int last_tenth_ = -1;
    bool terminal_;
    bool drawn_ = false;
};

// "12 s left" from the seconds that it took to get from the fraction `done` to `fraction`; "estimating" until
// there is something to tell it from.
std::string remaining_text(double seconds, double done, double fraction);

// "1 h 02 min", "3 min 20 s" or "12 s".
std::string format_duration(double seconds);

}  // namespace tidewater
