#include "run.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "format.h"
#include "mpm/step/settle.h"
#include "mpm/step/step.h"

namespace tidewater {
namespace {

const char* limit_words(TimeStepLimit limit) {
    if (limit == TimeStepLimit::motion) return "the fastest particle";
    return limit == TimeStepLimit::sound_in_ice ? "the sound speed of ice" : "the sound speed of water";
}

template <int D, class Real>
std::string time_step_line(const mpm::Simulation<D, Real>& s) {
    const mpm::Signal& signal = s.speeds.signal;
    const double step = mpm::stable_time_step(s);
    const TimeStepLimit limit = time_step_limit(s);
    if (limit == TimeStepLimit::falling)
        return format("dt %.3g s, in which nothing moves or falls by more than 0.4 cells", step);
    return format("dt %.3g s = %g x %g m / (sound %.4g m/s + particles %.3g m/s), limited by %s (%.0f %%)",
                  step, s.parameters.cfl, s.grid.layout.cell_size, signal.sound, signal.motion,
                  limit_words(limit), 100.0 * std::max(signal.sound, signal.motion) / signal.speed());
}

// `time`, or the end of a run if it is that but for rounding.
double snapped(double time) { return std::abs(time - rounded(time)) < 1e-13 * time ? rounded(time) : time; }

}  // namespace

template <int D, class Real>
Run<D, Real>::Run(const StageContext& context, mpm::Simulation<D, Real>& simulation, Checkpoint& checkpoint,
                  Records<D, Real>& records, Facts<D, Real>& facts, Log& log, const RunState& earlier)
    : scene_(context.scene),
      simulate_(context.scene.simulate),
      until_(context.until),
      s_(simulation),
      checkpoint_(checkpoint),
      records_(records),
      facts_(facts),
      log_(log),
      rows_(scene::row_interval(context.scene), earlier.rows),
      frames_(simulate_.snapshot_interval, earlier.frames),
      progress_("simulate") {}

template <int D, class Real>
bool Run<D, Real>::to_end() {
    const StopWish wish;
    const double end = rounded(simulate_.end_time);
    settle(wish);
    bool began = false;
    if (rows_.past() == 0) {
        records_.append_row(read());
        rows_.pass();
    }
    for (;;) {
        const bool ended = s_.time >= end;
        write_frame_if_due(ended);
        if (ended) return true;
        // Everything until this time is written: from here on, a run that was loaded does the same as this
        // one.
        if (wish.signal() != 0) stop(wish.signal());
        if (s_.time >= until_) {
            save();
            return false;
        }
        save_if_due();
        step(end);
        // The step to come is chosen already: so even the first ones tell how long the run will take, but the
        // very first, which maps the memory.
        const double done = std::min((s_.time + s_.dt) / end, 1.0);
        if (!began) progress_.begin(done);
        began = true;
        progress_.update(done, format("t = %.3f s of %g s", s_.time, end));
    }
}

// Before time begins, also from a checkpoint of that phase.
template <int D, class Real>
void Run<D, Real>::settle(const StopWish& wish) {
    if (!scene_.has("settle")) return;
    if (s_.step == 0 && s_.settling.time == 0.0) begin_settling(s_);
    if (!s_.settling.going) return;
    const double tolerance = scene_.settle.tolerance;
    const auto begun = Clock::now();
    const long first = s_.step;
    while (!settle_step(s_, tolerance)) {
        if (wish.signal() != 0) stop(wish.signal());
        save_if_due();
        const double steps_ahead = simulate_.end_time / s_.dt;
        const double per_step = seconds_since(begun) / static_cast<double>(s_.step - first);
        progress_.prepare(format("settling: waves of %.3g Pa, to be %.3g Pa; then about %s",
                                 s_.settling.stress, tolerance,
                                 format_duration(steps_ahead * per_step).c_str()));
        if (s_.settling.time <= scene_.settle.max_time) continue;
        throw NumericsError(
            format("the start has not settled after %g s: waves of %.3g Pa are left (settle.tolerance "
                   "%g Pa); what floats or slides away never does; raise settle.tolerance or "
                   "settle.max_time, or take \"settle\" out of effects",
                   scene_.settle.max_time, s_.settling.stress, tolerance));
    }
    say(format("settled after %.3g s: waves of %.3g Pa are left (settle.tolerance %g Pa)", s_.settling.time,
               s_.settling.stress, tolerance));
}

// Advances by the step that was chosen before, and chooses the next: the stable one, but for the last two of
// a run, which share what is left.
template <int D, class Real>
void Run<D, Real>::step(double end) {
    const double arrival = snapped(s_.time + s_.dt);
    const double left = end - arrival, stable = mpm::stable_time_step(s_);
    double dt = stable;
    if (left > 0.0 && left < 2.0 * stable) dt = left <= stable ? left : 0.5 * left;
    facts_.tally().add_step(dt < stable ? TimeStepLimit::end : time_step_limit(s_), dt, s_.particle_count());
    const bool row_due = rows_.next() <= arrival || arrival >= end;
    std::optional<Reading<D>> before;
    if (row_due) before = reading_ ? std::move(reading_) : read();
    reading_.reset();
    mpm::advance(s_, dt);
    s_.time = arrival;
    if (row_due) write_rows(*before, arrival >= end);
}

template <int D, class Real>
Reading<D> Run<D, Real>::read() {
    const auto begun = Clock::now();
    Reading<D> reading = records_.read(s_);
    facts_.tally().rows_seconds += seconds_since(begun);
    return reading;
}

// The rows between the reading before the step at hand and the present state, and the last one of a run.
template <int D, class Real>
void Run<D, Real>::write_rows(const Reading<D>& before, bool ended) {
    reading_ = read();
    const auto begun = Clock::now();
    double last = before.time;
    for (; rows_.next() <= s_.time; rows_.pass()) {
        last = rows_.next();
        records_.append_row(reading_between(before, *reading_, last));
    }
    if (ended && last < s_.time) records_.append_row(reading_between(before, *reading_, s_.time));
    facts_.tally().rows_seconds += seconds_since(begun);
}

template <int D, class Real>
void Run<D, Real>::write_frame_if_due(bool ended) {
    if (!frames_.due(s_.time) && !ended) return;
    const auto begun = Clock::now();
    records_.write_frame(s_);
    facts_.tally().frames_seconds += seconds_since(begun);
    say(format("t %.4g s, step %ld, frame %zu: ", s_.time, s_.step, records_.frame_count() - 1) +
        time_step_line(s_));
}

// A checkpoint that does not fit on the disk is no reason to stop: the one before is still there.
template <int D, class Real>
void Run<D, Real>::save_if_due() {
    const double interval = simulate_.checkpoint_interval;
    if (interval == 0.0 || seconds_since(last_save_) < interval) return;
    try {
        save();
        facts_.write("running");
    } catch (const OutputError& error) {
        const std::string line =
            std::string(error.what()) + "; meanwhile the run goes on, with what was written before";
        say("warning: " + line);
        facts_.tally().warnings += line + "\n";
        last_save_ = Clock::now();
    }
}

template <int D, class Real>
void Run<D, Real>::save() {
    RunState run;
    run.rows = rows_.past();
    run.frames = frames_.past();
    facts_.store(run);
    records_.store(run);
    const auto begun = Clock::now();
    checkpoint_.save(s_, run);
    last_save_ = Clock::now();
    const auto bytes = std::filesystem::file_size(checkpoint_.path());
    const double seconds = seconds_since(begun);
    Tally& tally = facts_.tally();
    tally.checkpoint_bytes = static_cast<std::int64_t>(bytes);
    tally.checkpoint_seconds += seconds;
    log_.quiet_line(format("checkpoint at t %.4g s: %.3g MB in %.2g s", s_.time,
                           1e-6 * static_cast<double>(bytes), seconds));
}

template <int D, class Real>
void Run<D, Real>::stop(int signal) {
    progress_.finish();
    std::string line = "stopped by " + std::string(signal_name(signal)) + " at " +
                       format("t = %.6g s, step %ld", s_.time, s_.step);
    try {
        save();
    } catch (const OutputError& error) {
        line += ", but " + std::string(error.what());
    }
    records_.keep_parts();
    throw Error(static_cast<ExitCode>(128 + signal), line);
}

template <int D, class Real>
void Run<D, Real>::say(const std::string& line) {
    progress_.finish();
    log_.line(line);
}

template class Run<2, float>;
template class Run<2, double>;
template class Run<3, float>;
template class Run<3, double>;

}  // namespace tidewater
