#include "facts.h"

#include <tbb/info.h>

#include <cmath>
#include <sstream>

#include "commit.h"
#include "core/machine.h"
#include "core/parallel.h"
#include "io/snapshot.h"

namespace tidewater {
namespace {

// 0 if there is no such file.
std::int64_t size_of(const std::filesystem::path& path) {
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    return error ? 0 : static_cast<std::int64_t>(size);
}

// Of a table under its own name or, while the run goes on, as its part.
std::int64_t table_size(const std::filesystem::path& path) {
    return std::filesystem::exists(path) ? size_of(path) : size_of(path.string() + ".part");
}

io::RunFacts::Scene scene_facts(const StageContext& context) {
    return {.file = context.scene_file.string(),
            .title = context.scene.title,
            .hash = context.provenance.scene_hash,
            .dimension = context.scene.dimension,
            .seed = static_cast<std::int64_t>(context.scene.seed),
            .effects = context.scene.effects};
}

io::RunFacts::Machine machine_facts() {
    const Machine machine = this_machine();
    return {.host = machine.host,
            .cpu = machine.cpu,
            .cores = machine.cores,
            .memory_bytes = machine.memory_bytes};
}

template <int D, class Real>
io::RunFacts::Engine engine_facts(const StageContext& context, const mpm::Simulation<D, Real>& s) {
    const scene::Scene::Domain& domain = context.scene.domain;
    io::RunFacts::Engine engine{.cell_size_m = domain.cell_size,
                                .grid_blocks = static_cast<std::int64_t>(s.grid.particle_blocks.size()),
                                .rigid_bodies = static_cast<std::int64_t>(s.rigid.size())};
    for (const double size : domain.size) engine.cells.push_back(std::lround(size / domain.cell_size));
    for (const Material material : all_materials) {
        if (material == Material::rigid) continue;  // bodies without particles
        std::int64_t count = 0;
        for (const auto& particles : s.bodies) {
            if (particles.material == material) count += static_cast<std::int64_t>(particles.size());
        }
        engine.particles.emplace_back(material_name(material), count);
    }
    return engine;
}

io::RunFacts::TimeStep time_step_facts(const Tally& tally, double last) {
    io::RunFacts::TimeStep step;
    std::int64_t steps = 0;
    for (std::size_t i = 0; i < tally.limited.size(); ++i) {
        step.steps_limited_by.emplace_back(time_step_limits[i], tally.limited[i]);
        steps += tally.limited[i];
    }
    if (steps == 0) return step;
    step.min_s = tally.shortest;
    step.mean_s = tally.sum / static_cast<double>(steps);
    step.max_s = tally.longest;
    step.last_s = last;
    return step;
}

template <int D, class Real>
io::RunFacts::Bytes written_bytes(const std::filesystem::path& folder, const Records<D, Real>& records,
                                  std::int64_t checkpoint) {
    io::RunFacts::Bytes bytes;
    for (std::size_t frame = 0; frame < records.frame_count(); ++frame)
        bytes.frames += size_of(folder / io::snapshot_name(frame));
    for (const char* name : {"gauges.csv", "pressures.csv", "bodies.csv", "ledger.csv"})
        bytes.tables += table_size(folder / name);
    if (checkpoint > 0) bytes.checkpoint = checkpoint;
    return bytes;
}

// That parallel loops may use.
int thread_count() {
    const auto* arena = limited_arena();
    return arena != nullptr ? arena->max_concurrency() : tbb::info::default_concurrency();
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

}  // namespace

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

template <int D, class Real>
Facts<D, Real>::Facts(const StageContext& context, const mpm::Simulation<D, Real>& simulation,
                      const Records<D, Real>& records, const RunState& earlier, Clock::time_point started)
    : context_(context),
      s_(simulation),
      records_(records),
      started_(started),
      earlier_seconds_(earlier.seconds),
      went_on_from_(earlier.went_on ? simulation.time : io::RunFacts::unknown),
      tally_(earlier.tally) {
    if (tally_.started.empty()) tally_.started = utc_now();
    ++tally_.processes;
    tally_.start_seconds += seconds_since(started);
}

template <int D, class Real>
double Facts<D, Real>::total_seconds() const {
    return earlier_seconds_ + seconds_since(started_);
}

template <int D, class Real>
void Facts<D, Real>::store(RunState& run) const {
    run.seconds = total_seconds();
    run.tally = tally_;
    for (std::size_t phase = 0; phase < s_.seconds.size(); ++phase)
        run.tally.phase_seconds[phase] += s_.seconds[phase];
    run.tally.peak_memory_bytes = std::max(tally_.peak_memory_bytes, peak_memory_bytes().value_or(0));
}

template <int D, class Real>
io::RunFacts Facts<D, Real>::now(const std::string& state, const std::string& reason) const {
    RunState run;
    store(run);
    const Tally& tally = run.tally;
    io::RunFacts facts;
    facts.state = state;
    facts.reason = reason;
    facts.program = context_.provenance.program;
    facts.version = context_.provenance.version;
    facts.commit = source_commit();
    facts.command = context_.provenance.command;
    facts.started = tally.started;
    if (state != "running") facts.ended = utc_now();
    facts.processes = tally.processes;
    facts.went_on_from_s = went_on_from_;
    facts.scene = scene_facts(context_);
    facts.machine = machine_facts();
    facts.threads = thread_count();
    facts.precision = sizeof(Real) == sizeof(float) ? "float" : "double";
    facts.engine = engine_facts(context_, s_);
    facts.steps = s_.step;
    facts.particle_steps = tally.particle_steps;
    facts.simulated_s = s_.time;
    if (context_.scene.has("settle")) facts.settling_s = s_.settling.time;
    facts.time_step = time_step_facts(tally, s_.dt);
    facts.seconds = {{"start", tally.start_seconds}};
    for (std::size_t phase = 0; phase < mpm::phase_names.size(); ++phase)
        facts.seconds.emplace_back(mpm::phase_names[phase], tally.phase_seconds[phase]);
    facts.seconds.emplace_back("rows", tally.rows_seconds);
    facts.seconds.emplace_back("frames", tally.frames_seconds);
    facts.seconds.emplace_back("checkpoint", tally.checkpoint_seconds);
    facts.seconds.emplace_back("total", run.seconds);
    if (tally.peak_memory_bytes > 0) facts.peak_memory_bytes = tally.peak_memory_bytes;
    facts.bytes = written_bytes(context_.folder, records_, tally.checkpoint_bytes);
    facts.ledger = records_.ledger_facts();
    facts.warnings = scene::scene_warnings(context_.scene);
    for (const std::string& line : lines_of(tally.warnings)) facts.warnings.push_back(line);
    return facts;
}

template <int D, class Real>
io::RunFacts Facts<D, Real>::write(const std::string& state, const std::string& reason) const {
    io::RunFacts facts = now(state, reason);
    io::write_run_facts(context_.folder / "run.json", facts);
    return facts;
}

template class Facts<2, float>;
template class Facts<2, double>;
template class Facts<3, float>;
template class Facts<3, double>;

}  // namespace tidewater
