// tidewater-simulate: particles from <run>/geometry/geometry.vdb, stepped to simulate.end_time; results in
// <run>/simulate. A run that was stopped goes on from its checkpoint.
#include <exception>
#include <utility>

#include "checkpoint.h"
#include "common/stage.h"
#include "core/error.h"
#include "facts.h"
#include "format.h"
#include "io/run_facts.h"
#include "log.h"
#include "records.h"
#include "run.h"
#include "start.h"

namespace tidewater {
namespace {

void log_summary(const io::RunFacts& facts, Log& log) {
    log.line(std::to_string(facts.particle_count()) + " particles, " + io::cost_text(facts));
    log.line("time went into: " + io::time_shares_text(facts));
    for (const auto& [what, key] :
         {std::pair{"rows", "simulate.gauge_interval"}, {"frames", "simulate.snapshot_interval"}}) {
        const double share = facts.seconds_of(what) / facts.total_seconds();
        if (share <= 0.1) continue;
        log.line(format("%s took %.0f %% of the time; a longer %s costs less and changes nothing else", what,
                        100.0 * share, key));
    }
    log.line("time step: " + io::time_step_text(facts) + "; limited by " + io::limited_by_text(facts));
    log.line("ledger: " + io::ledger_text(facts));
}

// How run.json tells of an error that ends the run.
template <int D, class Real>
void write_end(const Facts<D, Real>& facts, const std::exception& error) {
    const auto* ours = dynamic_cast<const Error*>(&error);
    constexpr int first_signal = 128;
    const bool stopped = ours != nullptr && static_cast<int>(ours->code()) > first_signal;
    try {
        facts.write(stopped ? "stopped" : "failed", error.what());
    } catch (const OutputError&) {  // the error itself is told, and says more
    }
}

// Runs what start or checkpoint gave; the records begin anew or go on likewise.
template <int D, class Real>
void run_simulation(const StageContext& context, mpm::Simulation<D, Real>& s, Checkpoint& checkpoint,
                    const RunState& earlier, Log& log, Clock::time_point started) {
    Records<D, Real> records(context.scene, read_ground(context.scene, geometry_file(context)),
                             context.folder, context.provenance);
    if (earlier.begun()) records.resume(earlier);
    Facts<D, Real> facts(context, s, records, earlier, started);
    log.line(io::particles_text(facts.write("running")));
    Run<D, Real> run(context, s, checkpoint, records, facts, log, earlier);
    try {
        if (!run.to_end()) {
            records.keep_parts();
            const std::string line = format("stopped by --until at t = %.6g s, step %ld", s.time, s.step);
            log.line(line + "; the same command goes on from " + checkpoint.path().string());
            facts.write("stopped", line);
            return log.finish();
        }
        log_summary(facts.write("complete"), log);
        log.finish();
        records.finish();
        checkpoint.remove();
    } catch (const std::exception& error) {
        // After an error of numerics the curves up to here tell what went wrong.
        if (dynamic_cast<const NumericsError*>(&error) != nullptr) records.keep_parts();
        write_end(facts, error);
        throw;
    }
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
