// The checks of keys against each other. Each runs only if the keys that it compares are usable.
#include <algorithm>
#include <array>
#include <cmath>

#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

constexpr double cells_per_length = 4.0;  // fewer do not resolve a body or a layer of water at all
constexpr double most_per_axis =
    1 << 20;  // particles along an axis of the tank; more would overflow the grid's numbers
constexpr double most_particles = 4e9;

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

double particle_spacing(const Scene& scene) {
    return scene.domain.cell_size / static_cast<double>(scene.particles.per_axis);
}

// As many as a body with these edges is filled with.
double particles_in(const std::vector<double>& edges, double spacing) {
    double count = 1.0;
    for (const double length : edges) count *= std::max(length / spacing, 1.0);
    return count;
}

double particle_estimate(const Scene& scene) {
    double count = 0.0;
    if (scene.has("water")) {
        std::vector<double> water = scene.domain.size;
        if (scene.water.length > 0.0) water.front() = scene.water.length;
        water.back() = scene.water.depth;
        count += particles_in(water, particle_spacing(scene));
    }
    for (const Scene::Block& block : scene.blocks) {
        if (scene.has("rigid")) count += particles_in(block.size, particle_spacing(scene));
    }
    if (scene.has("ice")) count += particles_in(scene.ice.size, particle_spacing(scene));
    return count;
}

void check_count(Reading& reading) {
    if (!reading.usable({"dimension", "effects", "domain.size", "domain.cell_size", "particles.per_axis",
                         "water.depth", "water.length", "block.size", "ice.size"})) {
        return;
    }
    const double longest =
        *std::ranges::max_element(reading.scene.domain.size) / particle_spacing(reading.scene);
    const double count = particle_estimate(reading.scene);
    if (longest < most_per_axis && count < most_particles) return;
    reading.report("domain.cell_size", "would need " + number_text(short_number(count)) + " particles, " +
                                           number_text(short_number(longest)) +
                                           " along the tank; use a larger domain.cell_size");
}

// Something that the grid must resolve.
struct Thing {
    std::string name;
    double thickness;
    std::string key;
};

std::vector<Thing> things(const Reading& reading) {
    const Scene& scene = reading.scene;
    std::vector<Thing> all;
    const auto add = [&](const std::string& name, const std::vector<double>& lengths,
                         const std::string& key) {
        if (!lengths.empty()) all.push_back({name, *std::ranges::min_element(lengths), key});
    };
    if (reading.usable({"domain.size"})) add("the tank", scene.domain.size, "domain.size");
    if (!reading.usable({"effects"})) return all;
    if (scene.has("water") && reading.usable({"water.depth"}))
        add("the water", {scene.water.depth}, "water.depth");
    if (scene.has("water") && reading.usable({"water.length"}) && scene.water.length > 0.0) {
        add("the water", {scene.water.length}, "water.length");
    }
    for (std::size_t n = 0; scene.has("rigid") && n < scene.blocks.size(); ++n) {
        const std::string key = block_key(scene, n, "size");
        if (reading.usable({key})) add(block_name(scene, n), scene.blocks[n].size, key);
    }
    if (scene.has("ice") && reading.usable({"ice.size"})) add("the ice", scene.ice.size, "ice.size");
    return all;
}

void check_resolution(Reading& reading) {
    if (!reading.usable({"domain.cell_size"})) return;
    const auto all = things(reading);
    const auto thinnest = std::ranges::min_element(all, {}, &Thing::thickness);
    const double cell = reading.scene.domain.cell_size;
    if (thinnest == all.end() || thinnest->thickness >= (cells_per_length - tolerance) * cell) return;
    reading.report("domain.cell_size", metres(cell) + " is too coarse for " + thinnest->name + ", " +
                                           metres(thinnest->thickness) + " thick (" + thinnest->key +
                                           "): it needs " + number_text(cells_per_length) + " cells, so " +
                                           metres(thinnest->thickness / cells_per_length) + " at most");
}

