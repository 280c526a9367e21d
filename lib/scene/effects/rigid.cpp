#include "scene/effects/rigid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scene/effects/effect.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {

template <>
inline constexpr std::array<std::string_view, 2> enum_names<mpm::BodyContact>{"stick", "slip"};

namespace {

constexpr double fine_cells = 10.0;  // along the shortest edge; fewer give a coarse wave

constexpr std::array keys{
    Key{.name = "block.size",
        .unit = "m",
        .member = item_member<&Scene::blocks, &Block::size>(),
        .range = positive,
        .example = "[0.5, 0.5]",
        .effect = "rigid",
        .required = true,
        .per_dimension = true,
        .stages = by_geometry | by_simulate,
        .help = "edge lengths of the rigid block; [[block]] once for each of several blocks, and --set "
                "block.2.size for the second, block.size for all"},
    Key{.name = "block.center",
        .unit = "m",
        .member = item_member<&Scene::blocks, &Block::center>(),
        .example = "[0.25, 0.75]",
        .effect = "rigid",
        .required = true,
        .per_dimension = true,
        .stages = by_geometry | by_simulate,
        .help = "at the start"},
    Key{.name = "block.angle",
        .unit = "degrees",
        .member = item_member<&Scene::blocks, &Block::angle>(),
        .range = {.min = -360.0, .max = 360.0},
        .effect = "rigid",
        .stages = by_geometry | by_simulate,
        .help = "turned in the x–z plane from x towards z"},
    Key{.name = "block.density",
        .unit = "kg/m³",
        .member = item_member<&Scene::blocks, &Block::density>(),
        .range = positive,
        .effect = "rigid",
        .stages = by_simulate,
        .help = "ice: 900 to 920"},
    Key{.name = "block.contact",
        .member = item_member<&Scene::blocks, &Block::contact>(),
        .effect = "rigid",
        .stages = by_simulate,
        .help = "how water meets it: it slides along the block and may part from it, or moves as its "
                "surface does"},
    Key{.name = "block.friction",
        .member = item_member<&Scene::blocks, &Block::friction>(),
        .range = not_negative,
        .effect = "rigid",
        .stages = by_simulate,
        .help = "Coulomb's coefficient of contact = \"slip\""},
    Key{.name = "block.drag",
        .member = item_member<&Scene::blocks, &Block::drag>(),
        .range = not_negative,
        .effect = "rigid",
        .stages = by_simulate,
        .help =
            "of water along its faces with contact = \"slip\", tau = drag rho u²; 0.002 to 0.005 in nature"},
    Key{.name = "block.velocity",
        .unit = "m/s",
        .member = item_member<&Scene::blocks, &Block::velocity>(),
        .example = "[1, 0]",
        .effect = "rigid",
        .per_dimension = true,
        .stages = by_simulate,
        .help = "at the start; empty: at rest"},
    Key{.name = "block.spin",
        .unit = "degrees/s",
        .member = item_member<&Scene::blocks, &Block::spin>(),
        .effect = "rigid",
        .stages = by_simulate,
        .help = "at the start, from x towards z about its centre"},
};

// "block.size", or "block.2.size" for the second of several.
std::string block_key(const Scene& scene, std::size_t block, std::string_view name) {
    const std::string number = scene.blocks.size() > 1 ? std::to_string(block + 1) + "." : "";
    return "block." + number + std::string(name);
}

// "the block", "block 2".
std::string block_name(const Scene& scene, std::size_t block) {
    return scene.blocks.size() > 1 ? "block " + std::to_string(block + 1) : "the block";
}

// Half the extent along each axis of the scene of the box around the turned block.
std::vector<double> reach_of(const Scene& scene, const Block& block) {
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

// A block without a velocity starts at rest.
void derive(Reading& reading) {
    if (!reading.usable({"dimension"})) return;
    for (Block& block : reading.scene.blocks) {
        if (block.velocity.empty())
            block.velocity.assign(static_cast<std::size_t>(reading.scene.dimension), 0.0);
    }
}

void check_inside(Reading& reading, std::size_t n) {
    const Scene& scene = reading.scene;
    const Block& block = scene.blocks[n];
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
    reading.report(block_key(reading.scene, n, "center"), block_name(reading.scene, n) + " and " + other +
                                                              " overlap by " + metres(short_number(depth)) +
                                                              "; move them apart");
}

void check_overlaps(Reading& reading, std::size_t n) {
    const Scene& scene = reading.scene;
    const double slack = tolerance * scene.domain.cell_size;
    const geometry::Box box = block_box(scene, scene.blocks[n]);
    const auto check_box = [&](const geometry::Box& other, const std::string& name) {
        const double depth = -geometry::separation(box, other);
        if (depth > slack) report_overlap(reading, n, name, depth);
    };
    for (std::size_t other = 0; other < n; ++other) {
        if (placed(reading, other))
            check_box(block_box(scene, scene.blocks[other]), block_name(scene, other));
    }
    if (ice_box_known(reading)) check_box(ice_box(scene), "the ice");
    if (!bed_profile_known(reading)) return;
    const double depth = geometry::rise_into(bed_profile(scene), box);
    if (depth > slack) report_overlap(reading, n, "the ground (bed.profile)", depth);
}

// Friction and drag act on what slides along the block.
void check_sliding(Reading& reading, std::size_t n) {
    const Scene& scene = reading.scene;
    const Block& block = scene.blocks[n];
    const std::string contact = block_key(scene, n, "contact");
    const auto refuse = [&](const char* name, double value) {
        const std::string key = block_key(scene, n, name);
        if (!reading.usable({contact, key})) return;
        if (block.contact == mpm::BodyContact::slip || value == 0.0) return;
        reading.report(key, "is not read with contact = \"stick\"; remove it or set contact = \"slip\"");
    };
    refuse("friction", block.friction);
    refuse("drag", block.drag);
}

void check(Reading& reading) {
    for (const char* boundary : {"shelf", "push", "piston"}) {
        refuse_pair(reading, "rigid", boundary,
                    "a rigid block touches only water, ice, a bed and the tank's walls so far");
    }
    const bool tank = reading.usable({"dimension", "domain.size", "domain.cell_size"});
    for (std::size_t n = 0; n < reading.scene.blocks.size(); ++n) {
        check_sliding(reading, n);
        if (!tank || !placed(reading, n)) continue;
        check_inside(reading, n);
        check_overlaps(reading, n);
    }
}

std::string thin_warning(const Scene& scene, std::size_t n) {
    const double edge = *std::ranges::min_element(scene.blocks[n].size), cell = scene.domain.cell_size;
    if (edge >= (fine_cells - tolerance) * cell) return {};
    return block_key(scene, n, "size") + ": " + block_name(scene, n) + " is " +
           number_text(short_number(edge / cell)) + " cells thick, and its wave will be coarse; cells of " +
           metres(short_number(edge / fine_cells)) + " would give it " + number_text(fine_cells);
}

std::vector<std::string> warnings(const Scene& scene) {
    std::vector<std::string> lines;
    for (std::size_t n = 0; n < scene.blocks.size(); ++n) lines.push_back(thin_warning(scene, n));
    return lines;
}

std::vector<Body> bodies(const Scene& scene) {
    std::vector<Body> all;
    for (std::size_t n = 0; n < scene.blocks.size(); ++n) {
        Body body{block_name(scene, n), {}};
        for (const double edge : scene.blocks[n].size)
            body.edges.push_back({edge, block_key(scene, n, "size")});
        all.push_back(body);
    }
    return all;
}

}  // namespace

geometry::Box block_box(const Scene& scene, const Block& block) {
    return make_box(scene, block.center, block.size, block.angle);
}

// By its start, and by the fall of its lowest corner to the still level, √(v² + 2 g f), or by its own height,
// as it sinks or topples, √(2 g h).
double fastest_block(const Scene& scene) {
    const double level = scene.water.depth + scene.wave.height, gravity = scene.domain.gravity;
    double fastest = 0.0;
    for (const Block& block : scene.blocks) {
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

constinit const Effect rigid_effect{
    .name = "rigid", .keys = keys, .derive = derive, .check = check, .warnings = warnings, .bodies = bodies};

}  // namespace tidewater::scene
