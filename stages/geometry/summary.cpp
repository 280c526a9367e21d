#include "summary.h"

#include <cmath>
#include <cstdio>

#include "geometry/front.h"
#include "io/text.h"

namespace tidewater {
namespace {

// Bytes that simulate's process grows by for each particle of water and ice, in 2D and 3D, sorting included
// (tools/benchmark/results).
constexpr double bytes_of_water[] = {43.0, 64.0}, bytes_of_ice[] = {59.0, 79.0};

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string metres(double length) { return io::format_fixed(length, 1) + " m"; }

struct Units {
    std::string volume, mass;

    explicit Units(int dimension)
        : volume(dimension == 2 ? " m²" : " m³"), mass(dimension == 2 ? " kg/m" : " kg") {}
};

// How a block floats, if it does: a hint for whoever wants it to start at rest.
std::string floating(const scene::Scene& scene, const BoxBody& body) {
    const double area = 4.0 * body.box.half_size[0] * body.box.half_size[2];
    const double below = area_below(body.box, scene.water.depth) / area;
    const double share = body.block->density / scene.water.model.density;
    char text[200];
    std::snprintf(text, sizeof text, "  %.4g %% of it starts below the still level; ", 100.0 * below);
    std::string line = text;
    if (share >= 1.0) {
        std::snprintf(text, sizeof text, "it sinks: %.4g times as dense as water\n", share);
    } else {
        std::snprintf(text, sizeof text,
                      "it floats with %.4g %% below, at this angle with its centre at z = %.6g m\n",
                      100.0 * share, floating_height(body.box, scene.water.depth, share));
    }
    return line + text;
}

std::string box_lines(const scene::Scene& scene, const BoxBody& body) {
    const Units units(scene.dimension);
    const double size = volume_of(scene, body.box);
    std::string text = body.name + ": " + number(size) + units.volume;
    if (body.block != nullptr) text += ", " + number(size * body.block->density) + units.mass;
    text += "\n";
    return body.block != nullptr && scene.has("water") ? text + floating(scene, body) : text;
}

std::string front_lines(const scene::Scene& scene, const Glacier& ice) {
    const double height = ice.top - ice.base;
    std::string text = "  its front: at x = " + metres(ice.front) + ", from z = " + metres(ice.base) +
                       " to " + metres(ice.top) + ", " + metres(height) + " high";
    if (!scene.has("water")) return text + "\n";
    const double level = scene.water.depth, below = std::max(level - ice.base, 0.0);
    const double neutral = scene.ice.model.density / scene.water.model.density, ratio = below / height;
    text += "; the cliff stands " + metres(std::max(ice.top - level, 0.0)) + " above the water\n";
    text += "  D/H = " + io::format_fixed(ratio, 3) +
            " of it is below the still level; neutral is ρi/ρw = " + io::format_fixed(neutral, 3) +
            (std::abs(ratio - neutral) < 0.005 ? ": it floats"
             : ratio < neutral                 ? ": its weight rests on the ground or bends it down"
                                               : ": water bends it up") +
            "\n";
    return text;
}

double particles_of(const scene::Scene& scene, double volume) {
    const double spacing = particle_spacing(scene);
    return volume / std::pow(spacing, scene.dimension);
}

std::string cost_line(const scene::Scene& scene, const Bodies& bodies) {
    const std::size_t d = scene.dimension == 2 ? 0 : 1;
    const double water = particles_of(scene, bodies.water_volume);
    const double ice = bodies.ice ? particles_of(scene, bodies.ice->volume) : 0.0;
    const double bytes = water * bytes_of_water[d] + ice * bytes_of_ice[d];
    return "simulate will have about " + number(std::round(water)) + " particles of water and " +
           number(std::round(ice)) + " of ice, and take about " +
           io::format_fixed(bytes / 1e9, bytes < 1e9 ? 3 : 1) + " GB for them\n";
}

}  // namespace

std::string summary(const scene::Scene& scene, const Bodies& bodies) {
    const Units units(scene.dimension);
    std::string text = bodies.terrain.report;
    if (scene.has("bed")) text += "bed: " + number(bodies.ground_volume) + units.volume + "\n";
    if (scene.has("water")) {
        text += "water: " + number(bodies.water_volume) + units.volume + ", " +
                number(bodies.water_volume * scene.water.model.density) + units.mass + "\n";
    }
    for (const BoxBody& body : bodies.boxes) {
        if (body.block == nullptr) text += box_lines(scene, body);
    }
    if (bodies.ice) {
        const Glacier& ice = *bodies.ice;
        text += "ice: " + number(ice.volume) + units.volume + ", " +
                number(ice.volume * scene.ice.model.density) + units.mass + "\n" + front_lines(scene, ice) +
                describe_cuts(ice, scene);
    }
    for (const BoxBody& body : bodies.boxes) {
        if (body.block != nullptr) text += box_lines(scene, body);
    }
    return text + cost_line(scene, bodies);
}

}  // namespace tidewater
