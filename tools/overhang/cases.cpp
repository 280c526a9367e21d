#include "cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "core/error.h"
#include "io/table.h"
#include "io/text.h"
#include "mpm/boundaries/boundaries.h"
#include "mpm/materials/ice.h"
#include "scene/scene.h"

namespace tidewater::overhang {
namespace {

struct Slab {
    double height, base;  // m; base: z of its lower side
    mpm::IceModel model;
};

Slab slab_of(const scene::Scene& scene) {
    return {.height = scene.ice.size.back(), .base = scene.ice.corner.back(), .model = ice_model(scene)};
}

std::string run_name(const std::filesystem::path& run) {
    const auto whole = std::filesystem::weakly_canonical(run);
    return whole.filename().string();
}

void require_file(const std::filesystem::path& path) {
    if (std::filesystem::exists(path)) return;
    throw InputError(path.string() +
                     ": the file does not exist; run tidewater-postprocess on a run whose ice fractures");
}

// Of the ice beyond the shelf's edge, m.
double overhang_length(const scene::Scene& scene, double time) {
    if (!scene.has("shelf") || !scene.has("push")) return analysis::none;
    const mpm::Push push{.speed = scene.push.speed, .ramp = scene.push.ramp};
    const double rear = std::max(scene.ice.corner.front(), push.position(time));  // it meets the ice there
    return rear + scene.ice.size.front() - scene.shelf.length;
}

auto order(const Case& c) {
    return std::tuple(c.overhang.height, c.strength, c.uniaxial_strength, c.overhang.ice_density,
                      c.overhang.water_density, c.overhang.gravity);
}

double error_percent(double value, double reference) { return 100.0 * (value / reference - 1.0); }

}  // namespace

bool Case::came_off() const { return std::isfinite(length_ratio); }

bool Case::alike(const Case& other) const { return order(*this) == order(other); }

Case read_case(const std::filesystem::path& run) {
    const auto scene_path = run / "postprocess" / "scene.toml";
    const auto path = run / "postprocess" / "first_iceberg.csv";
    require_file(path);
    require_file(scene_path);
    const scene::Scene scene = scene::read_scene(scene_path);
    if (!scene.has("ice"))
        throw InputError(scene_path.string() +
                         ": has no ice, and so no iceberg; name runs of scenes with ice");
    const Slab slab = slab_of(scene);
    const double depth = scene.has("water") ? scene.water.depth - slab.base : 0.0;
    Case result{.name = run_name(run),
                .overhang = {.height = slab.height,
                             .depth = std::max(depth, 0.0),
                             .ice_density = slab.model.density,
                             .water_density = scene.water.model.density,
                             .gravity = scene.domain.gravity},
                .strength = slab.model.beta_p0,
                .uniaxial_strength = slab.model.uniaxial_strength(scene.dimension)};
    const io::Table table = io::read_table(path);
    const auto value = [&](const char* column) {
        const auto& values = io::require_column(table, column, path);
        if (values.size() == 1) return values.front();
        throw InputError(path.string() + ": it must have one row; run tidewater-postprocess again");
    };
    result.time = value("time");
    result.length_ratio = value("length_ratio");
    result.start_height = value("start_height");
    result.crack_time = value("crack_time");
    result.crack_start_height = value("crack_start_height");
    result.crack_position = value("crack_position") / slab.height;
    result.end_time = value("end_time");
    result.overhang_ratio = overhang_length(scene, result.time) / slab.height;
    return result;
}

void sort_cases(std::vector<Case>& cases) {
    std::ranges::sort(cases, {}, [](const Case& c) {
        return std::tuple_cat(order(c), std::tuple(c.depth_ratio(), c.name));
    });
}

void write_cases(const std::filesystem::path& path, const std::vector<Case>& cases,
                 const Provenance& provenance) {
    std::vector<std::string> columns = {"run",
                                        "height",
                                        "depth_ratio",
                                        "strength",
                                        "uniaxial_strength",
                                        "time",
                                        "length_ratio",
                                        "start_height",
                                        "crack_time",
                                        "crack_start_height",
                                        "crack_position_ratio",
                                        "overhang",
                                        "end_time"};
    for (const std::string theory : {"eq1", "beam", "uniaxial_beam"})
        columns.insert(columns.end(), {theory, "error_" + theory, "error_" + theory + "_overhang"});
    io::TableWriter table(path, provenance, columns);
    for (const Case& c : cases) {
        std::vector<double> numbers{c.overhang.height,   c.depth_ratio(),  c.strength,
                                    c.uniaxial_strength, c.time,           c.length_ratio,
                                    c.start_height,      c.crack_time,     c.crack_start_height,
                                    c.crack_position,    c.overhang_ratio, c.end_time};
        for (const double theory : {c.eq1(), c.beam(), c.uniaxial_beam()}) {
            numbers.push_back(theory);
            numbers.push_back(error_percent(c.length_ratio, theory));
            numbers.push_back(error_percent(c.overhang_ratio, theory));
        }
        std::vector<std::string> cells{c.name};
        for (const double number : numbers) {
            cells.push_back(io::format_number(number));
        }
        table.append_cells(cells);
    }
    table.finish();
}

}  // namespace tidewater::overhang
