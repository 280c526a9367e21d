// The checks of keys against each other. Each effect checks its own (effects/<effect>.cpp); here are those of
// the tank and of the simulation. Each check runs only if the keys that it compares are usable.
#include <algorithm>
#include <cmath>

#include "scene/effects/effects.h"
#include "scene/ground_keys.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

constexpr double cells_per_length = 4.0;  // fewer do not resolve a body or a layer of water at all
constexpr double max_per_axis = 1 << 20;  // particles along an axis; more would overflow the grid's numbers
constexpr double max_particles = 4e9;

std::vector<const Effect*> effects_of(const Scene& scene) {
    std::vector<const Effect*> named;
    for (const Effect* effect : all_effects()) {
        if (scene.has(effect->name)) named.push_back(effect);
    }
    return named;
}

void check_whole_cells(Reading& reading) {
    if (!reading.usable({"dimension", "domain.size", "domain.cell_size"})) return;
    const auto& size = reading.scene.domain.size;
    const double cell = reading.scene.domain.cell_size;
    for (std::size_t axis = 0; axis < size.size(); ++axis) {
        const double cells = size[axis] / cell;
        if (std::abs(cells - std::round(cells)) <= tolerance) continue;
        const double near = std::max(std::round(cells), 1.0) * cell;
        reading.report("domain.size",
                       metres(size[axis]) + " along " + axis_name(axis, reading.scene.dimension) +
                           " is not a whole number of cells of " + metres(cell) +
                           "; walls lie on cell edges, the nearest is " + metres(short_number(near)));
    }
}

// What the scene's effects fill with particles, without the edges whose keys are not usable.
std::vector<Body> known_bodies(const Reading& reading) {
    std::vector<Body> all;
    if (!reading.usable({"effects"})) return all;
    for (const Effect* effect : effects_of(reading.scene)) {
        if (effect->bodies == nullptr) continue;
        for (Body& body : effect->bodies(reading.scene)) {
            std::erase_if(body.edges, [&](const Edge& edge) { return !reading.usable({edge.key}); });
            all.push_back(std::move(body));
        }
    }
    return all;
}

bool complete(const Body& body, int dimension) {
    return body.edges.size() == static_cast<std::size_t>(dimension);
}

// The number of particles that fill a body.
double particles_in(const Body& body, double spacing) {
    double count = 1.0;
    for (const Edge& edge : body.edges) count *= std::max(edge.length / spacing, 1.0);
    return count;
}

void check_count(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"dimension", "effects", "domain.size", "domain.cell_size", "particles.per_axis"}))
        return;
    const double spacing = particle_spacing(scene);
    double count = 0.0;
    for (const Body& body : known_bodies(reading)) {
        if (!complete(body, scene.dimension)) return;
        count += particles_in(body, spacing);
    }
    const double longest = *std::ranges::max_element(scene.domain.size) / spacing;
    if (longest < max_per_axis && count < max_particles) return;
    reading.report("domain.cell_size", "would need " + number_text(short_number(count)) + " particles, " +
                                           number_text(short_number(longest)) +
                                           " along the tank; use a larger domain.cell_size");
}

// The tank comes first, so that of equal edges the tank's is the one that a message names.
void check_resolution(Reading& reading) {
    if (!reading.usable({"domain.cell_size"})) return;
    Body tank{"the tank", {}};
    for (const double length : reading.scene.domain.size) {
        if (reading.usable({"domain.size"})) tank.edges.push_back({length, "domain.size"});
    }
    std::vector<Body> bodies = known_bodies(reading);
    bodies.insert(bodies.begin(), tank);
    const Body* thinnest = nullptr;
    Edge edge;
    for (const Body& body : bodies) {
        for (const Edge& other : body.edges) {
            if (thinnest != nullptr && other.length >= edge.length) continue;
            thinnest = &body;
            edge = other;
        }
    }
    const double cell = reading.scene.domain.cell_size;
    if (thinnest == nullptr || edge.length >= (cells_per_length - tolerance) * cell) return;
    reading.report("domain.cell_size", metres(cell) + " is too coarse for " + thinnest->name + ", " +
                                           metres(edge.length) + " thick (" + edge.key + "): it needs " +
                                           number_text(cells_per_length) + " cells, so " +
                                           metres(edge.length / cells_per_length) + " at most");
}

// Each point needs from `min` to `max` coordinates, which `what` names, within the tank. They are those along
// `axes`.
void check_points(Reading& reading, const char* key, const Points& points, std::size_t min, std::size_t max,
                  const std::vector<std::size_t>& axes, const std::string& what) {
    const Scene& scene = reading.scene;
    std::string outside, wrong;
    std::size_t beyond = 0;  // the axis of the first that is outside
    for (const auto& point : points) {
        if (point.size() < min || point.size() > max) {
            wrong += (wrong.empty() ? "" : ", ") + list_text(std::span(&point, 1));
            continue;
        }
        for (std::size_t i = 0; i < point.size(); ++i) {
            if (point[i] <= scene.domain.size[axes[i]]) continue;
            if (outside.empty()) beyond = axes[i];
            const std::string text = list_text(std::span(&point, 1));
            outside += (outside.empty() ? "" : ", ") + text.substr(1, text.size() - 2);
            break;
        }
    }
    if (!wrong.empty()) reading.report(key, "each needs " + what + "; wrong: " + wrong);
    if (outside.empty()) return;
    reading.report(key, std::string("outside the tank, which ends at ") + axis_name(beyond, scene.dimension) +
                            " = " + number_text(scene.domain.size[beyond]) + " m: " + outside +
                            "; move or remove what is");
}

