// write_wave_train SCENE RUN: the files of simulate, as a run would leave them in which a train of waves
// comes from the left wall into water at rest, whatever their period with c = √(gD):
//     η = 0.12 m sin(2πτ/2.5 s) + 0.04 m sin(4πτ/2.5 s),     τ = t - x/c;     η = 0 where τ < 0
// For tests of postprocess.
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <numbers>

#include "core/files.h"
#include "core/types.h"
#include "io/snapshot.h"
#include "io/table.h"
#include "scene/scene.h"

namespace {

using namespace tidewater;

const Provenance provenance{"write_wave_train", program_version(), "write_wave_train", "0", 1};

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
            for (const double part : {x, 0.0, z * stretch})
                snapshot.points.push_back(static_cast<float>(part));
            for (int axis = 0; axis < 3; ++axis) snapshot.velocity.push_back(0.0f);
            snapshot.pressure.push_back(0.0f);
            snapshot.volume.push_back(static_cast<float>(spacing * spacing * stretch));
            snapshot.material.push_back(static_cast<std::uint8_t>(Material::water));
            snapshot.id.push_back(static_cast<std::uint32_t>(snapshot.id.size()));
        }
    }
    return snapshot;
}

void write_run(const std::filesystem::path& scene_file, const std::filesystem::path& run) {
    const scene::Scene scene = scene::read_scene(scene_file);
    const auto folder = run / "simulate";
    make_output_folder(folder);
    write_text(folder / "scene.toml", scene::resolved_text(scene));
    io::TableWriter gauges(folder / "gauges.csv", provenance, {"time"});
    io::TableWriter ledger(
        folder / "ledger.csv", provenance,
        {"time", "kinetic", "gravitational", "elastic", "boundary_work", "outflow_energy", "energy"});
    const double interval = scene.simulate.snapshot_interval;
    const auto frames = static_cast<std::size_t>(std::lround(scene.simulate.end_time / interval));
    for (std::size_t number = 0; number <= frames; ++number) {
        const double time = interval * static_cast<double>(number);
        io::write_snapshot(folder / io::snapshot_name(number), frame(scene, time), provenance);
        gauges.append(std::array{time});
        ledger.append(std::array{time, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0});
    }
    gauges.finish();
    ledger.finish();
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc != 3) throw std::invalid_argument("needs SCENE RUN");
        write_run(argv[1], argv[2]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "write_wave_train: %s\n", error.what());
        return 1;
    }
    return 0;
}
