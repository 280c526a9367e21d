// write_block_wave SCENE RUN: the files of simulate, as a run would leave them in which the scene's block
// sinks by 0.2 m, its fastest point with 1.15 m/s at 0.4 s, turns by 10°, and makes a wave on water 1 m deep:
//     η = A exp(-(x - c)²/2 m²),     c = 0.6 m + 3 m/s t,
//     A = 0.2 m/s t until 0.5 s,     then 0.1 m exp(-(t - 0.5 s)/6 s)
// A second block, lighter and of which there are no particles, lies still. The blocks lose 100 J within 0.8
// s, of which the water gets 70. For tests of postprocess in 2D and 3D.
#include <cmath>

#include "written_run.h"

namespace {

using namespace tidewater;

double amplitude(double t) { return t < 0.5 ? 0.2 * t : 0.1 * std::exp(-(t - 0.5) / 6.0); }

double elevation(double x, double t) {
    const double from_crest = x - 0.6 - 3.0 * t;
    return amplitude(t) * std::exp(-0.5 * from_crest * from_crest);
}

// 0 to 1 within the first 0.8 s.
double progress(double t) { return t < 0.8 ? 0.5 - 0.5 * std::cos(M_PI * t / 0.8) : 1.0; }

// Columns of water are as much higher as their surface is.
io::Snapshot frame(const scene::Scene& scene, double time) {
    io::Snapshot snapshot;
    snapshot.dimension = scene.dimension;
    snapshot.time = time;
    const double spacing = scene.domain.cell_size / scene.particles.per_axis;
    const double share = std::pow(spacing, scene.dimension);
    const double width = scene.dimension == 3 ? scene.domain.size[1] : spacing;
    const auto add = [&](double x, double y, double z, double volume, Material material) {
        add_particle(snapshot, {x, scene.dimension == 3 ? y : 0.0, z},
                     {0.3 * elevation(x, time) / 0.1, 0.0, 0.0}, volume, material);
    };
    for (double y = 0.5 * spacing; y < width; y += spacing) {
        for (double x = 0.5 * spacing; x < scene.domain.size.front(); x += spacing) {
            const double stretch = 1.0 + elevation(x, time) / scene.water.depth;
            for (double z = 0.5 * spacing; z < scene.water.depth; z += spacing)
                add(x, y, z * stretch, share * stretch, Material::water);
            for (double z = 1.0 + 0.5 * spacing; x < 0.5 && z < 1.4; z += spacing)
                add(x, y, z - 0.2 * progress(time), share, Material::rigid);
        }
    }
    return snapshot;
}

std::vector<std::string> body_columns(int dimension) {
    if (dimension == 2) {
        return {"time",
                "body",
                "x",
                "z",
                "angle",
                "velocity_x",
                "velocity_z",
                "spin",
                "fastest",
                "water_force_x",
                "water_force_z",
                "water_torque",
                "contact_force_x",
                "contact_force_z",
                "kinetic",
                "potential",
                "mass"};
    }
    return {"time",       "body",       "x",       "y",       "z",         "rotation_x",
            "rotation_y", "rotation_z", "fastest", "kinetic", "potential", "mass"};
}

void append_body(io::TableWriter& table, int dimension, double time, int number, double mass) {
    const bool moves = number == 1;
    const double z = moves ? 1.2 - 0.2 * progress(time) : 0.3, angle = moves ? 10.0 * progress(time) : 0.0;
    const double fastest = moves && time < 0.8 ? 1.15 * std::sin(M_PI * time / 0.8) : 0.0;
    const double potential = mass * 9.81 * 1.2 - (moves ? 100.0 * progress(time) : 0.0);
    const double n = number;
    if (dimension == 2) {
        table.append(std::array{time, n, 0.25, z, angle, 0.0, 0.0, 0.0, fastest, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
                                potential, mass});
    } else {
        table.append(
            std::array{time, n, 0.25, 0.2, z, 0.6 * angle, 0.8 * angle, 0.0, fastest, 0.0, potential, mass});
    }
}

void write_frames(WrittenRun& run) {
    io::TableWriter bodies = run.table("bodies.csv", body_columns(run.scene.dimension));
    for (int number = 0; number <= 36; ++number) {
        const double time = 0.1 * number;
        append_body(bodies, run.scene.dimension, time, 1, 184.0);
        append_body(bodies, run.scene.dimension, time, 2, 50.0);
        const double lost = 30.0 * progress(time);
        run.add_frame(frame(run.scene, time), 2.0 - 0.5 * lost, 5000.0 - 0.5 * lost, 1.0);
    }
    bodies.finish();
}

}  // namespace

int main(int argc, char** argv) {
    return write_run("write_block_wave", {argv, static_cast<std::size_t>(argc)}, "",
                     [](WrittenRun& run, const std::string&) { write_frames(run); });
}
