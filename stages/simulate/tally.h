// What a run took so far, over all processes that went on with it. It travels in the checkpoint, so that a
// run in pieces tells the same as one that was never stopped.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "mpm/state/simulation.h"

namespace tidewater {

// What chooses Δt (mpm/step/time_step.h): that sound, or what moves, crosses only a part of a cell; that what
// falls moves at most 0.4 cells; or that the run ends.
enum class TimeStepLimit { sound_in_water, sound_in_ice, motion, falling, end };
inline constexpr std::array<std::string_view, 5> time_step_limits{"sound_in_water", "sound_in_ice", "motion",
                                                                  "falling", "end"};

// What limits the stable time step; never `end`.
template <int D, class Real>
TimeStepLimit time_step_limit(const mpm::Simulation<D, Real>& simulation);

struct Tally {
    std::string started;         // UTC, of the first process
    std::int64_t processes = 0;  // that have worked on it
    std::vector<std::int64_t> limited = std::vector<std::int64_t>(time_step_limits.size());  // steps by limit
    std::int64_t particle_steps = 0;
    double shortest = std::numeric_limits<double>::infinity(), longest = 0.0, sum = 0.0;  // of Δt, s
    double start_seconds = 0.0, rows_seconds = 0.0, frames_seconds = 0.0,
           checkpoint_seconds = 0.0;                                                   // wall time
    std::vector<double> phase_seconds = std::vector<double>(mpm::phase_names.size());  // likewise
    std::int64_t peak_memory_bytes = 0;                                                // 0: unknown
    std::int64_t checkpoint_bytes = 0;                                                 // of the last one
    std::vector<double> first_ledger_row, last_ledger_row;                             // empty: none yet
    std::string warnings;  // each ends with a line's end

    void add_step(TimeStepLimit limit, double dt, std::size_t particles) {
        ++limited[static_cast<std::size_t>(limit)];
        particle_steps += static_cast<std::int64_t>(particles);
        shortest = std::min(shortest, dt);
        longest = std::max(longest, dt);
        sum += dt;
    }

    template <class Visit>
    void visit(const Visit& visit) {
        visit("started", started);
        visit("processes", processes);
        visit("limited", limited);
        visit("particle_steps", particle_steps);
        visit("shortest", shortest);
        visit("longest", longest);
        visit("sum", sum);
        visit("start_seconds", start_seconds);
        visit("rows_seconds", rows_seconds);
        visit("frames_seconds", frames_seconds);
        visit("checkpoint_seconds", checkpoint_seconds);
        visit("phase_seconds", phase_seconds);
        visit("peak_memory_bytes", peak_memory_bytes);
        visit("checkpoint_bytes", checkpoint_bytes);
        visit("first_ledger_row", first_ledger_row);
        visit("last_ledger_row", last_ledger_row);
        visit("warnings", warnings);
    }
};

}  // namespace tidewater