void check_water(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"dimension", "effects", "domain.size"}) || !scene.has("water")) return;
    if (reading.usable({"water.depth"}) && scene.water.depth > scene.domain.size.back()) {
        reading.report("water.depth", metres(scene.water.depth) + " is above the tank's top at " +
                                          metres(scene.domain.size.back()) +
                                          "; lower it or raise domain.size");
    }
    if (reading.usable({"water.length"}) && scene.water.length > scene.domain.size.front()) {
        reading.report("water.length", metres(scene.water.length) + " is beyond the tank's end at " +
                                           metres(scene.domain.size.front()) +
                                           "; shorten it or lengthen domain.size");
    }
}

void report_top(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"water.depth"})) return;
    const double crest = scene.water.depth + scene.wave.height, top = scene.domain.size.back();
    if (crest > top) {
        reading.report("wave.height", "the crest at " + metres(short_number(crest)) +
                                          " is above the tank's top at " + metres(top) +
                                          "; lower it or raise domain.size");
    }
    const bool solitary = scene.wave.kind == analysis::WaveKind::solitary;
    const double share = solitary ? analysis::highest_solitary : 0.5;
    if (scene.wave.height <= share * scene.water.depth * (1.0 + 1e-9)) return;
    reading.report("wave.height", metres(scene.wave.height) + " is more than " + number_text(share) +
                                      " of the water's depth, up to which the theory holds; lower it to " +
                                      metres(short_number(share * scene.water.depth)));
}

// The walls of a standing wave are at its crests and troughs.
void report_wave_length(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"wave.length"})) return;
    if (scene.wave.length == 0.0) {
        return reading.report("wave.length", "missing; a standing wave needs its length, e.g. length = " +
                                                 number_text(2.0 * scene.domain.size.front()) + " (m)");
    }
    const double halves = 2.0 * scene.domain.size.front() / scene.wave.length;
    const double whole = std::max(std::round(halves), 1.0);
    if (std::abs(halves - whole) <= tolerance * whole) return;
    reading.report("wave.length", metres(scene.wave.length) + ": the tank of " +
                                      metres(scene.domain.size.front()) +
                                      " holds no whole number of halves of it; the nearest length is " +
                                      metres(short_number(2.0 * scene.domain.size.front() / whole)));
}

void check_wave(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"effects", "dimension", "domain.size", "wave.kind", "wave.height"}) ||
        !scene.has("wave") || !scene.has("water")) {
        return;
    }
    report_top(reading);
    const bool solitary = scene.wave.kind == analysis::WaveKind::solitary;
    if (!solitary) report_wave_length(reading);
    const char* other = solitary ? "wave.length" : "wave.center";
    if ((solitary ? scene.wave.length : scene.wave.center) != 0.0)
        reading.report(other, std::string("is not read with kind = \"") +
                                  (solitary ? "solitary" : "standing") + "\"; remove it");
    if (solitary && reading.usable({"wave.center"}) && scene.wave.center > scene.domain.size.front()) {
        reading.report("wave.center", metres(scene.wave.center) + " is beyond the tank's end at " +
                                          metres(scene.domain.size.front()) + "; move it into the tank");
    }
    if (reading.usable({"water.length"}) && scene.water.length > 0.0 &&
        scene.water.length < scene.domain.size.front()) {
        reading.report("water.length",
                       metres(scene.water.length) + " is not the whole tank, which a wave needs; remove it");
    }
    if (reading.usable({"domain.gravity"}) && scene.domain.gravity == 0.0)
        reading.report("domain.gravity", "0 m/s² makes no waves; raise it or take \"wave\" out of effects");
}

