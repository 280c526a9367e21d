#include "checkpoint.h"

#include <array>

#include "core/error.h"
#include "core/files.h"
#include "core/progress.h"
#include "format.h"
#include "io/columns.h"
#include "io/snapshot.h"
#include "mpm/state/state.h"

namespace tidewater {
namespace {

// Until version 7 steps ended where rows were due, and velocities began half a step earlier.
constexpr std::int64_t format_version = 8;

io::Hdf5Reader open_checkpoint(const std::filesystem::path& path) {
    io::Hdf5Reader file(path, "--from start begins the run anew");
    file.require_format("checkpoint", format_version);
    const std::int64_t version = file.integer("/", "format_version");
    if (version < format_version)
        file.fail("its format version " + std::to_string(version) +
                  " is of a program that stepped by another rule");
    return file;
}

std::string time_text(double time) { return format("t = %.6g s", time); }

double seconds_in(const io::Hdf5Reader& file) {
    double seconds = 0.0;
    io::ColumnReader(file, "/run")("seconds", seconds);
    return seconds;
}

}  // namespace

Checkpoint::Checkpoint(const StageContext& context, std::string start)
    : context_(context),
      path_(context.folder / "checkpoint.h5"),
      start_(std::move(start)),
      scene_(stage_part(context.scene, scene::Stage::simulate)),
      build_(program_fingerprint()) {}

// Empty if the file is of this scene and start.
std::string Checkpoint::difference(const io::Hdf5Reader& file) const {
    std::string scene;
    io::ColumnReader(file, "")("scene", scene);
    const std::string other = first_difference(scene, scene_);
    if (!other.empty()) return "of another scene (" + other + ")";
    return file.text("/", "start") == start_ ? "" : "of a run that started from other particles";
}

void Checkpoint::note_other_program(const io::Hdf5Reader& file) {
    const std::string version = file.text("/", "version");
    if (version == context_.provenance.version && file.text("/", "build") == build_) return;
    note_ += "; it was written by another build of this program, " + version +
             ", so the last digits may differ from those of a run in one piece";
}

std::filesystem::path Checkpoint::find() {
    const bool named = !context_.from.empty();
    if (context_.from == "start" || (!named && !std::filesystem::exists(path_))) return {};
    const std::filesystem::path path = named ? std::filesystem::path(context_.from) : path_;
    const io::Hdf5Reader file = open_checkpoint(path);
    const std::string other = difference(file);
    if (other.empty()) {
        note_ = "going on from " + path.string() + ", " + time_text(file.number("/", "time"));
        note_other_program(file);
        return path;
    }
    if (named) file.fail("it is " + other);
    // A table under its final name says that the run ended before its checkpoint was removed.
    const double seconds = std::filesystem::exists(context_.folder / "ledger.csv") ? 0.0 : seconds_in(file);
    if (seconds > costly) {
        file.fail("it is " + other + " and holds " + format_duration(seconds) +
                  " of work, which this run would remove; choose another folder with --run, or finish it");
    }
    note_ = path.string() + " is " + other + ": beginning anew";
    return {};
}

// Frames are whole once they have their name, so a look at their times is enough.
void Checkpoint::require_frames(const RunState& run, const std::filesystem::path& file) const {
    for (std::size_t frame = 0; frame < run.frame_times.size(); ++frame) {
        const auto path = context_.folder / io::snapshot_name(frame);
        if (std::filesystem::exists(path) && io::read_snapshot_time(path) == run.frame_times[frame]) continue;
        throw InputError(path.string() + ": missing or of another run, while " + file.string() +
                         " counts on it; put it back, or begin the run anew with --from start");
    }
}

template <int D, class Real>
RunState Checkpoint::load(const std::filesystem::path& path, mpm::Simulation<D, Real>& simulation) {
    const io::Hdf5Reader file = open_checkpoint(path);
    RunState run;
    run.went_on = true;
    run.visit(io::ColumnReader(file, "/run"));
    run.tally.visit(io::ColumnReader(file, "/tally"));
    visit_state(simulation, io::ColumnReader(file, "/state"));
    if (!relink(simulation)) file.fail("its arrays do not fit each other or this build's blocks");
    require_frames(run, path);
    if (std::filesystem::exists(path_) && std::filesystem::equivalent(path, path_))
        last_time_ = simulation.time;
    return run;
}

template <int D, class Real>
void Checkpoint::save(mpm::Simulation<D, Real>& simulation, RunState& run) {
    PartFile part(path_);
    io::Hdf5Writer file(part.part_path(), io::Metadata::checksummed);
    file.attribute("/", "format", "tidewater-checkpoint");
    file.attribute("/", "format_version", std::array{format_version});
    for (const auto& [name, text] : provenance_fields(context_.provenance)) file.attribute("/", name, text);
    file.attribute("/", "build", build_);
    file.attribute("/", "start", start_);
    file.attribute("/", "time", simulation.time);
    file.array<char>("/scene", scene_);
    run.visit(io::ColumnWriter(file, "/run"));
    run.tally.visit(io::ColumnWriter(file, "/tally"));
    visit_state(simulation, io::ColumnWriter(file, "/state"));
    file.close();
    part.commit();
    last_time_ = simulation.time;
}

void Checkpoint::remove() const {
    std::error_code error;
    std::filesystem::remove(path_, error);
    if (error)
        throw OutputError(path_.string() + ": cannot be removed: " + error.message() + "; remove it by hand");
}

std::string Checkpoint::last_good(const Error& error) const {
    if (last_time_ < 0.0) return {};
    const std::string checkpoint = path_.string() + ", " + time_text(last_time_);
    if (error.code() != ExitCode::numerics) return "; the same command goes on from " + checkpoint;
    return "; what it wrote remains, and " + checkpoint + "; with other settings begin anew, by --from start";
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                           \
    template RunState Checkpoint::load(const std::filesystem::path&, mpm::Simulation<D, Real>&); \
    template void Checkpoint::save(mpm::Simulation<D, Real>&, RunState&);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater
