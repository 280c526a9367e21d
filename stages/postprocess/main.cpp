// tidewater-postprocess: from the results of simulate to pictures, charts, wave statistics, icebergs and a
// ParaView collection.
#include <array>
#include <cstdio>

#include "bodies.h"
#include "charts.h"
#include "common/stage.h"
#include "core/files.h"
#include "earlier.h"
#include "energy_split.h"
#include "frames.h"
#include "gauges.h"
#include "icebergs.h"
#include "import.h"
#include "inputs.h"
#include "particles.h"
#include "pictures.h"
#include "profiles.h"
#include "quantities.h"
#include "report.h"
#include "stamps.h"
#include "tsunami.h"

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

void work_on_tsunami(const StageContext& context, const std::vector<Body>& bodies, const Tsunami& tsunami) {
    const auto& folder = context.folder;
    write_text(folder / "bodies.svg", body_chart(bodies, context));
    write_text(folder / "first_wave.svg", first_wave_chart(tsunami, context));
    if (!tsunami.energy.time.empty()) {
        write_text(folder / "energy_split.svg", energy_split_chart(tsunami.energy, context));
        write_energy_split(folder / "energy_split.csv", tsunami.energy, context.provenance);
    }
    write_first_wave(folder / "first_wave.csv", tsunami, context.provenance);
    write_waves_3d(folder / "waves_3d.csv", tsunami, context.provenance);
    write_tsunami(folder / "tsunami.csv", tsunami, context.provenance);
    std::fputs(describe(tsunami).c_str(), stdout);
}

// What is made of single frames, and only of those that need it.
void work_on_frames(const StageContext& context, const Frames& frames, const Ground& ground, Stamps& stamps) {
    const auto chosen = choose_pictures(frames.times, context.scene);
    const std::array products{particles_product(context), gauges_product(context, ground),
                              profile_product(context, ground), speed_product(context, chosen)};
    make_frame_products(context, frames, products, "frames", stamps);
    make_pictures(context, frames, chosen, ground, stamps);
    stamps.remove_unclaimed();
}

// Of simulate, or of another program.
Frames frames_of(const StageContext& context) {
    if (!context.particles.files.empty()) return import_frames(context);
    const auto simulated = context.run / "simulate";
    Frames frames = find_frames(simulated);
    require_same_scene(simulated, context.scene);
    return frames;
}

// report.html comes last: where it exists, everything else does.
void work(StageContext& context) {
    check_picture_window(context.scene);
    parse_references(context.scene.postprocess.references);  // tells what is wrong before anything is removed
    const Frames frames = frames_of(context);
    const Inputs inputs = read_inputs(context);
    const auto& bodies = inputs.bodies;
    const std::string energy = inputs.ledger ? energy_chart(*inputs.ledger, inputs.ledger_file, context) : "";
    const EnergySplit split = inputs.ledger && !bodies.empty()
                                  ? split_energy(*inputs.ledger, inputs.ledger_file, bodies)
                                  : EnergySplit{};

    remove_earlier_results(context.folder);
    make_output_folder(context.folder / "frames");
    Stamps stamps(context.folder);
    write_resolved_scene(context);
    work_on_frames(context, frames, inputs.ground, stamps);
    write_particles_collection(context, frames);
    const std::vector<GaugeRecord> read = gather_gauges(context, frames);
    if (!read.empty()) write_gauges(context.folder / "gauges.csv", read, context.provenance);
    std::vector<GaugeRecord> records = inputs.gauges;
    records.insert(records.end(), read.begin(), read.end());
    work_on_icebergs(context, frames);
    if (!bodies.empty())
        work_on_tsunami(context, bodies,
                        find_tsunami(bodies, gather_profiles(context, frames), split, context.scene));
    const Waves waves = analyse(std::move(records), context.scene);
    if (!energy.empty()) write_text(context.folder / "energy.svg", energy);
    write_text(context.folder / "gauges.svg", gauge_chart(waves, context));
    write_text(context.folder / "celerity.svg", celerity_chart(waves, context));
    write_waves(context.folder / "waves.csv", waves, context.provenance);
    std::fputs(describe(waves).c_str(), stdout);
    write_run_report(context, frames);
}

}  // namespace
}  // namespace tidewater::postprocess

int main(int argc, char** argv) {
    return tidewater::run_stage(
        argc, argv, tidewater::scene::Stage::postprocess,
        "Makes pictures, charts, wave statistics, icebergs and a ParaView collection from a simulated run.",
        &tidewater::postprocess::work);
}
