// write_calving SCENE RUN CRACK_END: the files of simulate, as a run would leave them in which a crack opens
// 61 m behind the front of a slab of ice, 240 m long and 80 m high, from its top down to CRACK_END m above
// its base: 0 breaks it off. The toe is crushed before. For tests of postprocess in 2D.
#include <cmath>
#include <limits>

#include "written_run.h"

namespace {

using namespace tidewater;

constexpr double length = 240.0, height = 80.0, base = 60.0, crack = 61.0, toe = 10.0;
constexpr float never = std::numeric_limits<float>::quiet_NaN();

struct Ice {
    double damage = 0.0;
    float failure_time = never;
};

// d behind the front and z above the base; the crack runs through at 1.5 s.
Ice ice_at(double d, double z, double crack_end) {
    if (d + z < toe) return {1.0, static_cast<float>(0.1 + 0.01 * d)};
    const double from_crack = std::abs(d - crack);
    const double open = 3.2 + 0.1 * z;  // the band is wider at the top
    if (z < crack_end) return {};
    if (from_crack < open) return {1.0, static_cast<float>(1.5 - 0.005 * z)};
    return {std::max(0.0, 1.0 - (from_crack - open) / 12.0), never};
}

// Frame 0 is at rest; in frame 1 what is in front of the crack has turned by 0.1 and sunk by a metre.
io::Snapshot frame(const scene::Scene& scene, double time, double crack_end) {
    io::Snapshot snapshot;
    snapshot.time = time;
    const double spacing = scene.domain.cell_size / scene.particles.per_axis;
    const auto add = [&](double x, double z, double speed, Material material, const Ice& ice) {
        add_particle(snapshot, {x, 0.0, z}, {speed, 0.0, 0.0}, spacing * spacing, material);
        snapshot.damage.push_back(static_cast<float>(ice.damage));
        snapshot.failure_time.push_back(ice.failure_time);
    };
    for (double z = 0.5 * spacing; z < scene.domain.size.back(); z += spacing) {
        for (double x = 0.5 * spacing; x < scene.domain.size.front(); x += spacing) {
            const bool in_slab = x < length && z > base && z < base + height;
            if (!in_slab && z < scene.water.depth && x > length - 60.0)
                add(x, z, 10.0 * time * std::exp((length - x) / 60.0), Material::water, {});
            if (!in_slab) continue;
            if (time == 0.0) {
                add(x, z, 0.0, Material::ice, {});
                continue;
            }
            const bool off = crack_end == 0.0 && x > length - crack;
            const double angle = off ? -0.1 : 0.0, dx = x - (length - crack), dz = z - base;
            add(x - dx + dx * std::cos(angle) - dz * std::sin(angle) + (off ? 3.0 : 0.0),
                base + dx * std::sin(angle) + dz * std::cos(angle) - (off ? 1.0 : 0.0), 1.0, Material::ice,
                ice_at(length - x, z - base, crack_end));
        }
    }
    return snapshot;
}

}  // namespace

int main(int argc, char** argv) {
    return write_run("write_calving", {argv, static_cast<std::size_t>(argc)}, "CRACK_END",
                     [](WrittenRun& run, const std::string& crack_end) {
                         for (const double time : {0.0, 2.0})
                             run.add_frame(frame(run.scene, time, std::stod(crack_end)), 0.0, 0.0, 0.0);
                     });
}
