// The checks of keys against each other. Each runs only if the keys that it compares are usable.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

constexpr double cells_per_length = 4.0;  // fewer do not resolve a body or a layer of water at all
constexpr double tolerance = 1e-6;        // of a cell

std::string metres(double length) { return number_text(length) + " m"; }

// Rounded to six digits, for numbers that the checks computed.
double short_number(double number) {
    if (number == 0.0) return 0.0;
    const double scale = std::pow(10.0, 5.0 - std::floor(std::log10(std::abs(number))));
    return std::round(number * scale) / scale;
}

const char* axis_name(std::size_t axis, int dimension) {
    if (axis == 0) return "x";
    return dimension == 3 && axis == 1 ? "y" : "z";
}

void check_whole_cells(Reading& reading) {
    if (!reading.usable({"dimension", "domain.size", "domain.cell_size"})) return;
    const auto& [size, cell, gravity, left, right, front, back, bottom, top] = reading.scene.domain;
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

// Something that the grid must resolve.
struct Thing {
    const char* name;
    double thickness;
    const char* key;
};

std::vector<Thing> things(const Reading& reading) {
    const Scene& scene = reading.scene;
    std::vector<Thing> all;
    const auto add = [&](const char* name, const std::vector<double>& lengths, const char* key) {
        if (!lengths.empty()) all.push_back({name, *std::ranges::min_element(lengths), key});
    };
    if (reading.usable({"domain.size"})) add("the tank", scene.domain.size, "domain.size");
    if (!reading.usable({"effects"})) return all;
    if (scene.has("water") && reading.usable({"water.depth"}))
        add("the water", {scene.water.depth}, "water.depth");
    if (scene.has("water") && reading.usable({"water.length"}) && scene.water.length > 0.0) {
        add("the water", {scene.water.length}, "water.length");
    }
    if (scene.has("rigid") && reading.usable({"block.size"}))
        add("the block", scene.block.size, "block.size");
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

// Half the extent along each axis of the box around the turned block.
std::vector<double> block_reach(const Scene& scene) {
    std::vector<double> reach = scene.block.size;
    const double angle = scene.block.angle * std::numbers::pi / 180.0;
    const double c = std::abs(std::cos(angle));
    const double s = std::abs(std::sin(angle));
    reach.front() = c * scene.block.size.front() + s * scene.block.size.back();
    reach.back() = s * scene.block.size.front() + c * scene.block.size.back();
    for (double& length : reach) length *= 0.5;
    return reach;
}

void check_block_inside(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"dimension", "effects", "domain.size", "domain.cell_size", "block.size",
                         "block.center", "block.angle"}) ||
        !scene.has("rigid")) {
        return;
    }
    const auto reach = block_reach(scene);
    for (std::size_t axis = 0; axis < reach.size(); ++axis) {
        const double low = scene.block.center[axis] - reach[axis];
        const double high = scene.block.center[axis] + reach[axis];
        const double slack = tolerance * scene.domain.cell_size;
        if (low >= -slack && high <= scene.domain.size[axis] + slack) continue;
        reading.report("block.center", std::string("the block lies outside the tank: along ") +
                                           axis_name(axis, scene.dimension) + " it reaches from " +
                                           metres(short_number(low)) + " to " + metres(short_number(high)) +
                                           ", the tank from 0 m to " + metres(scene.domain.size[axis]) +
                                           "; move block.center or shrink block.size");
    }
}

// Reports the numbers of the list that are greater than `most`: "<rule> <most> <unit>: <numbers>".
void check_list(Reading& reading, const char* key, const std::vector<double>& list, double most,
                const char* unit, const std::string& rule) {
    std::string outside;
    for (const double number : list) {
        if (number > most) outside += (outside.empty() ? "" : ", ") + number_text(number);
    }
    if (outside.empty()) return;
    reading.report(key,
                   rule + " " + number_text(most) + " " + unit + ": " + outside + "; move or remove what is");
}

void check_gauges(Reading& reading) {
    if (!reading.usable({"dimension", "domain.size"})) return;
    const Scene& scene = reading.scene;
    const double end = scene.domain.size.front();
    const char* rule = "outside the tank, which ends at x =";
    if (reading.usable({"simulate.gauges"})) {
        check_list(reading, "simulate.gauges", scene.simulate.gauges, end, "m", rule);
    }
    if (reading.usable({"postprocess.gauges"})) {
        check_list(reading, "postprocess.gauges", scene.postprocess.gauges, end, "m", rule);
    }
}

void check_times(Reading& reading) {
    if (!reading.usable({"simulate.end_time"})) return;
    const Scene& scene = reading.scene;
    const double end = scene.simulate.end_time;
    const auto check_interval = [&](const char* key, double interval) {
        if (!reading.usable({key}) || interval <= end) return;
        reading.report(key, number_text(interval) + " s is longer than the run of " + number_text(end) +
                                " s (simulate.end_time); shorten it");
    };
    check_interval("simulate.snapshot_interval", scene.simulate.snapshot_interval);
    check_interval("simulate.gauge_interval", scene.simulate.gauge_interval);
    if (reading.usable({"postprocess.picture_times"})) {
        check_list(reading, "postprocess.picture_times", scene.postprocess.picture_times, end, "s",
                   "later than simulate.end_time =");
    }
}

}  // namespace

void check_scene(Reading& reading) {
    check_whole_cells(reading);
    check_resolution(reading);
    check_water(reading);
    check_block_inside(reading);
    check_gauges(reading);
    check_times(reading);
}

std::vector<std::string> scene_warnings(const Scene& scene) {
    std::vector<std::string> warnings;
    const double fastest = std::sqrt(2.0 * scene.domain.gravity * scene.domain.size.back());
    const double speed = scene.water.model.sound_speed;
    if (scene.has("water") && speed < 10.0 * fastest) {
        warnings.push_back("water.sound_speed: " + number_text(speed) +
                           " m/s is less than 10 times the fastest expected flow, √(2 g H) = " +
                           number_text(short_number(fastest)) +
                           " m/s, so the water will compress by more than 1 %; " +
                           number_text(std::ceil(10.0 * fastest)) + " m/s would do");
    }
    return warnings;
}

}  // namespace tidewater::scene
