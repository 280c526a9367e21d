// SIGTERM and SIGINT as a wish to stop, so that a run can finish its step and write a checkpoint.
#pragma once

#include <signal.h>

#include <array>
#include <string_view>

namespace tidewater {

// While it lives, the first of these signals is only noted. Process groups, make and batch systems often send
// it several times at once; one that comes a second later or more ends the program at once, as without us. A
// signal that the parent process had us ignore stays ignored. One object at a time.
class StopWish {
public:
    StopWish();
    ~StopWish();
    StopWish(const StopWish&) = delete;
    StopWish& operator=(const StopWish&) = delete;

    // The signal that came, 0 if none.
    int signal() const;

private:
    static constexpr std::array<int, 2> signals{SIGINT, SIGTERM};
    std::array<struct sigaction, signals.size()> before_{};
};

// "SIGTERM"
std::string_view signal_name(int signal);

}  // namespace tidewater
