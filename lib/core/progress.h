// Progress of long work on standard error: one line that is redrawn on a terminal. Elsewhere a plain line at
// the start, another as soon as the remaining time can be told, then one per 10 % or 10 minutes.
#pragma once

#include <chrono>
#include <string>

namespace tidewater {

// What was told last.
struct ProgressTold {
    double seconds = -1e9;  // when, since the work began
    int tenth = -1;         // of the work, that was done
    bool left = false;      // whether the remaining time could be told
};

// Whether it is time to tell more, after so many seconds of work that began with the fraction `done`.
bool progress_due(const ProgressTold& told, bool terminal, double seconds, double done, double fraction);

class Progress {
public:
    // `what` leads every line, e.g. "simulate". The work begins now; begin() says if it does not.
    explicit Progress(std::string what);

    // fraction in [0, 1] of the work done; note is appended, e.g. "t = 1.20 s". Cheap to call often.
    void update(double fraction, const std::string& note = {});

    // The same for work before that, whose end is not known; nothing is told but the note.
    void prepare(const std::string& note);
    // The work begins only now, with the fraction `done` of it done before, say in another process: the
    // remaining time is told from what is done from now on.
    void begin(double done);

    // Ends the terminal's line. Called by the destructor too.
    void finish();
    ~Progress() { finish(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

private:
    using Clock = std::chrono::steady_clock;
    double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    void draw(const std::string& text);

    std::string what_;
    double done_ = 0.0;  // when it began
    Clock::time_point start_;
    ProgressTold told_;
    bool terminal_;
    bool drawn_ = false;
};

// "12 s left" from the seconds that it took to get from the fraction `done` to `fraction`; "estimating" until
// there is something to tell it from.
std::string remaining_text(double seconds, double done, double fraction);

// "1 h 02 min", "3 min 20 s" or "12 s".
std::string format_duration(double seconds);

}  // namespace tidewater
