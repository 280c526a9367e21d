// One row of the benchmark.
#pragma once

#include <string>

#include "cases.h"

namespace tidewater::benchmark {

struct Job {
    Case what;
    std::string precision;  // float or double
    int threads = 0;        // 0: all cores
    long particles = 0;     // about so many
    int steps = 0;
    int repeat = 1;  // the fastest of so many counts
};

// The names of the columns.
std::string header();

// Runs a case and returns its row. Its memory is what the process grows by, so each row needs a fresh
// process.
std::string measure(const Job& job);

}  // namespace tidewater::benchmark
