// A simulation on its way from the start or a checkpoint to the end, to --until or to a signal.
#pragma once

#include "checkpoint.h"
#include "core/progress.h"
#include "facts.h"
#include "log.h"
#include "records.h"
#include "schedule.h"
#include "stop.h"

namespace tidewater {

template <int D, class Real>
class Run {
public:
    // `earlier` is what a checkpoint held.
    Run(const StageContext& context, mpm::Simulation<D, Real>& simulation, Checkpoint& checkpoint,
        Records<D, Real>& records, Facts<D, Real>& facts, Log& log, const RunState& earlier);

    // False if --until ended it. Throws an Error with the exit code 128 + the signal if that did.
    bool to_end();

private:
    void settle(const StopWish& wish);
    void step(double end);
    Reading<D> read();
    void write_rows(const Reading<D>& before, bool ended);
    void write_frame_if_due(bool ended);
    void save_if_due();
    void save();
    [[noreturn]] void stop(int signal);
    void say(const std::string& line);

    const scene::Scene& scene_;
    const scene::Scene::Simulate& simulate_;
    double until_;
    mpm::Simulation<D, Real>& s_;
    Checkpoint& checkpoint_;
    Records<D, Real>& records_;
    Facts<D, Real>& facts_;
    Log& log_;
    Schedule rows_, frames_;
    Progress progress_;
    std::optional<Reading<D>> reading_;  // of the present state, if it was taken
    Clock::time_point last_save_ = Clock::now();
};

}  // namespace tidewater
