#include "scene/effects/settle.h"

#include <array>

#include "scene/effects/effect.h"

namespace tidewater::scene {
namespace {

constexpr std::array keys{
    Key{.name = "settle.tolerance",
        .unit = "Pa",
        .member = member<&Scene::settle, &Settle::tolerance>(),
        .range = positive,
        .effect = "settle",
        .stages = by_simulate,
        .help = "the start has settled when the stress ρ c v of the waves that are left is below"},
    Key{.name = "settle.max_time",
        .unit = "s",
        .member = member<&Scene::settle, &Settle::max_time>(),
        .range = positive,
        .effect = "settle",
        .stages = by_simulate,
        .help = "after which a start that does not settle is an error"},
};

}  // namespace

constinit const Effect settle_effect{.name = "settle", .keys = keys};

}  // namespace tidewater::scene