void check_gauges(Reading& reading) {
    if (!reading.usable({"dimension", "domain.size"})) return;
    const Scene& scene = reading.scene;
    const bool flat = scene.dimension == 2;
    const auto check = [&](const char* key, const Points& gauges) {
        if (!reading.usable({key})) return;
        check_points(reading, key, gauges, 1, flat ? 1 : 2, {0, 1}, flat ? "its x" : "its x, or [x, y]");
    };
    check("simulate.gauges", scene.simulate.gauges);
    check("postprocess.gauges", scene.postprocess.gauges);
    if (!reading.usable({"simulate.pressure_gauges"}) || scene.simulate.pressure_gauges.empty()) return;
    const std::size_t count = flat ? 2 : 3;
    check_points(reading, "simulate.pressure_gauges", scene.simulate.pressure_gauges, count, count, {0, 1, 2},
                 flat ? "[x, z]" : "[x, y, z]");
    if (reading.usable({"effects"}) && !scene.has("water"))
        reading.report("simulate.pressure_gauges",
                       "measure water, and effects does not name \"water\"; add it "
                       "or remove the gauges");
}

void check_times(Reading& reading) {
    if (!reading.usable({"simulate.end_time"})) return;
    const Scene& scene = reading.scene;
    const double end = scene.simulate.end_time;
    constexpr double max_rows = 1e7;  // tables of gigabytes
    const double rows = scene.simulate.gauge_interval;
    if (reading.usable({"simulate.gauge_interval"}) && rows > 0.0 && end / rows > max_rows)
        reading.report("simulate.gauge_interval",
                       number_text(rows) + " s gives more than 10 million rows in the run of " +
                           number_text(end) + " s (simulate.end_time); make it at least " +
                           number_text(end / max_rows) + " s, or 0 for one that fits the scene");
    const double interval = scene.simulate.snapshot_interval;
    if (!reading.usable({"simulate.snapshot_interval"}) || interval <= end) return;
    reading.report("simulate.snapshot_interval", number_text(interval) + " s is longer than the run of " +
                                                     number_text(end) + " s (simulate.end_time); shorten it");
}

// Sound along a diagonal crosses a cell's width along each axis at once: √D cfl < 1.
std::string cfl_warning(const Scene& scene) {
    const double max = scene.dimension == 2 ? 0.71 : 0.58;
    if (scene.simulate.cfl <= max) return {};
    return "simulate.cfl: " + number_text(scene.simulate.cfl) + " is more than " + number_text(max) +
           ", up to which steps are stable in " + std::to_string(scene.dimension) + "D; 0.5 is safe";
}

std::string picture_warning(const Scene& scene) {
    const double end = scene.simulate.end_time;
    std::string late;
    for (const double time : scene.postprocess.picture_times) {
        if (time > end) late += (late.empty() ? "" : ", ") + number_text(time);
    }
    if (late.empty()) return {};
    return "postprocess.picture_times: later than simulate.end_time = " + number_text(end) + " s: " + late +
           "; the last snapshot is drawn instead";
}

// Each wall of the tank that holds the water.
std::vector<std::string> held_by_walls(const Scene& scene) {
    const Scene::Domain& domain = scene.domain;
    std::vector<std::pair<std::string_view, mpm::WallRule>> walls{
        {"left", domain.wall_left}, {"right", domain.wall_right}, {"bottom", domain.wall_bottom}};
    if (scene.dimension == 3) {
        walls.emplace_back("front", domain.wall_front);
        walls.emplace_back("back", domain.wall_back);
    }
    std::vector<std::string> lines;
    for (const auto& [name, rule] : walls) {
        if (rule == mpm::WallRule::stick)
            lines.push_back(held_layer(scene, "domain.wall_" + std::string(name) + " = \"stick\""));
    }
    return lines;
}

}  // namespace

void derive_scene(Reading& reading) {
    if (!reading.usable({"effects"})) return;
    const auto effects = effects_of(reading.scene);
    for (auto effect = effects.rbegin(); effect != effects.rend(); ++effect) {
        if ((*effect)->derive != nullptr) (*effect)->derive(reading);
    }
}

void check_scene(Reading& reading) {
    check_whole_cells(reading);
    check_count(reading);
    check_resolution(reading);
    if (reading.usable({"effects"})) {
        for (const Effect* effect : effects_of(reading.scene)) {
            if (effect->check != nullptr) effect->check(reading);
        }
    }
    check_gauges(reading);
    check_times(reading);
}

std::vector<std::string> scene_warnings(const Scene& scene) {
    std::vector<std::string> all = held_by_walls(scene);
    for (const Effect* effect : effects_of(scene)) {
        if (effect->warnings == nullptr) continue;
        for (std::string& warning : effect->warnings(scene)) all.push_back(std::move(warning));
    }
    all.push_back(cfl_warning(scene));
    all.push_back(picture_warning(scene));
    std::erase(all, "");
    return all;
}

}  // namespace tidewater::scene
