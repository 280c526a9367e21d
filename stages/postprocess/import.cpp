#include "import.h"

#include <cmath>
#include <cstdio>
#include <string>

#include "common/tank.h"
#include "core/error.h"
#include "io/particle_list.h"
#include "io/text.h"

namespace tidewater::postprocess {
namespace {

// Ice or water, where the scene has only one of them and no blocks.
std::optional<Material> only_material(const scene::Scene& scene) {
    if (scene.has("rigid") || scene.has("ice") == scene.has("water")) return {};
    return scene.has("ice") ? Material::ice : Material::water;
}

std::array<double, 3> origin_of(const ParticleOptions& options) {
    const auto& origin = options.origin;
    if (origin.empty()) return {};
    if (origin.size() != 3)
        throw SceneError("--origin: needs x,y,z in the files' axes, as --origin=-1,0,0.5");
    return {origin[0], origin[1], origin[2]};
}

io::ParticleImport make_import(const StageContext& context) {
    const scene::Scene& scene = context.scene;
    const ParticleOptions& options = context.particles;
    io::ParticleImport import{.dimension = scene.dimension,
                              .map = {},
                              .materials = {},
                              .y_up = options.up == "y",
                              .origin = origin_of(options),
                              .material = only_material(scene),
                              .volume = std::pow(particle_spacing(scene), scene.dimension)};
    if (!options.map.empty()) import.map = io::parse_column_map(options.map);
    if (!options.materials.empty()) import.materials = io::parse_material_numbers(options.materials);
    return import;
}

// All that decides what a file is read as, for the stamps of what is made from it.
std::string settings_text(const ParticleOptions& options, const io::ParticleImport& import) {
    std::string text = options.map + "\n" + options.materials + "\n" + options.up;
    for (const double x : import.origin) text += " " + io::format_number(x);
    return text;
}

void tell_outside(const io::Snapshot& snapshot, const scene::Scene& scene) {
    const auto size = make_tank(scene).size;
    std::size_t outside = 0;
    for (std::size_t p = 0; p < snapshot.particle_count(); ++p) {
        const float* x = snapshot.points.data() + 3 * p;
        const bool inside = x[0] >= 0 && x[0] <= size[0] && x[2] >= 0 && x[2] <= size[2] &&
                            (scene.dimension == 2 || (x[1] >= 0 && x[1] <= size[1]));
        outside += inside ? 0 : 1;
    }
    if (outside == 0) return;
    std::printf(
        "%zu of %zu particles lie outside of the scene's tank (domain.size); --origin and --up say where it "
        "is\n",
        outside, snapshot.particle_count());
}

}  // namespace

Frames import_frames(const StageContext& context) {
    const io::ParticleImport import = make_import(context);
    const io::ParticleList list = io::list_particles(context.particles.files, context.particles.times);
    if (!list.note.empty()) std::puts(list.note.c_str());
    std::vector<std::string> notes;
    const io::Snapshot first = io::read_particle_file(list.files.front(), import, &notes);
    for (const std::string& note : notes) std::puts(note.c_str());
    tell_outside(first, context.scene);
    return {.files = list.files,
            .times = list.times,
            .import = import,
            .import_text = settings_text(context.particles, import),
            .first_count = first.particle_count()};
}

}  // namespace tidewater::postprocess
