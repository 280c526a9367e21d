// tidewater-postprocess: from the results of simulate to pictures, charts, wave statistics, icebergs and a
// ParaView collection.
#include <array>
#include <cstdio>

#include "bodies.h"
#include "calving_wave.h"
#include "charts.h"
#include "common/stage.h"
#include "core/files.h"
#include "earlier.h"
#include "energy_split.h"
#include "first_iceberg.h"
#include "frames.h"
#include "gauges.h"
#include "iceberg_frames.h"
#include "iceberg_sizes.h"
#include "iceberg_tables.h"
#include "import.h"
#include "inputs.h"
#include "io/table.h"
#include "long_waves.h"
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

IcebergTables work_on_icebergs(const StageContext& context, const Frames& frames) {
    if (!context.scene.has("ice")) return {};
    const int dimension = context.scene.dimension;
    const IcebergTables tables = gather_icebergs(context, frames);
    const std::vector<SizeSet> sizes = find_sizes(tables, context.scene);
    write_icebergs(context, frames, tables);
    write_sizes(context, sizes);
    write_chart(context, "sizes", size_chart(sizes, context));
    write_chart(context, "calving", calving_chart(tables.calving, context));
    if (const auto first = read_first_iceberg(context.folder))
        std::fputs(describe(*first, dimension).c_str(), stdout);
    if (const auto event = read_main_event(context.folder))
        std::fputs(describe(*event, dimension).c_str(), stdout);
    std::fputs((describe(tables, dimension) + describe(sizes)).c_str(), stdout);
    return tables;
}

void work_on_long_waves(const StageContext& context, const Tsunami& tsunami,
                        const std::vector<GaugeRecord>& records) {
    const auto waves =
        fit_long_waves(records, tsunami.ways, context.scene.water.depth, context.scene.domain.gravity);
    write_long_waves(context.folder / "long_waves.csv", waves, tsunami.long_wave_celerity,
                     context.provenance);
    std::fputs(describe(waves, tsunami.long_wave_celerity).c_str(), stdout);
}

void work_on_tsunami(const StageContext& context, const std::vector<Body>& bodies, const Tsunami& tsunami,
                     const std::vector<GaugeRecord>& records) {
    const auto& folder = context.folder;
    write_chart(context, "bodies", body_chart(bodies, context));
    write_chart(context, "first_wave", first_wave_chart(tsunami, context));
    if (!tsunami.energy.time.empty()) {
        write_chart(context, "energy_split", energy_split_chart(tsunami.energy, context));
        write_energy_split(folder / "energy_split.csv", tsunami.energy, context.provenance);
    }
    write_first_wave(folder / "first_wave.csv", tsunami, context.provenance);
    write_waves_3d(folder / "waves_3d.csv", tsunami, context.provenance);
    write_tsunami(folder / "tsunami.csv", tsunami, context.provenance);
    std::fputs(describe(tsunami).c_str(), stdout);
    work_on_long_waves(context, tsunami, records);
}

void work_on_waves(const StageContext& context, const Waves& waves, const Surfaces& surfaces) {
    const auto& folder = context.folder;
    const WavePath path = main_wave_path(context.scene, surfaces.front);
    write_gauges_nc(folder, waves.records, context.scene, context.provenance);
    write_spectra(folder / "spectra.csv", waves, context.scene, context.provenance);
    write_chart(context, "spectra", spectra_chart(waves, context));
    const WaveDecay decay = find_decay(waves, path, context.scene);
    write_decay(folder, decay, context.provenance);
    write_chart(context, "decay", decay_chart(decay, context));
    std::fputs((describe(waves) + describe(decay)).c_str(), stdout);
    if (surfaces.far_end.empty()) return;
    write_chart(context, "space_time", space_time_chart(surfaces, waves, path, context));
    io::write_space_time_nc(folder / "space_time.nc", space_time_record(surfaces, context),
                            context.provenance);
    write_run_up(folder / "run_up.csv", surfaces, context.provenance);
    write_chart(context, "run_up", run_up_chart(surfaces, context));
    std::fputs(describe_run_up(surfaces, context.scene).c_str(), stdout);
}

// What is made of single frames, and only of those that need it.
void work_on_frames(const StageContext& context, const Frames& frames, const Ground& ground, Stamps& stamps) {
    const auto chosen = choose_pictures(frames.times, context.scene);
    // Icebergs and the surface first, for pictures and ParaView's files show them.
    const FrameProduct icebergs = icebergs_product(context, frames, ground);
    const FrameProduct surface = surface_product(context, ground);
    const ParaviewProducts paraview = paraview_products(context, icebergs, surface);
    const std::array products{icebergs,
                              first_iceberg_product(context, frames),
                              gauges_product(context, ground),
                              surface,
                              speed_product(context, chosen),
                              paraview.particles,
                              paraview.water_surface,
                              paraview.iceberg_surfaces};
    make_frame_products(context, frames, products, "frames", stamps);
    write_collections(context, frames, paraview);
    make_pictures(context, frames, chosen, ground, icebergs, stamps);
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
    const std::vector<GaugeRecord> read = gather_gauges(context, frames);
    if (!read.empty()) write_gauges(context.folder / "gauges.csv", read, context.provenance);
    std::vector<GaugeRecord> records = inputs.gauges;
    records.insert(records.end(), read.begin(), read.end());
    const IcebergTables icebergs = work_on_icebergs(context, frames);
    const Surfaces surfaces = gather_surfaces(context, frames);
    if (!bodies.empty())
        work_on_tsunami(context, bodies, find_tsunami(bodies, surfaces.profiles, split, context.scene),
                        records);
    const Waves waves = analyse(std::move(records), context.scene, inputs.ground);
    work_on_waves(context, waves, surfaces);
    if (const auto wave = find_calving_wave(context, icebergs, waves, inputs.ground, surfaces.front)) {
        write_calving_wave(context, *wave);
        std::fputs(describe(*wave).c_str(), stdout);
    }
    if (!energy.empty()) write_chart(context, "energy", energy);
    write_chart(context, "gauges", gauge_chart(waves, context));
    write_chart(context, "celerity", celerity_chart(waves, context));
    write_waves(context.folder / "waves.csv", waves, context.provenance);
    write_run_report(context, frames, inputs.facts);
    if (context.movie) make_movie(context, frames);
}

}  // namespace
}  // namespace tidewater::postprocess

int main(int argc, char** argv) {
    return tidewater::run_stage(
        argc, argv, tidewater::scene::Stage::postprocess,
        "Makes pictures, charts, wave statistics, icebergs and a ParaView collection from a simulated run.",
        &tidewater::postprocess::work);
}
