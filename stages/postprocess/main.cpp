// tidewater-postprocess: from the results of simulate to pictures, charts, wave statistics and a ParaView
// collection.
#include <cstdio>

#include "charts.h"
#include "common/stage.h"
#include "core/files.h"
#include "frames.h"
#include "gauges.h"
#include "io/table.h"

namespace tidewater::postprocess {
namespace {

// Removes what an earlier run of this stage may have left, which could name other frames or gauges.
void remove_earlier_results(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const bool picture = name.starts_with("frame_t=") && name.ends_with(".png");
        const bool frame = name.starts_with("particles_") && name.ends_with(".vtp");
        const bool single = name == "waves.csv" || name == "gauges.csv" || name == "particles.pvd" ||
                            name == "gauges.svg" || name == "celerity.svg" || name == "energy.svg";
        if (picture || frame || single) found.push_back(entry.path());
    }
    for (const auto& path : found) std::filesystem::remove(path);
}

// waves.csv comes last: where it exists, everything else does.
void work(StageContext& context) {
    const auto simulated = context.run / "simulate";
    const Frames frames = find_frames(simulated);
    std::vector<GaugeRecord> records = read_run_gauges(simulated / "gauges.csv");
    const io::Table ledger = io::read_table(simulated / "ledger.csv");
    const std::string energy = energy_chart(ledger, simulated / "ledger.csv", context);

    remove_earlier_results(context.folder);
    const auto from_snapshots = process_frames(context, frames);
    if (!from_snapshots.empty())
        write_gauges(context.folder / "gauges.csv", from_snapshots, context.provenance);
    records.insert(records.end(), from_snapshots.begin(), from_snapshots.end());
    const Waves waves = analyse(std::move(records), context.scene);
    write_text(context.folder / "energy.svg", energy);
    write_text(context.folder / "gauges.svg", gauge_chart(waves, context));
    write_text(context.folder / "celerity.svg", celerity_chart(waves, context));
    write_waves(context.folder / "waves.csv", waves, context.provenance);
    std::fputs(describe(waves).c_str(), stdout);
}

}  // namespace
}  // namespace tidewater::postprocess

int main(int argc, char** argv) {
    return tidewater::run_stage(
        argc, argv, tidewater::scene::Stage::postprocess,
        "Makes pictures, charts, wave statistics and a ParaView collection from a simulated run.",
        &tidewater::postprocess::work);
}
