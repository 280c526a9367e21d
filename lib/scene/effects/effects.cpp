#include "scene/effects/effects.h"

#include <array>
#include <vector>

#include "scene/scene.h"

namespace tidewater::scene {
namespace {

constexpr std::array effects{
    &water_effect,    &wave_effect,      &rigid_effect,  &ice_effect,    &fracture_effect, &cliff_effect,
    &undercut_effect, &crevasses_effect, &cracks_effect, &dem_effect,    &shelf_effect,    &bed_effect,
    &push_effect,     &piston_effect,    &outlet_effect, &sponge_effect, &settle_effect,
};

}  // namespace

std::span<const Effect* const> all_effects() { return effects; }

std::span<const std::string> known_effects() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Effect* effect : all_effects()) all.emplace_back(effect->name);
        return all;
    }();
    return names;
}

}  // namespace tidewater::scene