// Names that stand alone make no sense: each needs what it acts on.
void check_companions(Reading& reading) {
    if (!reading.usable({"effects"})) return;
    const struct {
        const char *effect, *needs, *why;
    } rules[] = {{"fracture", "ice", "there is nothing that could fracture"},
                 {"outlet", "water", "there is nothing to let out"},
                 {"wave", "water", "there is nothing that could make a wave"},
                 {"sponge", "water", "there are no waves to take"},
                 {"piston", "water", "there is nothing to make waves in"}};
    for (const char* ground : {"shelf", "push", "piston"}) {
        if (!reading.scene.has("rigid") || !reading.scene.has(ground)) continue;
        reading.report("effects", std::string("names \"rigid\" and \"") + ground +
                                      "\": a rigid block knows only water, ice, a bed and the tank's walls "
                                      "so far; remove one of them");
    }
    for (const char* body : {"rigid", "ice", "shelf", "bed"}) {
        if (!reading.scene.has("wave") || !reading.scene.has(body)) continue;
        reading.report("effects",
                       std::string("names \"wave\" and \"") + body +
                           "\": the theories of waves know a flat bed and open water alone; remove "
                           "one of them");
    }
    for (const auto& [effect, needs, why] : rules) {
        if (!reading.scene.has(effect) || reading.scene.has(needs)) continue;
        reading.report("effects", "names " + quoted_text(effect) + " but not " + quoted_text(needs) +
                                      ", so " + why + "; add " + quoted_text(needs) + " or remove " +
                                      quoted_text(effect));
    }
}

void check_ice(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable(
            {"dimension", "effects", "domain.size", "domain.cell_size", "ice.size", "ice.corner"}) ||
        !scene.has("ice")) {
        return;
    }
    const double slack = tolerance * scene.domain.cell_size;
    for (std::size_t axis = 0; axis < scene.ice.size.size(); ++axis) {
        const double high = scene.ice.corner[axis] + scene.ice.size[axis];
        if (high <= scene.domain.size[axis] + slack) continue;
        reading.report("ice.corner", std::string("the ice ends outside the tank: along ") +
                                         axis_name(axis, scene.dimension) + " at " +
                                         metres(short_number(high)) + ", the tank at " +
                                         metres(scene.domain.size[axis]) +
                                         "; move ice.corner or shrink ice.size");
    }
    if (!scene.has("shelf") || !reading.usable({"shelf.length", "shelf.height"})) return;
    const bool above = scene.ice.corner.back() >= scene.shelf.height - slack;
    const bool beyond = scene.ice.corner.front() >= scene.shelf.length - slack;
    if (above || beyond) return;
    reading.report("ice.corner", "the ice reaches into the shelf: its base is at " +
                                     metres(scene.ice.corner.back()) + ", the shelf's top at " +
                                     metres(scene.shelf.height) + "; raise the ice or lower shelf.height");
}

void check_shelf(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"dimension", "effects", "domain.size", "domain.cell_size"}) || !scene.has("shelf"))
        return;
    const auto check = [&](const char* key, double length, std::size_t axis) {
        if (!reading.usable({key})) return;
        const double cells = length / scene.domain.cell_size;
        if (length >= scene.domain.size[axis]) {
            reading.report(key, metres(length) + " fills the tank, " + metres(scene.domain.size[axis]) +
                                    " along " + axis_name(axis, scene.dimension) +
                                    "; shorten it or enlarge domain.size");
        } else if (std::abs(cells - std::round(cells)) > tolerance) {
            reading.report(
                key, metres(length) + " is not a whole number of cells of " + metres(scene.domain.cell_size) +
                         "; its faces lie on cell edges, the nearest is " +
                         metres(short_number(std::max(std::round(cells), 1.0) * scene.domain.cell_size)));
        }
    };
    check("shelf.length", scene.shelf.length, 0);
    check("shelf.height", scene.shelf.height, scene.domain.size.size() - 1);
}

// Above this share of κ the surface has no compressive tip (mpm/materials/ice_yield.h), and the strength would be
// another.
void check_strength(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"effects", "dimension", "ice.youngs_modulus", "ice.poisson_ratio", "ice.moduli",
                         "fracture.strength", "fracture.beta"}) ||
        !scene.has("fracture")) {
        return;
    }
    const mpm::IceModel& ice = scene.ice.model;
    const double p0 = ice.beta_p0 / ice.beta, most = 0.45 * ice.bulk_modulus(scene.dimension);
    if (p0 < most) return;
    reading.report("fracture.strength",
                   "over fracture.beta, p0 of intact ice, is " + number_text(short_number(p0)) +
                       " Pa; it must be below 0.45 κ = " + number_text(short_number(most)) +
                       " Pa; lower it, or raise fracture.beta or ice.youngs_modulus");
}

