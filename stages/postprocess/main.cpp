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
#include "io/table.h"
#include "paraview.h"
#include "pictures.h"
#include "quantities.h"
#include "report.h"
#include "run_up.h"
#include "stamps.h"
#include "surface.h"
#include "tsunami.h"
#include "wave_charts.h"
#include "wave_decay.h"

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

// None where no block makes a wave, or, with a line that says so, if simulate was run before it wrote bodies.
std::vector<Body> read_run_bodies(const StageContext& context) {
    const auto path = context.run / "simulate" / "bodies.csv";
    if (!makes_first_wave(context.scene)) return {};
    if (std::filesystem::exists(path)) {
        std::vector<Body> bodies = read_bodies(path);
        slide_of(heaviest(bodies),
                 context.scene);  // so that what is wrong is told before anything is removed
        return bodies;
    }
    std::puts("no bodies.csv, and so nothing of the block's wave; run tidewater-simulate again");
    return {};
}

void work_on_tsunami(const StageContext& context, const std::vector<Body>& bodies, const Tsunami& tsunami) {
    const auto& folder = context.folder;
    write_text(folder / "bodies.svg", body_chart(bodies, context));
    write_text(folder / "energy_split.svg", energy_split_chart(tsunami.energy, context));
    write_text(folder / "first_wave.svg", first_wave_chart(tsunami, context));
    write_energy_split(folder / "energy_split.csv", tsunami.energy, context.provenance);
    write_first_wave(folder / "first_wave.csv", tsunami, context.provenance);
    write_waves_3d(folder / "waves_3d.csv", tsunami, context.provenance);
    write_tsunami(folder / "tsunami.csv", tsunami, context.provenance);
    std::fputs(describe(tsunami).c_str(), stdout);
}

void work_on_waves(const StageContext& context, const Waves& waves, const Surfaces& surfaces) {
    const auto& folder = context.folder;
    const WavePath path = main_wave_path(context.scene, surfaces.front);
    write_gauges_nc(folder, waves.records, context.scene, context.provenance);
    write_spectra(folder / "spectra.csv", waves, context.scene, context.provenance);
    write_text(folder / "spectra.svg", spectra_chart(waves, context));
    const WaveDecay decay = find_decay(waves, path, context.scene);
    write_decay(folder, decay, context.provenance);
    write_text(folder / "decay.svg", decay_chart(decay, context));
    std::fputs((describe(waves) + describe(decay)).c_str(), stdout);
    if (surfaces.far_end.empty()) return;
    write_text(folder / "space_time.svg", space_time_chart(surfaces, waves, path, context));
    io::write_space_time_nc(folder / "space_time.nc", space_time_record(surfaces, context),
                            context.provenance);
    write_run_up(folder / "run_up.csv", surfaces, context.provenance);
    write_text(folder / "run_up.svg", run_up_chart(surfaces, context));
    std::fputs(describe_run_up(surfaces, context.scene).c_str(), stdout);
}

// What is made of single frames, and only of those that need it.
void work_on_frames(const StageContext& context, const Frames& frames, const Ground& ground, Stamps& stamps) {
    const auto chosen = choose_pictures(frames.times, context.scene);
    // Until icebergs are followed from frame to frame, there are none to show.
    const FrameProduct none{.name = "",
                            .settings = "",
                            .files = [](std::size_t) { return std::vector<std::string>{}; },
                            .make = {},
                            .follows = false};
    const FrameProduct surface = surface_product(context, ground);
    const ParaviewProducts paraview = paraview_products(context, none, surface);
    const std::array products{gauges_product(context, ground), surface,
                              speed_product(context, chosen),  paraview.particles,
                              paraview.water_surface,          paraview.iceberg_surfaces};
    make_frame_products(context, frames, products, "frames", stamps);
    write_collections(context, frames, paraview);
    make_pictures(context, frames, chosen, ground, stamps);
    stamps.remove_unclaimed();
}

// report.html comes last: where it exists, everything else does.
void work(StageContext& context) {
    check_picture_window(context.scene);
    parse_references(context.scene.postprocess.references);  // tells what is wrong before anything is removed
    const auto simulated = context.run / "simulate";
    const Frames frames = find_frames(simulated);
    require_same_scene(simulated, context.scene);
    std::vector<GaugeRecord> records = read_run_gauges(simulated / "gauges.csv");
    const io::Table ledger = io::read_table(simulated / "ledger.csv");
    const std::string energy = energy_chart(ledger, simulated / "ledger.csv", context);
    const std::vector<Body> bodies = read_run_bodies(context);
    const EnergySplit split =
        bodies.empty() ? EnergySplit{} : split_energy(ledger, simulated / "ledger.csv", bodies);
    const Ground ground = read_ground(context.scene, geometry_file(context));

    remove_earlier_results(context.folder);
    make_output_folder(context.folder / "frames");
    Stamps stamps(context.folder);
    write_resolved_scene(context);
    work_on_frames(context, frames, ground, stamps);
    const std::vector<GaugeRecord> read = gather_gauges(context, frames);
    if (!read.empty()) write_gauges(context.folder / "gauges.csv", read, context.provenance);
    records.insert(records.end(), read.begin(), read.end());
    work_on_icebergs(context, frames);
    const Surfaces surfaces = gather_surfaces(context, frames);
    if (!bodies.empty())
        work_on_tsunami(context, bodies, find_tsunami(bodies, surfaces.profiles, split, context.scene));
    const Waves waves = analyse(std::move(records), context.scene, ground);
    work_on_waves(context, waves, surfaces);
    write_text(context.folder / "energy.svg", energy);
    write_text(context.folder / "gauges.svg", gauge_chart(waves, context));
    write_text(context.folder / "celerity.svg", celerity_chart(waves, context));
    write_waves(context.folder / "waves.csv", waves, context.provenance);
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
