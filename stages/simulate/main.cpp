// tidewater-simulate: particles from <run>/geometry/geometry.vdb, stepped to simulate.end_time; results in
// <run>/simulate. A run that was stopped goes on from its checkpoint.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <utility>

#include "checkpoint.h"
#include "common/stage.h"
#include "core/error.h"
#include "core/progress.h"
#include "format.h"
#include "log.h"
#include "records.h"
#include "run.h"
#include "start.h"

namespace tidewater {
namespace {

template <int D, class Real>
void log_summary(const mpm::Simulation<D, Real>& s, const Records<D, Real>& records, double seconds,
                 long first_step, Log& log) {
    const long steps = s.step - first_step;
    const double work = static_cast<double>(s.particle_count()) * static_cast<double>(steps);
    log.line(format("%zu particles, %ld steps in %.1f s: %.3g million particle-steps/s", s.particle_count(),
                    steps, seconds, 1e-6 * work / seconds));
    double total = 0.0;
    for (const double phase : s.seconds) total += phase;
    std::string shares = "time in the step:";
    for (std::size_t phase = 0; phase < s.seconds.size(); ++phase) {
        shares += format(" %s %.0f %%", std::string(mpm::phase_names[phase]).c_str(),
                         100.0 * s.seconds[phase] / total);
    }
    log.line(shares +
             format("; %.0f %% of the run went into output", 100.0 * std::max(0.0, 1.0 - total / seconds)));
    log.line(
        format("ledger: energy %.6g J at the start, %+.3g J since, at most %+.3g J above it; momentum open "
               "by %.2g kg m/s of %.3g",
               records.start_energy(), records.energy() - records.start_energy(),
               records.highest_energy() - records.start_energy(), records.momentum_residual(),
               std::abs(s.accounts.gravity_impulse)));
}

// Runs what start or checkpoint gave; the records begin anew or go on likewise.
template <int D, class Real>
void run_simulation(const StageContext& context, mpm::Simulation<D, Real>& s, Checkpoint& checkpoint,
                    const RunState& earlier, Log& log, Clock::time_point started) {
    log.line(format("%zu particles in %zu blocks, %dD, %s, cell size %g m", s.particle_count(),
                    s.grid.particle_blocks.size(), D, sizeof(Real) == 4 ? "float" : "double",
                    context.scene.domain.cell_size));
    const long first_step = s.step;
    Records<D, Real> records(context.scene, read_ground(context.scene, geometry_file(context)),
                             context.folder, context.provenance);
    if (earlier.begun()) records.resume(earlier);
    Run<D, Real> run(context, s, checkpoint, records, log, earlier, started);
    try {
        if (!run.to_end()) {
            records.keep_parts();
            log.line(format("stopped by --until at t = %.6g s, step %ld", s.time, s.step) +
                     "; the same command goes on from " + checkpoint.path().string());
            return log.finish();
        }
    } catch (const NumericsError&) {
        records.keep_parts();  // the curves up to here tell what went wrong
        throw;
    }
    log_summary(s, records, seconds_since(started), first_step, log);
    log.finish();
    records.finish();
    checkpoint.remove();
}

// The simulation at t = 0, and the fingerprint of what it was made from.
template <int D, class Real>
std::pair<mpm::Simulation<D, Real>, std::string> begin(const StageContext& context) {
    auto start = make_start<D>(context.scene, geometry_file(context));
    const std::string fingerprint = start_fingerprint(start);
    return {mpm::make_simulation<D, Real>(std::move(start)), fingerprint};
}

template <int D, class Real>
void simulate(StageContext& context) {
    const auto started = Clock::now();
    auto [s, fingerprint] = begin<D, Real>(context);
    Checkpoint checkpoint(context, fingerprint);
    RunState earlier;
    if (const auto found = checkpoint.find(); !found.empty()) {
        earlier = checkpoint.load(found, s);
        remove_later_records(context.folder, earlier.frame_times.size());
    } else {
        remove_old_records(context.folder);
    }
    write_resolved_scene(context);
    Log log(context.folder, earlier.begun());
    try {
        if (!checkpoint.note().empty()) log.line(checkpoint.note());
        run_simulation(context, s, checkpoint, earlier, log, started);
    } catch (const Error& error) {
        const std::string line = error.what() + checkpoint.last_good(error);
        log.quiet_line(line);  // the stage says it on standard error
        log.finish();
        throw Error(error.code(), line);
    }
}

void simulate_scene(StageContext& context) {
    const bool single = context.scene.simulate.precision == scene::Precision::single_precision;
    if (context.scene.dimension == 2) {
        single ? simulate<2, float>(context) : simulate<2, double>(context);
    } else {
        single ? simulate<3, float>(context) : simulate<3, double>(context);
    }
}

}  // namespace
}  // namespace tidewater

int main(int argc, char** argv) {
    using namespace tidewater;
    return run_stage(argc, argv, scene::Stage::simulate,
                     "Steps the scene's particles through time; writes snapshots, gauges and the ledger.",
                     simulate_scene);
}