void check_outlet(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"effects", "domain.size", "outlet.width"}) || !scene.has("outlet")) return;
    if (scene.outlet.width <= scene.domain.size.front()) return;
    reading.report("outlet.width", metres(scene.outlet.width) + " is more than the tank, " +
                                       metres(scene.domain.size.front()) + " (domain.size); shorten it");
}

void check_softening(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"effects", "fracture.softening", "fracture.energy"}) || !scene.has("fracture"))
        return;
    const bool band = scene.fracture.softening == Softening::crack_band, energy = scene.fracture.energy > 0.0;
    if (band && !energy) {
        reading.report("fracture.energy",
                       "missing; softening = \"crack_band\" needs the energy of a crack, e.g. "
                       "energy = 800 (J/m²)");
    } else if (!band && energy) {
        reading.report("fracture.energy",
                       "is not read with softening = \"paper\"; set softening = \"crack_band\" "
                       "or remove it");
    }
}

// Each point needs one of these counts of coordinates, which `what` names, within the tank. `axes`: which
// ones they are.
void check_points(Reading& reading, const char* key, const Points& points, std::size_t least,
                  std::size_t most, const std::vector<std::size_t>& axes, const std::string& what) {
    const Scene& scene = reading.scene;
    std::string outside, wrong;
    std::size_t beyond = 0;  // the axis of the first that is outside
    for (const auto& point : points) {
        if (point.size() < least || point.size() > most) {
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
    const double interval = scene.simulate.snapshot_interval;
    if (!reading.usable({"simulate.snapshot_interval"}) || interval <= end) return;
    reading.report("simulate.snapshot_interval", number_text(interval) + " s is longer than the run of " +
                                                     number_text(end) + " s (simulate.end_time); shorten it");
}

// The fastest water that the scene makes likely, by estimates: long waves, √(g d); water let loose as by a
// broken dam, 2 √(g d) (Ritter 1892); the blocks.
double fastest_flow(const Scene& scene) {
    const double depth = scene.water.depth + scene.wave.height;
    const bool dam = scene.water.length > 0.0 && scene.water.length < scene.domain.size.front();
    const double wave = std::sqrt(scene.domain.gravity * (dam ? 4.0 * depth : depth));
    return scene.has("rigid") ? std::max(wave, fastest_block(scene)) : wave;
}

std::string sound_speed_warning(const Scene& scene) {
    const double fastest = fastest_flow(scene);
    const double speed = scene.water.model.sound_speed;
    if (speed >= 10.0 * fastest) return {};
    return "water.sound_speed: " + number_text(speed) +
           " m/s is less than 10 times the fastest expected flow, " + number_text(short_number(fastest)) +
           " m/s, so the water will compress by more than 1 %; " + number_text(std::ceil(10.0 * fastest)) +
           " m/s would do";
}

// Particles sit in the middle of their shares of the cells, so a share is filled or not.
std::string depth_warning(const Scene& scene) {
    const double spacing = particle_spacing(scene);
    const double layers = scene.water.depth / spacing;
    if (std::abs(layers - std::round(layers)) <= tolerance) return {};
    return "water.depth: " + metres(scene.water.depth) + " is not a whole number of particle spacings of " +
           metres(short_number(spacing)) + ", so the still level is off by up to half of one; " +
           metres(short_number(std::floor(layers) * spacing)) + " and " +
           metres(short_number(std::ceil(layers) * spacing)) + " would fit";
}

// Sound along a diagonal crosses a cell's width along each axis at once: √D cfl < 1.
std::string cfl_warning(const Scene& scene) {
    const double most = scene.dimension == 2 ? 0.71 : 0.58;
    if (scene.simulate.cfl <= most) return {};
    return "simulate.cfl: " + number_text(scene.simulate.cfl) + " is more than " + number_text(most) +
           ", up to which steps are stable in " + std::to_string(scene.dimension) + "D; 0.5 is safe";
}

// From βξ = 1 on a point snaps in isotropic tension. In uniaxial tension a band of width h snaps if it stores
// more energy, h σt²/2E, than its crack costs (mpm/materials/ice.h).
std::string softening_warning(const Scene& scene) {
    const mpm::IceModel ice = ice_model(scene);
    const double product = ice.beta * ice.hardening;
    if (scene.fracture.softening == Softening::crack_band) {
        const double strength = ice.uniaxial_strength(scene.dimension);
        const double stored = 0.5 * scene.domain.cell_size * strength * strength / ice.youngs_modulus;
        if (scene.fracture.energy >= stored && product < 1.0) return {};
        return "fracture.energy: cells of " + metres(scene.domain.cell_size) + " store " +
               number_text(short_number(stored)) +
               " J/m² before they break, so cracks will cost what the cells say and " + "not " +
               number_text(scene.fracture.energy) + " J/m²; use smaller cells or a higher energy";
    }
    if (product < 1.0) return {};
    return "fracture.hardening: βξ = " + number_text(short_number(product)) +
           ", and from 1 on ice snaps within a few steps and dissipates what the steps say; a smaller β or ξ "
           "softens "
           "gradually";
}

// What is pushed must end before the tank does.
std::string push_warning(const Scene& scene) {
    const mpm::Push push{scene.push.speed, scene.push.ramp};
    const double end = push.position(scene.simulate.end_time);
    const double length = scene.has("ice") ? scene.ice.size.front() : 0.0;
    if (end + length <= scene.domain.size.front()) return {};
    return "push.speed: by simulate.end_time the plane is at x = " + metres(short_number(end)) +
           " and what it pushes meets the right wall; end earlier or push more slowly";
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

}  // namespace

mpm::IceModel ice_model(const Scene& scene) {
    mpm::IceModel ice = scene.ice.model;
    ice.fracture = scene.has("fracture");
    ice.cap_hardening = scene.fracture.hardening_limit == HardeningLimit::start;
    if (ice.fracture && scene.fracture.softening == Softening::crack_band) {
        ice.hardening =
            mpm::crack_band_hardening(ice, scene.dimension, scene.fracture.energy, scene.domain.cell_size);
    }
    return ice;
}

const char* axis_name(std::size_t axis, int dimension) {
    if (axis == 0) return "x";
    return dimension == 3 && axis == 1 ? "y" : "z";
}

void check_scene(Reading& reading) {
    check_whole_cells(reading);
    check_count(reading);
    check_resolution(reading);
    check_water(reading);
    check_wave(reading);
    check_blocks(reading);
    check_companions(reading);
    check_ice(reading);
    check_glacier(reading);
    check_shelf(reading);
    check_outlet(reading);
    check_bed(reading);
    check_piston(reading);
    check_sponge(reading);
    check_softening(reading);
    check_strength(reading);
    check_gauges(reading);
    check_times(reading);
}

std::vector<std::string> scene_warnings(const Scene& scene) {
    std::vector<std::string> warnings;
    if (scene.has("water")) warnings = {sound_speed_warning(scene), depth_warning(scene)};
    if (scene.has("fracture")) warnings.push_back(softening_warning(scene));
    if (scene.has("rigid")) {
        for (std::string& warning : block_warnings(scene)) warnings.push_back(std::move(warning));
    }
    for (std::string& warning : glacier_warnings(scene)) warnings.push_back(std::move(warning));
    if (scene.has("push")) warnings.push_back(push_warning(scene));
    warnings.push_back(cfl_warning(scene));
    warnings.push_back(picture_warning(scene));
    std::erase(warnings, "");
    return warnings;
}

}  // namespace tidewater::scene
