#include <cmath>

#include "glacier.h"
#include "io/text.h"

namespace tidewater {
namespace {

constexpr double worth_telling = 0.1;  // of what was asked

std::string metres(double length) { return io::format_fixed(length, 1) + " m"; }

std::string range_text(const geometry::CrevasseStatistics::Range& range) {
    return io::format_fixed(range.least, 1) + " to " + metres(range.greatest) + " (mean " +
           io::format_fixed(range.mean, 1) + ")";
}

// "  depth: mean 39 m instead of 35 m …", where it is off.
std::string told_if_off(const std::string& what, double made, double asked) {
    if (std::abs(made - asked) <= worth_telling * asked) return {};
    return "  note: their mean " + what + " is " + metres(made) + ", " + metres(asked) +
           " was asked for; there are few of them, another seed gives others\n";
}

std::string describe(const geometry::CrevasseStatistics& made, const scene::Scene& scene) {
    const auto& asked = scene.crevasses;
    const std::string unit = scene.dimension == 2 ? " m²" : " m³";
    std::string text = "  crevasses: " + std::to_string(made.count) + ", depth " + range_text(made.depth) +
                       ", opening " + range_text(made.opening);
    if (made.count > 1) text += ", spacing " + range_text(made.spacing);
    text += ", " + io::format_fixed(made.volume, 0) + unit + " below a level surface\n";
    if (made.count == 0) return text;
    text += told_if_off("depth", made.depth.mean, 0.5 * (asked.depth[0] + asked.depth[1]));
    text += told_if_off("opening", made.opening.mean, 0.5 * (asked.opening[0] + asked.opening[1]));
    if (made.spacing.mean > 0.0) text += told_if_off("spacing", made.spacing.mean, asked.spacing);
    return text;
}

std::string describe(const geometry::CrackStatistics& made, const Glacier& glacier,
                     const scene::Scene& scene) {
    const bool empty = scene.cracks.cohesion == 0.0;
    const double share = made.wall_density * scene.cracks.width;
    std::string text = "  cracks: Voronoi cells of r = " + metres(made.cell_size) + " (" +
                       metres(scene.cracks.cell_size) + " asked), " + std::to_string(made.pieces) +
                       " pieces in the ice's box, " + metres(made.diameter_mean) + " across (± " +
                       metres(made.diameter_deviation) + ")\n";
    text +=
        "  the cracks, " + metres(scene.cracks.width) + " wide, " +
        (empty ? "are empty"
               : "have " + io::format_fixed(100.0 * scene.cracks.cohesion, 0) + " % of the ice's strength") +
        " and take " + io::format_fixed(100.0 * share, 2) + " % of it, " +
        io::format_fixed(share * glacier.volume, 0) + (scene.dimension == 2 ? " m²\n" : " m³\n");
    if (made.cells > 0) text += told_if_off("cell size", made.cell_size, scene.cracks.cell_size);
    return text;
}

}  // namespace

std::string describe_cuts(const Glacier& glacier, const scene::Scene& scene) {
    std::string text;
    if (glacier.crevasses) text += describe(statistics(*glacier.crevasses), scene);
    if (glacier.cracks)
        text += describe(statistics(*glacier.cracks, geometry::CrackFinder(*glacier.cracks)), glacier, scene);
    return text;
}

}  // namespace tidewater
