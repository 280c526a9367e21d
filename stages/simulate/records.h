// What a run writes while it goes: frame_NNNN.hdf with frame.hdf.series, gauges.csv, pressures.csv if the
// scene has pressure gauges, bodies.csv if it has rigid blocks, and ledger.csv.
#pragma once

#include <filesystem>
#include <optional>

#include "bodies.h"
#include "checkpoint.h"
#include "common/ground.h"
#include "core/provenance.h"
#include "io/run_facts.h"
#include "io/table.h"
#include "readings.h"
#include "scene/scene.h"

namespace tidewater {

// Removes the results of an earlier run, so that they cannot be taken for this one's.
void remove_old_records(const std::filesystem::path& folder);

// Removes only what a run that goes on from a checkpoint with so many frames writes again: all but these
// frames, the checkpoint and the log.
void remove_later_records(const std::filesystem::path& folder, std::size_t frames);

template <int D, class Real>
class Records {
public:
    Records(const scene::Scene& scene, const Ground& ground, const std::filesystem::path& folder,
            const Provenance& provenance);

    void write_frame(const mpm::Simulation<D, Real>& simulation);
    Reading<D> read(const mpm::Simulation<D, Real>& simulation) const {
        return read_state(simulation, instruments_);
    }
    void append_row(const Reading<D>& reading);  // to all tables

    // What a checkpoint needs of the records, and how to go on behind it.
    void store(RunState& run);
    void resume(const RunState& run);

    // Gives the tables their names, ledger.csv last: when it exists, the run is whole.
    void finish();

    // Leaves the tables so far, under the names of their parts, to look at.
    void keep_parts();

    std::size_t frame_count() const { return frame_times_.size(); }
    io::RunFacts::Ledger ledger_facts() const;

private:
    std::filesystem::path folder_;
    Provenance provenance_;
    Instruments<D> instruments_;
    double gravity_;  // m/s²
    io::TableWriter gauges_;
    std::optional<io::TableWriter> pressures_;  // only of a scene that has sensors
    std::optional<BodiesTable> bodies_;         // only of one that has blocks
    io::TableWriter ledger_;
    double spacing_;  // of the points that stand for rigid blocks, m
    std::vector<double> frame_times_;
    std::vector<double> first_ledger_row_, last_ledger_row_;  // empty: none yet, or unknown
    double start_energy_ = 0.0, highest_energy_ = 0.0;
    bool first_row_ = true;
};

}  // namespace tidewater
