// write_icebergs SCENE RUN: the files of simulate, as a run would leave them in which the front 30 m of a
// glacier, 100 m long and 40 m high, come off at 1 s, split in two at 2 s, of which the smaller grows to the
// glacier again at 3 s and the larger melts away at 4 s, beside 250 boxes of sizes by a power law of exponent
// 2 from 60 m² on. For tests of postprocess in 2D.
#include <cmath>
#include <limits>

#include "written_run.h"

namespace {

using namespace tidewater;

constexpr double length = 100.0, height = 40.0, base = 60.0, front = 30.0, small_piece = 10.0,
                 smallest_box = 60.0;
constexpr int boxes = 250;
constexpr float never = std::numeric_limits<float>::quiet_NaN();

struct Motion {
    double x = 0.0, speed_x = 0.0, speed_z = 0.0;  // how far it has moved, m, and with which velocity, m/s
    bool intact = true;
};

// d behind the front.
Motion motion(double d, int frame) {
    if (d > front || frame == 0) return {};
    const bool small = d > front - small_piece;  // the rear part of what comes off
    if (frame == 1) return {8.0, 1.5, -0.25};
    if (small) return {frame == 2 ? 8.0 : 0.0, 0.0, 0.0};
    return {14.0, 1.5, -0.25, frame < 4};
}

io::Snapshot frame(const scene::Scene& scene, int number, const std::vector<double>& sizes) {
    io::Snapshot snapshot;
    snapshot.time = number;
    const double spacing = scene.domain.cell_size / scene.particles.per_axis;
    const auto add = [&](double x, double z, const Motion& m) {
        add_particle(snapshot, {x + m.x, 0.0, z}, {m.speed_x, 0.0, m.speed_z}, spacing * spacing,
                     Material::ice);
        snapshot.damage.push_back(m.intact ? 0.0f : 1.0f);
        snapshot.failure_time.push_back(m.intact ? never : 3.5f);
    };
    for (double z = base + 0.5 * spacing; z < base + height; z += spacing) {
        for (double x = 0.5 * spacing; x < length; x += spacing) add(x, z, motion(length - x, number));
    }
    double left = length + 60.0;
    for (const double size : sizes) {
        const double across = std::round(std::sqrt(size));
        for (int i = 0; i < static_cast<int>(std::lround(size));
             ++i) {  // row by row; the last one is cut short
            const double up = std::floor(i / across), along = i - across * up;
            add(left + spacing * along, 50.0 + spacing * up, {});
        }
        left += spacing * across + 2.5;
    }
    return snapshot;
}

void write_frames(WrittenRun& run) {
    std::vector<double> sizes;  // the law's quantiles, so that no chance of drawing comes in
    for (int i = 0; i < boxes; ++i) sizes.push_back(smallest_box / (1.0 - (i + 0.5) / boxes));
    for (int number = 0; number < 5; ++number) run.add_frame(frame(run.scene, number, sizes), 0.0, 0.0, 0.0);
}

}  // namespace

int main(int argc, char** argv) {
    return write_run("write_icebergs", {argv, static_cast<std::size_t>(argc)}, "",
                     [](WrittenRun& run, const std::string&) { write_frames(run); });
}
