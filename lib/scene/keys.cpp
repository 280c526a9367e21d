#include "scene/keys.h"

#include <algorithm>
#include <array>

namespace tidewater::scene {
namespace {

using S = Scene;
using mpm::WaterModel;

constexpr Range positive{.least = 0.0, .open = true};
constexpr Range not_negative{.least = 0.0};

constexpr std::array top_keys{
    Key{.name = "title",
        .member = member<&S::title>(),
        .example = "\"A block falls into the tank\"",
        .stages = postprocess,
        .help = "one line for pictures and reports"},
    Key{.name = "dimension",
        .member = member<&S::dimension>(),
        .range = {.least = 2, .most = 3},
        .help = "2: a vertical slice (x, z); 3: (x, y, z)"},
    Key{.name = "effects",
        .member = member<&S::effects>(),
        .example = "[\"water\", \"rigid\"]",
        .required = true,
        .help = "the physics that is simulated"},
    Key{.name = "seed",
        .member = member<&S::seed>(),
        .stages = geometry | simulate,
        .help = "of all random numbers; the same seed gives the same bytes"},
};

constexpr std::array domain_keys{
    Key{.name = "domain.size",
        .unit = "m",
        .member = member<&S::domain, &S::Domain::size>(),
        .range = positive,
        .example = "[16, 1]",
        .required = true,
        .per_dimension = true,
        .help = "the tank is the box from the origin to size; a whole number of cells"},
    Key{.name = "domain.cell_size",
        .unit = "m",
        .member = member<&S::domain, &S::Domain::cell_size>(),
        .range = positive,
        .example = "0.01",
        .required = true,
        .help = "width Δx of a grid cell; 40 to 50 per smallest length give good waves"},
    Key{.name = "domain.gravity",
        .unit = "m/s²",
        .member = member<&S::domain, &S::Domain::gravity>(),
        .range = not_negative,
        .stages = simulate | postprocess,
        .help = "downward"},
    Key{.name = "domain.wall_left",
        .member = member<&S::domain, &S::Domain::wall_left>(),
        .stages = simulate,
        .help = "what the wall at x = 0 does to what touches it"},
    Key{.name = "domain.wall_right",
        .member = member<&S::domain, &S::Domain::wall_right>(),
        .stages = simulate,
        .help = "at the greatest x"},
    Key{.name = "domain.wall_front",
        .member = member<&S::domain, &S::Domain::wall_front>(),
        .only_3d = true,
        .stages = simulate,
        .help = "at y = 0"},
    Key{.name = "domain.wall_back",
        .member = member<&S::domain, &S::Domain::wall_back>(),
        .only_3d = true,
        .stages = simulate,
        .help = "at the greatest y"},
    Key{.name = "domain.wall_bottom",
        .member = member<&S::domain, &S::Domain::wall_bottom>(),
        .stages = simulate,
        .help = "at z = 0"},
    Key{.name = "domain.wall_top",
        .member = member<&S::domain, &S::Domain::wall_top>(),
        .stages = simulate,
        .help = "at the greatest z"},
};

constexpr std::array water_keys{
    Key{.name = "water.depth",
        .unit = "m",
        .member = member<&S::water, &S::Water::depth>(),
        .range = positive,
        .example = "0.5",
        .effect = "water",
        .required = true,
        .help = "of the water at rest, above the bottom"},
    Key{.name = "water.length",
        .unit = "m",
        .member = member<&S::water, &S::Water::length>(),
        .range = not_negative,
        .effect = "water",
        .stages = geometry | simulate,
        .help = "of the water at the start, from the left wall; 0: the whole tank"},
    Key{.name = "water.density",
        .unit = "kg/m³",
        .member = member<&S::water, &S::Water::model, &WaterModel::density>(),
        .range = positive,
        .effect = "water",
        .stages = simulate,
        .help = "at rest"},
    Key{.name = "water.sound_speed",
        .unit = "m/s",
        .member = member<&S::water, &S::Water::model, &WaterModel::sound_speed>(),
        .range = positive,
        .effect = "water",
        .stages = simulate,
        .help = "at rest; sets the stiffness and the time step; 10 times the fastest flow or more"},
    Key{.name = "water.exponent",
        .member = member<&S::water, &S::Water::model, &WaterModel::exponent>(),
        .range = {.least = 1.0, .most = 20.0, .open = true},
        .effect = "water",
        .stages = simulate,
        .help = "θ of the equation of state"},
};

constexpr std::array block_keys{
    Key{.name = "block.size",
        .unit = "m",
        .member = member<&S::block, &S::Block::size>(),
        .range = positive,
        .example = "[0.5, 0.5]",
        .effect = "rigid",
        .required = true,
        .per_dimension = true,
        .stages = geometry | simulate,
        .help = "edge lengths of the rigid block"},
    Key{.name = "block.center",
        .unit = "m",
        .member = member<&S::block, &S::Block::center>(),
        .example = "[0.25, 0.75]",
        .effect = "rigid",
        .required = true,
        .per_dimension = true,
        .stages = geometry | simulate,
        .help = "at the start"},
    Key{.name = "block.angle",
        .unit = "degrees",
        .member = member<&S::block, &S::Block::angle>(),
        .range = {.least = -360.0, .most = 360.0},
        .effect = "rigid",
        .stages = geometry | simulate,
        .help = "turned in the x–z plane from x towards z"},
    Key{.name = "block.density",
        .unit = "kg/m³",
        .member = member<&S::block, &S::Block::density>(),
        .range = positive,
        .effect = "rigid",
        .stages = simulate,
        .help = "ice: 900 to 920"},
};

constexpr std::array particles_keys{
    Key{.name = "particles.per_axis",
        .member = member<&S::particles, &S::Particles::per_axis>(),
        .range = {.least = 1, .most = 8},
        .stages = simulate,
        .help = "particles per cell and axis: 2 gives 4 per cell in 2D, 8 in 3D"},
    Key{.name = "particles.jitter",
        .member = member<&S::particles, &S::Particles::jitter>(),
        .range = {.least = 0.0, .most = 1.0},
        .stages = simulate,
        .help = "0: a lattice; 1: anywhere within the particle's own share of the cell"},
};

constexpr std::array simulate_keys{
    Key{.name = "simulate.end_time",
        .unit = "s",
        .member = member<&S::simulate, &S::Simulate::end_time>(),
        .range = positive,
        .example = "10",
        .required = true,
        .stages = simulate | postprocess,
        .help = "simulated time"},
    Key{.name = "simulate.snapshot_interval",
        .unit = "s",
        .member = member<&S::simulate, &S::Simulate::snapshot_interval>(),
        .range = positive,
        .example = "0.1",
        .required = true,
        .stages = simulate | postprocess,
        .help = "between snapshots of all particles"},
    Key{.name = "simulate.gauge_interval",
        .unit = "s",
        .member = member<&S::simulate, &S::Simulate::gauge_interval>(),
        .range = positive,
        .stages = simulate | postprocess,
        .help = "between rows of gauges.csv and ledger.csv"},
    Key{.name = "simulate.gauges",
        .unit = "m",
        .member = member<&S::simulate, &S::Simulate::gauges>(),
        .range = not_negative,
        .example = "[2, 4.5]",
        .stages = simulate | postprocess,
        .help = "x of each gauge of the water surface; in 3D on the middle of the tank's width"},
    Key{.name = "simulate.precision",
        .member = member<&S::simulate, &S::Simulate::precision>(),
        .stages = simulate,
        .help = "of the particles and the grid"},
    Key{.name = "simulate.cfl",
        .member = member<&S::simulate, &S::Simulate::cfl>(),
        .range = {.least = 0.0, .most = 1.0, .open = true},
        .stages = simulate,
        .help = "share of a cell that a wave or a particle may cross in one step"},
};

constexpr std::array postprocess_keys{
    Key{.name = "postprocess.gauges",
        .unit = "m",
        .member = member<&S::postprocess, &S::Postprocess::gauges>(),
        .range = not_negative,
        .example = "[2, 4.5]",
        .stages = postprocess,
        .help = "x of further gauges, read from the snapshots"},
    Key{.name = "postprocess.picture_times",
        .unit = "s",
        .member = member<&S::postprocess, &S::Postprocess::picture_times>(),
        .range = not_negative,
        .example = "[0, 0.5, 2]",
        .stages = postprocess,
        .help = "snapshots to draw, the nearest to each time; empty: five, evenly spread"},
    Key{.name = "postprocess.picture_width",
        .unit = "pixels",
        .member = member<&S::postprocess, &S::Postprocess::picture_width>(),
        .range = {.least = 100, .most = 20000},
        .stages = postprocess,
        .help = "of each picture"},
    Key{.name = "postprocess.picture_speed",
        .unit = "m/s",
        .member = member<&S::postprocess, &S::Postprocess::picture_speed>(),
        .range = not_negative,
        .stages = postprocess,
        .help = "upper end of the colour scale; 0: the run's own"},
    Key{.name = "postprocess.arrival_threshold",
        .member = member<&S::postprocess, &S::Postprocess::arrival_threshold>(),
        .range = {.least = 0.0, .most = 1.0, .open = true},
        .stages = postprocess,
        .help = "a wave has arrived at this share of the gauge's greatest amplitude"},
};

std::vector<Key> joined_keys() {
    std::vector<Key> keys;
    const auto append = [&](const auto& section) { keys.insert(keys.end(), section.begin(), section.end()); };
    append(top_keys);
    append(domain_keys);
    append(water_keys);
    append(block_keys);
    append(particles_keys);
    append(simulate_keys);
    append(postprocess_keys);
    return keys;
}

}  // namespace

std::span<const Key> all_keys() {
    static const std::vector<Key> keys = joined_keys();
    return keys;
}

const Key* find_key(std::string_view name) {
    const auto keys = all_keys();
    const auto found = std::ranges::find(keys, name, &Key::name);
    return found == keys.end() ? nullptr : &*found;
}

std::span<const std::string> known_effects() {
    static const std::array<std::string, 2> effects{"water", "rigid"};
    return effects;
}

std::string_view Key::section() const {
    const auto dot = name.find('.');
    return dot == name.npos ? std::string_view() : name.substr(0, dot);
}

std::string_view Key::last_name() const { return name.substr(name.rfind('.') + 1); }

bool Key::applies(const Scene& scene) const {
    return (effect.empty() || scene.has(effect)) && (!only_3d || scene.dimension == 3);
}

}  // namespace tidewater::scene
