// The keys of the particles, and of what the simulation does with them.
#include <array>

#include "scene/keys_parts.h"

namespace tidewater::scene {

template <>
inline constexpr std::array<std::string_view, 2> enum_names<mpm::Transfer>{"apic", "restored"};

namespace {

constexpr std::array keys{
    Key{.name = "particles.per_axis",
        .member = member<&Scene::particles, &Scene::Particles::per_axis>(),
        .range = {.min = 1, .max = 8},
        .stages = by_simulate | by_postprocess,
        .help = "particles per cell and axis: 2 gives 4 per cell in 2D, 8 in 3D"},
    Key{.name = "particles.pattern",
        .member = member<&Scene::particles, &Scene::Particles::pattern>(),
        .stages = by_simulate,
        .help = "lattice: in rows, which particles.jitter may stir; blue_noise: no rows, evenly spread"},
    Key{.name = "particles.jitter",
        .member = member<&Scene::particles, &Scene::Particles::jitter>(),
        .range = {.min = 0.0, .max = 1.0},
        .stages = by_simulate,
        .help = "0: a lattice; 1: anywhere within the particle's own share of the cell"},

    Key{.name = "simulate.end_time",
        .unit = "s",
        .member = member<&Scene::simulate, &Scene::Simulate::end_time>(),
        .range = positive,
        .example = "10",
        .required = true,
        .stages = by_simulate | by_postprocess,
        .help = "simulated time"},
    Key{.name = "simulate.snapshot_interval",
        .unit = "s",
        .member = member<&Scene::simulate, &Scene::Simulate::snapshot_interval>(),
        .range = positive,
        .example = "0.1",
        .required = true,
        .stages = by_simulate | by_postprocess,
        .help = "between snapshots of all particles"},
    Key{.name = "simulate.gauge_interval",
        .unit = "s",
        .member = member<&Scene::simulate, &Scene::Simulate::gauge_interval>(),
        .range = not_negative,
        .stages = by_simulate | by_postprocess,
        .help = "between rows of gauges.csv and ledger.csv; 0: a tenth of snapshot_interval, or sound's way "
                "of ten "
                "cells where that is longer"},
    Key{.name = "simulate.gauges",
        .unit = "m",
        .member = member<&Scene::simulate, &Scene::Simulate::gauges>(),
        .range = not_negative,
        .example = "[2, 4.5]",
        .stages = by_all,  // the picture of the geometry shows them
        .help = "x of each gauge of the water surface; in 3D on the middle of the tank's width, or [x, y]"},
    Key{.name = "simulate.pressure_gauges",
        .unit = "m",
        .member = member<&Scene::simulate, &Scene::Simulate::pressure_gauges>(),
        .range = not_negative,
        .example = "[[1.61, 0.003]]",
        .stages = by_simulate | by_postprocess,
        .help = "[x, z] of each gauge of the water's pressure, in 3D [x, y, z]; gives pressures.csv"},
    Key{.name = "simulate.precision",
        .member = member<&Scene::simulate, &Scene::Simulate::precision>(),
        .stages = by_simulate,
        .help = "of the particles and the grid"},
    Key{.name = "simulate.cfl",
        .member = member<&Scene::simulate, &Scene::Simulate::cfl>(),
        .range = {.min = 0.0, .max = 1.0, .open = true},
        .stages = by_simulate,
        .help = "share of a cell that a wave or a particle may cross in one step"},
    Key{.name = "simulate.transfer",
        .member = member<&Scene::simulate, &Scene::Simulate::transfer>(),
        .stages = by_simulate,
        .help = "between particles and grid; restored damps short waves and the flow around blocks "
                "less, at about twice the cost"},
    Key{.name = "simulate.checkpoint_interval",
        .unit = "s",
        .member = member<&Scene::simulate, &Scene::Simulate::checkpoint_interval>(),
        .range = not_negative,
        .stages = by_simulate,
        .changes_results = false,
        .help = "of wall time between checkpoints, from which a stopped run goes on; 0: only when stopped"},
};

}  // namespace

std::span<const Key> simulate_keys() { return keys; }

}  // namespace tidewater::scene
