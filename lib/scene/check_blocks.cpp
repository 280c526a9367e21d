// The checks of the rigid blocks: each alone, and against what else takes up room.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

constexpr double fine_cells = 10.0;  // along the least edge; fewer give a coarse wave

// Half the extent along each axis of the scene of the box around the turned block.
std::vector<double> reach_of(const Scene& scene, const Scene::Block& block) {
    const geometry::Point reach = geometry::reach(block_box(scene, block));
    return scene.dimension == 2 ? std::vector<double>{reach[0], reach[2]}
                                : std::vector<double>{reach[0], reach[1], reach[2]};
}

// Whether the block's place is known.
bool placed(const Reading& reading, std::size_t block) {
    const auto known = [&](const char* name) {
        return reading.usable({block_key(reading.scene, block, name)});
    };
    return known("size") && known("center") && known("angle");
}

void check_inside(Reading& reading, std::size_t n) {
    const Scene& scene = reading.scene;
    const Scene::Block& block = scene.blocks[n];
    const auto reach = reach_of(scene, block);
    for (std::size_t axis = 0; axis < reach.size(); ++axis) {
        const double low = block.center[axis] - reach[axis];
        const double high = block.center[axis] + reach[axis];
        const double slack = tolerance * scene.domain.cell_size;
        if (low >= -slack && high <= scene.domain.size[axis] + slack) continue;
        reading.report(block_key(scene, n, "center"),
                       block_name(scene, n) + " lies outside the tank: along " +
                           axis_name(axis, scene.dimension) + " it reaches from " +
                           metres(short_number(low)) + " to " + metres(short_number(high)) +
                           ", the tank from 0 m to " + metres(scene.domain.size[axis]) + "; move " +
                           block_key(scene, n, "center") + " or shrink " + block_key(scene, n, "size"));
    }
}

void report_overlap(Reading& reading, std::size_t n, const std::string& other, double depth) {
    reading.report(block_key(reading.scene, n, "center"),
                   block_name(reading.scene, n) + " and " + other + " share room: they overlap by " +
                       metres(short_number(depth)) + "; move them apart");
}

void check_overlaps(Reading& reading, std::size_t n) {
    const Scene& scene = reading.scene;
    const double slack = tolerance * scene.domain.cell_size;
    const geometry::Box box = block_box(scene, scene.blocks[n]);
    const auto check = [&](const geometry::Box& other, const std::string& name) {
        const double depth = -geometry::separation(box, other);
        if (depth > slack) report_overlap(reading, n, name, depth);
    };
    for (std::size_t other = 0; other < n; ++other) {
        if (placed(reading, other)) check(block_box(scene, scene.blocks[other]), block_name(scene, other));
    }
    if (scene.has("ice") && reading.usable({"ice.size", "ice.corner"})) check(ice_box(scene), "the ice");
    if (!scene.has("bed") || !reading.usable({"bed.profile"})) return;
    const double depth = geometry::rise_into(bed_profile(scene), box);
    if (depth > slack) report_overlap(reading, n, "the ground (bed.profile)", depth);
}

void check_friction(Reading& reading, std::size_t n) {
    const Scene& scene = reading.scene;
    const std::string contact = block_key(scene, n, "contact"), friction = block_key(scene, n, "friction");
    if (!reading.usable({contact, friction})) return;
    if (scene.blocks[n].contact == mpm::BodyContact::slip || scene.blocks[n].friction == 0.0) return;
    reading.report(friction, "is not read with contact = \"stick\"; remove it or set contact = \"slip\"");
}

std::string thin_warning(const Scene& scene, std::size_t n) {
    const double edge = *std::ranges::min_element(scene.blocks[n].size), cell = scene.domain.cell_size;
    if (edge >= (fine_cells - tolerance) * cell) return {};
    return block_key(scene, n, "size") + ": " + block_name(scene, n) + " is " +
           number_text(short_number(edge / cell)) + " cells thick, and its wave will be coarse; cells of " +
           metres(short_number(edge / fine_cells)) + " would give it " + number_text(fine_cells);
}

}  // namespace

std::string block_key(const Scene& scene, std::size_t block, std::string_view name) {
    const std::string number = scene.blocks.size() > 1 ? std::to_string(block + 1) + "." : "";
    return "block." + number + std::string(name);
}

std::string block_name(const Scene& scene, std::size_t block) {
    return scene.blocks.size() > 1 ? "block " + std::to_string(block + 1) : "the block";
}

void check_blocks(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"effects"}) || !scene.has("rigid")) return;
    const bool tank = reading.usable({"dimension", "domain.size", "domain.cell_size"});
    const bool ground = !scene.has("bed") || scene.bed.profile.size() % 2 == 0;
    for (std::size_t n = 0; n < scene.blocks.size(); ++n) {
        check_friction(reading, n);
        if (!tank || !placed(reading, n)) continue;
        check_inside(reading, n);
        if (ground) check_overlaps(reading, n);
    }
}

std::vector<std::string> block_warnings(const Scene& scene) {
    std::vector<std::string> warnings;
    for (std::size_t n = 0; n < scene.blocks.size(); ++n) warnings.push_back(thin_warning(scene, n));
    return warnings;
}

// By its start, and by the fall of its lowest corner to the still level, √(v² + 2 g f), or by its own height,
// as it sinks or topples, √(2 g h).
double fastest_block(const Scene& scene) {
    const double level = scene.water.depth + scene.wave.height, gravity = scene.domain.gravity;
    double fastest = 0.0;
    for (const Scene::Block& block : scene.blocks) {
        double squares = 0.0, diagonal = 0.0;
        for (const double along : block.velocity) squares += along * along;
        for (const double edge : block.size) diagonal += edge * edge;
        const double spin = std::abs(block.spin) * std::numbers::pi / 180.0;
        const double start = std::sqrt(squares) + 0.5 * spin * std::sqrt(diagonal);
        const double half_height = reach_of(scene, block).back();
        const double fall = std::max(block.center.back() - half_height - level, 0.0);
        fastest = std::max({fastest, std::sqrt(start * start + 2.0 * gravity * fall),
                            std::sqrt(4.0 * gravity * half_height)});
    }
    return fastest;
}

}  // namespace tidewater::scene
