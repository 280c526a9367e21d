// The keys of what is asked of a run that is done: gauges, pictures, icebergs.
#include "scene/keys_parts.h"

namespace tidewater::scene {
namespace {

using S = Scene;

constexpr std::array keys{
    Key{.name = "postprocess.gauges",
        .unit = "m",
        .member = member<&S::postprocess, &S::Postprocess::gauges>(),
        .range = not_negative,
        .example = "[2, 4.5]",
        .stages = by_postprocess,
        .help = "further gauges like simulate.gauges, read from the snapshots"},
    Key{.name = "postprocess.picture_times",
        .unit = "s",
        .member = member<&S::postprocess, &S::Postprocess::picture_times>(),
        .range = not_negative,
        .example = "[0, 0.5, 2]",
        .stages = by_postprocess,
        .help = "snapshots to draw, the nearest to each time; empty: five, evenly spread"},
    Key{.name = "postprocess.picture_interval",
        .unit = "s",
        .member = member<&S::postprocess, &S::Postprocess::picture_interval>(),
        .range = not_negative,
        .stages = by_postprocess,
        .help = "between snapshots to draw, from the first on, instead of picture_times; 0: picture_times"},
    Key{.name = "postprocess.picture_width",
        .unit = "pixels",
        .member = member<&S::postprocess, &S::Postprocess::picture_width>(),
        .range = {.least = 400, .most = 8000},
        .stages = by_postprocess,
        .help = "of each picture"},
    Key{.name = "postprocess.picture_speed",
        .unit = "m/s",
        .member = member<&S::postprocess, &S::Postprocess::picture_speed>(),
        .range = not_negative,
        .stages = by_postprocess,
        .help = "upper end of the colour scale; 0: the run's own"},
    Key{.name = "postprocess.picture_window",
        .unit = "m",
        .member = member<&S::postprocess, &S::Postprocess::picture_window>(),
        .range = not_negative,
        .example = "[0, 0, 5, 1.6]",
        .stages = by_postprocess,
        .help = "x0, z0, x1, z1 of the part of the tank to draw, in 2D; empty: the whole tank"},
    Key{.name = "postprocess.decimation",
        .member = member<&S::postprocess, &S::Postprocess::decimation>(),
        .range = {.least = 0.0, .most = 1e6},
        .stages = by_postprocess,
        .help = "one particle in so many goes to ParaView, in every frame the same ones; 1: all, 0: none"},
    Key{.name = "postprocess.surfaces",
        .member = member<&S::postprocess, &S::Postprocess::surfaces>(),
        .stages = by_postprocess,
        .help = "whether surfaces of the water, icebergs and blocks are made for ParaView"},
    Key{.name = "postprocess.arrival_threshold",
        .member = member<&S::postprocess, &S::Postprocess::arrival_threshold>(),
        .range = {.least = 0.0, .most = 1.0, .open = true},
        .stages = by_postprocess,
        .help = "a wave has arrived at this share of the gauge's greatest amplitude"},
    Key{.name = "postprocess.iceberg_damage",
        .member = member<&S::postprocess, &S::Postprocess::iceberg_damage>(),
        .range = {.least = 0.0, .most = 1.0, .open = true},
        .effect = "fracture",
        .stages = by_postprocess,
        .help = "ice that has lost this share of its strength connects no fragments"},
    Key{.name = "postprocess.iceberg_share",
        .member = member<&S::postprocess, &S::Postprocess::iceberg_share>(),
        .range = {.least = 0.0, .most = 100.0, .open = true},
        .effect = "fracture",
        .stages = by_postprocess,
        .help = "least volume of an iceberg over height² × width of the ice; what is smaller is a crumb"},
};

}  // namespace

std::span<const Key> postprocess_keys() { return keys; }

}  // namespace tidewater::scene
