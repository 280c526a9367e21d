#include "run_up.h"

#include <array>
#include <cmath>

#include "analysis/decay.h"
#include "io/table.h"
#include "io/text.h"

namespace tidewater::postprocess {

void write_run_up(const std::filesystem::path& path, const Surfaces& surfaces, const Provenance& provenance) {
    io::TableWriter table(path, provenance, {"time", "x", "y", "height", "at_wall"});
    for (const FarEnd& end : surfaces.far_end) {
        table.append(std::array{end.time, end.waterline.x, end.y, end.waterline.height,
                                end.waterline.at_wall ? 1.0 : 0.0});
    }
    table.finish();
}

std::string describe_run_up(const Surfaces& surfaces, const scene::Scene& scene) {
    const FarEnd* highest = nullptr;
    for (const FarEnd& end : surfaces.far_end) {
        if (std::isnan(end.waterline.height)) continue;
        if (!highest || end.waterline.height > highest->waterline.height) highest = &end;
    }
    if (!highest) return {};
    const std::string height = io::format_fixed(highest->waterline.height, 3) + " m",
                      time = " at " + io::format_fixed(highest->time, 2) + " s";
    if (highest->waterline.at_wall) {
        const bool damped = scene.has("sponge") || scene.has("outlet");
        return "at the far wall the water rose to " + height + time +
               (damped ? ", behind what takes up the waves" : "") + "\n";
    }
    return "run-up on the far shore: " + height + time +
           ", x = " + io::format_fixed(highest->waterline.x, 2) + " m\n";
}

}  // namespace tidewater::postprocess
