#include "inputs.h"

#include <cstdio>
#include <string>

#include "surface.h"

namespace tidewater::postprocess {
namespace {

// The table, or what there is of it while simulate writes it; nothing, with a line, if there is neither or no
// row yet.
std::optional<std::filesystem::path> find_table(const StageContext& context, const std::string& name,
                                                const std::string& without) {
    const auto whole = context.run / "simulate" / name;
    for (const auto& path : {whole, std::filesystem::path(whole.string() + ".part")}) {
        if (!std::filesystem::exists(path)) continue;
        if (io::read_table(path).row_count() > 0 || path == whole) return path;
    }
    std::puts(("no " + name + ", and so " + without + "; run tidewater-simulate again").c_str());
    return {};
}

std::vector<Body> find_bodies(const StageContext& context) {
    if (!makes_first_wave(context.scene)) return {};
    const auto path = find_table(context, "bodies.csv", "nothing of the block's wave");
    if (!path) return {};
    std::vector<Body> bodies = read_bodies(*path);
    slide_of(heaviest(bodies), context.scene);  // so that what is wrong is told before anything is removed
    return bodies;
}

Ground find_ground(const StageContext& context) {
    const auto path = geometry_file(context);
    const bool from_model = context.scene.has("bed") && context.scene.bed.profile.empty();
    if (!from_model || std::filesystem::exists(path)) return read_ground(context.scene, path);
    std::puts(("no " + path.string() + ", and so no ground in pictures and below gauges").c_str());
    return {};
}

}  // namespace

Inputs read_inputs(const StageContext& context) {
    Inputs inputs;
    inputs.ground = find_ground(context);
    if (!context.particles.files.empty()) return inputs;
    if (const auto path = find_table(context, "gauges.csv", "no gauges but postprocess.gauges"))
        inputs.gauges = read_run_gauges(*path);
    if (const auto path = find_table(context, "ledger.csv", "no energy")) {
        inputs.ledger = io::read_table(*path);
        inputs.ledger_file = *path;
    }
    inputs.bodies = find_bodies(context);
    if (const auto path = context.run / "simulate" / "run.json"; std::filesystem::exists(path))
        inputs.facts = io::read_run_facts(path);
    return inputs;
}

}  // namespace tidewater::postprocess
