// write_frames COUNT FRAMES RUN: frames of about COUNT particles of a 3D scene of water before a cliff of ice
// whose front breaks off, as simulate would leave them, to measure postprocess with. RUN/scene.toml is the
// scene. A wave runs along the water; the ice before x = 0.4 of the tank sinks, failed along its back.
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>

#include "core/files.h"
#include "core/types.h"
#include "io/snapshot.h"
#include "io/table.h"
#include "io/text.h"
#include "scene/scene.h"

namespace {

using namespace tidewater;

constexpr double length = 1000.0, width = 500.0, depth = 100.0, front = 400.0,
                 ice_top = 150.0;
constexpr double crack = 360.0;  // x, m
constexpr float never = std::numeric_limits<float>::quiet_NaN();

const Provenance provenance{"write_frames", program_version(), "write_frames", "0", 1};

// Of a cell so that about `count` particles, eight a cell, fill the water and the ice; a divisor of all
// lengths.
double cell_size(double count) {
    const double volume = front * width * ice_top + (length - front) * width * depth;
    for (const double cell : {25.0, 10.0, 5.0, 10.0 / 3.0, 2.5, 2.0, 1.25, 1.0, 0.5}) {
        if (8.0 * volume / (cell * cell * cell) >= count) return cell;
    }
    throw std::invalid_argument("COUNT is more than 480 million");
}

std::string scene_text(double cell) {
    return "title = \"Many particles\"\ndimension = 3\neffects = [\"water\", \"ice\", \"fracture\"]\n"
           "[domain]\nsize = [1000, 500, 200]\ncell_size = " +
           io::format_number(cell) +
           "\n[water]\ndepth = 100\n[ice]\nsize = [400, 500, 150]\ncorner = [0, 0, 0]\n"
           "[simulate]\nend_time = 10\nsnapshot_interval = 1\n[postprocess]\ngauges = [500, 800]\n";
}

void add(io::Snapshot& snapshot, double x, double y, double z, double time, double volume) {
    const bool ice = x < front, off = ice && x > crack;
    const double wave =
        ice ? 0.0 : std::exp(-std::pow((x - 500.0 - 30.0 * time) / 50.0, 2.0)) * 5.0 * z / depth;
    const bool failed = ice && std::abs(x - crack) < 4.0 && time > 0.0;
    for (const double part : {x, y, z + (off ? -0.5 * time : wave)})
        snapshot.points.push_back(static_cast<float>(part));
    for (const double part : {off ? 1.0 : wave, 0.0, 0.0})
        snapshot.velocity.push_back(static_cast<float>(part));
    snapshot.pressure.push_back(static_cast<float>(1e4 * std::max(depth - z, 0.0)));
    snapshot.volume.push_back(static_cast<float>(volume));
    snapshot.material.push_back(static_cast<std::uint8_t>(ice ? Material::ice : Material::water));
    snapshot.id.push_back(static_cast<std::uint32_t>(snapshot.id.size()));
    snapshot.damage.push_back(failed ? 1.0f : 0.0f);
    snapshot.failure_time.push_back(failed ? 0.5f : never);
}

io::Snapshot frame(double cell, double time) {
    io::Snapshot snapshot;
    snapshot.dimension = 3;
    snapshot.time = time;
    const double spacing = 0.5 * cell;
    for (double x = 0.5 * spacing; x < length; x += spacing) {
        const double top = x < front ? ice_top : depth;
        for (double y = 0.5 * spacing; y < width; y += spacing) {
            for (double z = 0.5 * spacing; z < top; z += spacing)
                add(snapshot, x, y, z, time, spacing * spacing * spacing);
        }
    }
    return snapshot;
}

void write_run(double count, int frames, const std::filesystem::path& run) {
    const double cell = cell_size(count);
    const auto folder = run / "simulate";
    make_output_folder(folder);
    write_text(run / "scene.toml", scene_text(cell));
    write_text(folder / "scene.toml", scene::resolved_text(scene::read_scene(run / "scene.toml")));
    for (int n = 0; n < frames; ++n) {
        const io::Snapshot snapshot = frame(cell, n);
        io::write_snapshot(folder / io::snapshot_name(static_cast<std::size_t>(n)), snapshot, provenance);
        std::printf("frame %d: %zu particles\n", n, snapshot.particle_count());
    }
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc != 4) throw std::invalid_argument("needs COUNT FRAMES RUN");
        write_run(std::stod(argv[1]), std::stoi(argv[2]), argv[3]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "write_frames: %s\n", error.what());
        return 1;
    }
    return 0;
}
