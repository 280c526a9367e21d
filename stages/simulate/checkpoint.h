// <run>/simulate/checkpoint.h5: a run between two steps, from which it goes on to the bytes that it would
// have had undisturbed. The README describes the file. Test: tests/pipeline/checkpoint_test.sh
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/stage.h"
#include "core/error.h"
#include "io/hdf5_file.h"
#include "mpm/state/simulation.h"
#include "tally.h"

namespace tidewater {

// What a run consists of besides the state of its simulation.
struct RunState {
    double seconds = 0.0;                             // of wall time spent on it
    std::int64_t rows = 0;                            // of the schedule of rows: times that have come up
    std::int64_t frames = 0;                          // of frames
    std::vector<double> frame_times;                  // of the frames that lie in the folder, s
    std::string gauges, pressures, bodies, ledger;    // the tables so far; two of them may be empty
    std::vector<double> last_bodies;                  // BodiesTable::last
    double start_energy = 0.0, highest_energy = 0.0;  // J
    Tally tally;                                      // kept apart from the rest
    bool went_on = false;                             // whether a checkpoint held this; not kept

    bool begun() const { return rows > 0; }

    template <class Visit>
    void visit(const Visit& visit) {
        visit("seconds", seconds);
        visit("rows", rows);
        visit("frames", frames);
        visit("frame_times", frame_times);
        visit("gauges", gauges);
        visit("pressures", pressures);
        visit("bodies", bodies);
        visit("last_bodies", last_bodies);
        visit("ledger", ledger);
        visit("start_energy", start_energy);
        visit("highest_energy", highest_energy);
    }
};

class Checkpoint {
public:
    // `start` is the fingerprint of the particles that the run starts from.
    Checkpoint(const StageContext& context, std::string start);

    // The checkpoint that this run has to go on from, empty if it begins at the start:
    //     --from FILE     that file; it must be of this scene and of this start
    //     --from start    none
    //     neither         the folder's own, if there is one; if it is of another scene, none
    // Throws InputError if the file is damaged, newer, or foreign where it must not be; also if it is the
    // folder's own, of another scene, and more than costly seconds of work on it would be lost.
    std::filesystem::path find();
    static constexpr double costly = 600.0;

    // What the user should know about what find() decided; may be empty.
    const std::string& note() const { return note_; }

    // Fills the simulation, which was made from the same start, and checks that the folder has the run's
    // frames. Throws InputError.
    template <int D, class Real>
    RunState load(const std::filesystem::path& file, mpm::Simulation<D, Real>& simulation);

    // Replaces the folder's checkpoint as a whole. Throws OutputError; then the one before is still there.
    template <int D, class Real>
    void save(mpm::Simulation<D, Real>& simulation, RunState& run);

    void remove() const;
    const std::filesystem::path& path() const { return path_; }

    // What can be done with the last good checkpoint after this error, "; the same command goes on from
    // <path>, t = 1.5 s" for instance. Empty if there is none.
    std::string last_good(const Error& error) const;

private:
    std::string difference(const io::Hdf5Reader& file) const;
    void note_other_program(const io::Hdf5Reader& file);
    void require_frames(const RunState& run, const std::filesystem::path& file) const;

    const StageContext& context_;
    std::filesystem::path path_;
    std::string start_, scene_, build_, note_;
    double last_time_ = -1.0;  // s, simulated; negative: none
};

}  // namespace tidewater
