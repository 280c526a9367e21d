// tidewater-simulate: particles from <run>/geometry/geometry.vdb, stepped to simulate.end_time; results in
// <run>/simulate.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "common/stage.h"
#include "core/error.h"
#include "core/progress.h"
#include "log.h"
#include "records.h"
#include "start.h"

namespace tidewater {
namespace {

template <class... Values>
std::string format(const char* pattern, Values... values) {
    char text[512];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

// Times to the nanosecond, so that the ends of 30 intervals of 0.01 s and of 6 of 0.05 s are the same number.
double rounded(double time) { return std::round(time * 1e9) / 1e9; }

// n · interval for n = 0, 1, 2 …: the times at which something is written.
class Schedule {
public:
    explicit Schedule(double interval) : interval_(interval) {}
    double next() const { return rounded(static_cast<double>(count_) * interval_); }
    bool due(double time) {
        if (time < next()) return false;
        ++count_;
        return true;
    }

private:
    double interval_;
    long count_ = 0;
};

template <int D, class Real>
std::string time_step_line(const mpm::Simulation<D, Real>& s) {
    const auto& speeds = s.speeds;
    const double sum = speeds.sound + speeds.particle;
    const double step = mpm::stable_time_step(s);
    if (sum == 0.0 || step < s.parameters.cfl * s.grid.layout.cell_size / sum)
        return format("dt %.3g s, limited by gravity (a fall from rest)", step);
    return format("dt %.3g s = %g x %g m / (sound %.4g m/s + particles %.3g m/s), limited by %s (%.0f %%)",
                  step, s.parameters.cfl, s.grid.layout.cell_size, speeds.sound, speeds.particle,
                  speeds.sound >= speeds.particle ? "the sound speed" : "the fastest particle",
                  100.0 * std::max(speeds.sound, speeds.particle) / sum);
}

// Advances to exactly `target` by one step of several equal ones.
template <int D, class Real>
void step_towards(mpm::Simulation<D, Real>& s, double target) {
    const double left = target - s.time;
    const double steps = std::max(1.0, std::ceil(left / mpm::stable_time_step(s)));
    mpm::advance(s, left / steps);
    if (steps == 1.0) s.time = target;
}

template <int D, class Real>
void run_to_end(const scene::Scene& scene, mpm::Simulation<D, Real>& s, Records<D, Real>& records, Log& log) {
    Schedule frames(scene.simulate.snapshot_interval), rows(scene.simulate.gauge_interval);
    Progress progress("simulate");
    const double end = rounded(scene.simulate.end_time);
    for (;;) {
        const bool ended = s.time >= end;
        if (rows.due(s.time) || ended) records.append_row(s);
        if (frames.due(s.time) || ended) {
            records.write_frame(s);
            progress.finish();
            log.line(format("t %.4g s, step %ld, frame %zu: ", s.time, s.step, records.frame_count() - 1) +
                     time_step_line(s));
        }
        if (ended) return;
        progress.update(s.time / end, format("t = %.3f s of %g s", s.time, end));
        step_towards(s, std::min({frames.next(), rows.next(), end}));
    }
}

template <int D, class Real>
void log_summary(const mpm::Simulation<D, Real>& s, const Records<D, Real>& records, double seconds,
                 Log& log) {
    const double work = static_cast<double>(s.particle_count()) * static_cast<double>(s.step);
    log.line(format("%zu particles, %ld steps in %.1f s: %.3g million particle-steps/s", s.particle_count(),
                    s.step, seconds, 1e-6 * work / seconds));
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
               std::abs(s.gravity_impulse)));
}

template <int D, class Real>
void simulate(StageContext& context) {
    const scene::Scene& scene = context.scene;
    const auto started = std::chrono::steady_clock::now();
    auto s = mpm::make_simulation<D, Real>(make_start<D>(scene, context.run / "geometry" / "geometry.vdb"));
    remove_old_records(context.folder);
    write_resolved_scene(context);
    Log log(context.folder);
    try {
        log.line(format("%zu particles in %zu blocks, %dD, %s, cell size %g m", s.particle_count(),
                        s.grid.particle_blocks.size(), D, sizeof(Real) == 4 ? "float" : "double",
                        scene.domain.cell_size));
        Records<D, Real> records(scene, context.folder, context.provenance);
        run_to_end(scene, s, records, log);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - started;
        log_summary(s, records, seconds.count(), log);
        log.finish();
        records.finish();
    } catch (const Error& error) {
        log.quiet_line(std::string("stopped: ") + error.what());  // the stage says it on standard error
        log.finish();
        throw;
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
