// run.json: what this run is, what it took so far and how it ends (io/run_facts.h).
#pragma once

#include <chrono>
#include <string>

#include "checkpoint.h"
#include "io/run_facts.h"
#include "records.h"
#include "tally.h"

namespace tidewater {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start);

template <int D, class Real>
class Facts {
public:
    // `earlier` is what a checkpoint held; wall time counts from `started` on. The simulation and the records
    // are looked at whenever the facts are asked for.
    Facts(const StageContext& context, const mpm::Simulation<D, Real>& simulation,
          const Records<D, Real>& records, const RunState& earlier, Clock::time_point started);

    Tally& tally() { return tally_; }

    // What a checkpoint needs: the tally and the wall time spent so far.
    void store(RunState& run) const;

    // Replaces run.json and returns what it tells. Throws OutputError.
    io::RunFacts write(const std::string& state, const std::string& reason = {}) const;

private:
    double total_seconds() const;
    io::RunFacts now(const std::string& state, const std::string& reason) const;

    const StageContext& context_;
    const mpm::Simulation<D, Real>& s_;
    const Records<D, Real>& records_;
    Clock::time_point started_;
    double earlier_seconds_;
    double went_on_from_;  // s, simulated; NaN: this process began the run
    Tally tally_;
};

}  // namespace tidewater
