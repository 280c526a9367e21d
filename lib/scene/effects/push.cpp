#include "scene/effects/push.h"

#include <array>

#include "mpm/boundaries/push.h"
#include "scene/effects/effect.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

constexpr std::array keys{
    Key{.name = "push.speed",
        .unit = "m/s",
        .member = member<&Scene::push, &Push::speed>(),
        .range = positive,
        .example = "1",
        .effect = "push",
        .required = true,
        .stages = by_simulate,
        .help = "of a plane that starts at the left wall and pushes what it meets"},
    Key{.name = "push.ramp",
        .unit = "s",
        .member = member<&Scene::push, &Push::ramp>(),
        .range = not_negative,
        .effect = "push",
        .stages = by_simulate,
        .help = "in which its speed rises; a sudden start sends a wave of stress ρ c v through the ice"},
};

// What is pushed must end before the tank does.
std::vector<std::string> warnings(const Scene& scene) {
    const mpm::Push push{scene.push.speed, scene.push.ramp};
    const double end = push.position(scene.simulate.end_time);
    const double length = scene.has("ice") ? scene.ice.size.front() : 0.0;
    if (end + length <= scene.domain.size.front()) return {};
    return {"push.speed: by simulate.end_time the plane is at x = " + metres(short_number(end)) +
            " and what it pushes has reached the right wall; end earlier or push more slowly"};
}

}  // namespace

constinit const Effect push_effect{.name = "push", .keys = keys, .warnings = warnings};

}  // namespace tidewater::scene
