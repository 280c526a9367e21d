// write_wave_train SCENE RUN: the files of simulate, as a run would leave them in which a train of waves
// comes from the left wall into water at rest, whatever their period with c = √(gD):
//     η = 0.12 m sin(2πτ/2.5 s) + 0.04 m sin(4πτ/2.5 s),     τ = t - x/c;     η = 0 where τ < 0
// For tests of postprocess.
#include <cmath>
#include <numbers>

#include "written_run.h"

namespace {

using namespace tidewater;

double elevation(const scene::Scene& scene, double x, double t) {
    const double passed = t - x / std::sqrt(scene.domain.gravity * scene.water.depth);
    const double phase = 2.0 * std::numbers::pi * passed / 2.5;
    return passed > 0.0 ? 0.12 * std::sin(phase) + 0.04 * std::sin(2.0 * phase) : 0.0;
}

// Columns of water are as much higher as their surface is.
io::Snapshot frame(const scene::Scene& scene, double time) {
    io::Snapshot snapshot;
    snapshot.time = time;
    const double spacing = scene.domain.cell_size / scene.particles.per_axis;
    for (double x = 0.5 * spacing; x < scene.domain.size.front(); x += spacing) {
        const double stretch = 1.0 + elevation(scene, x, time) / scene.water.depth;
        for (double z = 0.5 * spacing; z < scene.water.depth; z += spacing) {
            add_particle(snapshot, {x, 0.0, z * stretch}, {}, spacing * spacing * stretch, Material::water);
        }
    }
    return snapshot;
}

void write_frames(WrittenRun& run) {
    const double interval = run.scene.simulate.snapshot_interval;
    const auto frames = static_cast<std::size_t>(std::lround(run.scene.simulate.end_time / interval));
    for (std::size_t number = 0; number <= frames; ++number) {
        run.add_frame(frame(run.scene, interval * static_cast<double>(number)), 0.0, 1.0, 0.0);
    }
}

}  // namespace

int main(int argc, char** argv) {
    return write_run("write_wave_train", {argv, static_cast<std::size_t>(argc)}, "",
                     [](WrittenRun& run, const std::string&) { write_frames(run); });
}
