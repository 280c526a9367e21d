#include <algorithm>
#include <filesystem>

#include "core/error.h"
#include "scene/point_file.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

// Reads a profile from its file; from then on it is as if it stood in the scene.
void read_profile(Reading& reading, const std::string& section, std::string& file,
                  std::vector<double>& profile) {
    const std::string key = section + ".profile", file_key = section + ".profile_file";
    if (!reading.usable({file_key}) || !reading.places.contains(file_key) || file.empty()) return;
    if (reading.places.contains(key) && !profile.empty())
        return reading.report(file_key, "the scene has " + key + " as well; remove one of them");
    const auto path = std::filesystem::absolute(reading.file).parent_path() / file;
    try {
        profile = read_point_file(path);
        reading.places[key] = reading.places[file_key];
        file.clear();
    } catch (const Error& error) {
        reading.report(file_key, error.what());
        reading.spoil(key);
    }
}

// Of ice.profile. False if it is no outline.
bool check_outline(Reading& reading) {
    const auto& list = reading.scene.ice.profile;
    const auto report = [&](const std::string& problem) {
        reading.report("ice.profile", problem);
        for (const char* key : {"ice.profile", "ice.size", "ice.corner"}) reading.spoil(key);
        return false;
    };
    if (list.size() % 2 != 0 || list.size() < 6) {
        return report("has " + std::to_string(list.size()) +
                      " numbers; an outline takes pairs x0, z0, x1, z1, …, three at least");
    }
    const geometry::Polygon outline = ice_outline(reading.scene);
    if (const auto at = geometry::crossing(outline)) {
        return report("the outline crosses itself at x = " + metres(short_number((*at)[0])) + ", z = " +
                      metres(short_number((*at)[1])) + "; list its corners in turn around the ice");
    }
    if (geometry::area(outline) <= 0.0)
        return report("the outline holds no area; its corners lie on one line");
    return true;
}

// size and corner become the box around the outline; in 3D it spans the tank's width.
void derive_box(Reading& reading) {
    Scene& scene = reading.scene;
    const auto& list = scene.ice.profile;
    double low[2] = {list[0], list[1]}, high[2] = {list[0], list[1]};
    for (std::size_t n = 0; n < list.size(); ++n) {
        low[n % 2] = std::min(low[n % 2], list[n]);
        high[n % 2] = std::max(high[n % 2], list[n]);
    }
    std::vector<double> corner{low[0], low[1]}, size{high[0] - low[0], high[1] - low[1]};
    if (scene.dimension == 3) {
        corner.insert(corner.begin() + 1, 0.0);
        size.insert(size.begin() + 1, scene.domain.size[1]);
    }
    const auto take = [&](const char* key, std::vector<double>& member, const std::vector<double>& found) {
        if (reading.places.contains(key) && member != found)
            reading.report(key, "is not that of ice.profile, " + list_text(found) + "; remove one of them");
        member = found;
    };
    take("ice.corner", scene.ice.corner, corner);
    take("ice.size", scene.ice.size, size);
}

// Raises or lowers the ice to where it floats.
void derive_floating(Reading& reading) {
    Scene& scene = reading.scene;
    if (scene.ice.base != IceBase::floating) return;
    if (!scene.has("water") || scene.water.submergence >= 0.0) {
        return reading.report("ice.base",
                              "\"floating\" needs water of a given water.depth; " +
                                  std::string(scene.has("water") ? "give it instead of water.submergence"
                                                                 : "add \"water\" to effects"));
    }
    const double share = scene.ice.model.density / scene.water.model.density;
    if (share >= 1.0)
        return reading.report("ice.base",
                              "ice.density is not below water.density, so the ice does not float");
    const double rise = geometry::rise_to_float(ice_outline(scene), scene.water.depth, share);
    scene.ice.corner.back() += rise;
    for (std::size_t n = 1; n < scene.ice.profile.size(); n += 2) scene.ice.profile[n] += rise;
    scene.ice.base = IceBase::given;
    if (scene.ice.corner.back() >= 0.0) return;
    reading.report("ice.base", "floating, the ice's base would be " +
                                   metres(short_number(-scene.ice.corner.back())) +
                                   " below the tank's bottom; raise water.depth or make the ice thinner");
}

}  // namespace

void read_profiles(Reading& reading) {
    Scene& scene = reading.scene;
    if (!reading.usable({"effects"})) return;
    if (scene.has("bed")) read_profile(reading, "bed", scene.bed.profile_file, scene.bed.profile);
    if (scene.has("ice")) read_profile(reading, "ice", scene.ice.profile_file, scene.ice.profile);
}

void derive_glacier(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"effects", "dimension"}) || !scene.has("ice")) return;
    if (!reading.usable({"ice.profile", "domain.size"})) return;
    if (!scene.ice.profile.empty()) {
        if (!check_outline(reading)) return;
        derive_box(reading);
    }
    if (reading.usable({"ice.size", "ice.corner", "ice.base", "ice.density", "water.density", "water.depth"}))
        derive_floating(reading);
}

}  // namespace tidewater::scene
