// tidewater-postprocess: from the results of simulate to pictures, charts, wave statistics, icebergs and a
// ParaView collection.
#include <cstdio>

#include "charts.h"
#include "common/stage.h"
#include "core/files.h"
#include "earlier.h"
#include "frames.h"
#include "gauges.h"
#include "icebergs.h"
#include "io/table.h"

namespace tidewater::postprocess {
namespace {

void work_on_icebergs(const StageContext& context, const Frames& frames) {
    const auto icebergs = find_icebergs(frames, context.scene);
    if (!icebergs) return;
    write_icebergs(context.folder / "icebergs.csv", *icebergs, context.scene.ice.model.density,
                   context.provenance);
    write_fragments(context.folder / "fragments.csv", *icebergs, context.provenance);
    std::fputs(describe(*icebergs).c_str(), stdout);
}

// waves.csv comes last: where it exists, everything else does.
void work(StageContext& context) {
    const auto simulated = context.run / "simulate";
    const Frames frames = find_frames(simulated);
    require_same_scene(simulated, context.scene);
    std::vector<GaugeRecord> records = read_run_gauges(simulated / "gauges.csv");
    const io::Table ledger = io::read_table(simulated / "ledger.csv");
    const std::string energy = energy_chart(ledger, simulated / "ledger.csv", context);

    remove_earlier_results(context.folder);
    write_resolved_scene(context);
    const auto from_snapshots = process_frames(context, frames);
    if (!from_snapshots.empty())
        write_gauges(context.folder / "gauges.csv", from_snapshots, context.provenance);
    records.insert(records.end(), from_snapshots.begin(), from_snapshots.end());
    work_on_icebergs(context, frames);
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
        "Makes pictures, charts, wave statistics, icebergs and a ParaView collection from a simulated run.",
        &tidewater::postprocess::work);
}
