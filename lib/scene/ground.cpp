#include "scene/ground_keys.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

std::string key_of(std::string_view section, std::string_view name) {
    return std::string(section) + "." + std::string(name);
}

// What a value of the retired key stands for, as it would be written today.
std::string meaning_of(mpm::WallRule wall, std::string_view section) {
    if (wall == mpm::WallRule::stick)
        return key_of(section, "friction") + " = inf, which holds the ice and lets the water glide";
    const bool holds_down = wall == mpm::WallRule::slip && section == "shelf";
    return holds_down ? "shelf.holds_down = true"
                      : "nothing: without " + key_of(section, "friction") + " ice and water slide freely";
}

}  // namespace

void derive_ground(Reading& reading, std::string_view section, Ground& ground) {
    const std::string wall = key_of(section, "wall"), friction = key_of(section, "friction");
    if (!ground.wall || !reading.usable({wall})) return;
    if (reading.places.contains(friction)) {
        reading.report(wall, "says in one word what " + friction + " says; remove " + wall);
        return;
    }
    if (*ground.wall == mpm::WallRule::stick) ground.friction = std::numeric_limits<double>::infinity();
}

void check_ground(Reading& reading, std::string_view section, const Ground& ground) {
    const std::string drag = key_of(section, "drag"), manning = key_of(section, "manning"),
                      friction = key_of(section, "friction");
    if (reading.usable({drag, manning}) && ground.drag > 0.0 && ground.manning > 0.0)
        reading.report(manning, "is another law of the same drag than " + drag + "; remove one of them");
    const auto needs_friction = [&](const char* name, double value) {
        const std::string key = key_of(section, name);
        if (!reading.usable({key, friction}) || value == 0.0 || ground.friction > 0.0) return;
        reading.report(key, "is not read without " + friction + "; add it or remove " + key);
    };
    needs_friction("sliding_speed", ground.sliding_speed);
    needs_friction("pore_pressure", ground.pore_pressure);
}

std::vector<std::string> ground_warnings(const Scene& scene, std::string_view section, const Ground& ground) {
    std::vector<std::string> lines;
    const std::string wall = key_of(section, "wall");
    if (ground.wall) {
        lines.push_back(wall + " is no longer a key: in place of " +
                        quoted_text(enum_names<mpm::WallRule>[static_cast<std::size_t>(*ground.wall)]) +
                        " write " + meaning_of(*ground.wall, section) + "; the scene runs so");
    }
    const std::string drag = key_of(section, "drag");
    if (std::isinf(ground.drag)) lines.push_back(held_layer(scene, drag + " = inf"));
    const bool rubs = ground.friction > 0.0 || ground.weertman > 0.0;
    if (rubs && !scene.has("ice"))
        lines.push_back(key_of(section, ground.friction > 0.0 ? "friction" : "weertman") +
                        ": acts on ice, of which the scene has none; water is slowed by " + drag);
    if ((ground.drag > 0.0 || ground.manning > 0.0) && !scene.has("water"))
        lines.push_back(drag + ": acts on water, of which the scene has none; ice is slowed by " +
                        key_of(section, "friction"));
    return lines;
}

std::string held_layer(const Scene& scene, const std::string& what) {
    if (!scene.has("water")) return {};
    double sound = scene.water.model.sound_speed;
    if (scene.has("ice")) sound = std::max(sound, scene.ice.model.wave_speed(scene.dimension));
    const double cell = scene.domain.cell_size;
    const double steps = scene.simulate.end_time * sound / (scene.simulate.cfl * cell);
    const bool restored = scene.simulate.transfer == mpm::Transfer::restored;
    const double layer =
        (restored ? std::pow(0.024 * 0.024 * steps, 0.125) : std::pow(0.024 * steps, 0.25)) * cell;
    const auto rounded = [](double number, double digits) {
        const double unit = std::pow(10.0, std::floor(std::log10(number)) - digits + 1.0);
        return number_text(short_number(std::round(number / unit) * unit));
    };
    return what + ": holds the water, in a layer that grows with each step: about " + rounded(layer, 2) +
           " m thick after " + rounded(steps, 2) + " steps, in water " + metres(scene.water.depth) +
           " deep; it damps the waves that nature's drag of 0.002 to 0.005 would not";
}

}  // namespace tidewater::scene
