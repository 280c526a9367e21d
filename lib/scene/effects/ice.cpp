#include "scene/effects/ice.h"

#include <algorithm>
#include <array>
#include <span>

#include "scene/effects/effect.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {

template <>
inline constexpr std::array<std::string_view, 2> enum_names<mpm::Moduli>{"plane_strain", "paper"};

namespace {

constexpr std::array keys{
    Key{.name = "ice.size",
        .unit = "m",
        .member = member<&Scene::ice, &Ice::size>(),
        .range = positive,
        .example = "[150, 40]",
        .effect = "ice",
        .required = true,
        .instead = "ice.profile",
        .per_dimension = true,
        .help = "edge lengths of the slab, or of the box from which \"dem\" cuts it"},
    Key{.name = "ice.corner",
        .unit = "m",
        .member = member<&Scene::ice, &Ice::corner>(),
        .range = not_negative,
        .example = "[0, 50]",
        .effect = "ice",
        .required = true,
        .instead = "ice.profile",
        .per_dimension = true,
        .help = "the slab's corner nearest to the origin, at the start"},
    Key{.name = "ice.profile",
        .unit = "m",
        .member = member<&Scene::ice, &Ice::profile>(),
        .range = not_negative,
        .example = "[0, 0, 0, 200, 600, 200, 580, 60, 600, 0]",
        .effect = "ice",
        .stages = by_all,
        .help = "x0, z0, x1, z1, … of the corners of its outline, instead of size and corner; in 3D over the "
                "whole "
                "width"},
    Key{.name = "ice.profile_file",
        .member = member<&Scene::ice, &Ice::profile_file>(),
        .example = "\"front.csv\"",
        .effect = "ice",
        .points_of = "ice.profile",
        .changes_results = false,
        .help = "a table of x and z, two columns, from which ice.profile is read"},
    Key{.name = "ice.base",
        .member = member<&Scene::ice, &Ice::base>(),
        .effect = "ice",
        .help = "given: as corner or profile say; bed: what reaches into the ground is cut off; floating: "
                "raised or "
                "lowered to where it floats"},
    Key{.name = "ice.density",
        .unit = "kg/m³",
        .member = member<&Scene::ice, &Ice::model, &mpm::IceModel::density>(),
        .range = positive,
        .effect = "ice",
        .stages = by_simulate | by_postprocess,
        .help = "900 to 920"},
    Key{.name = "ice.youngs_modulus",
        .unit = "Pa",
        .member = member<&Scene::ice, &Ice::model, &mpm::IceModel::youngs_modulus>(),
        .range = positive,
        .effect = "ice",
        .stages = by_simulate,
        .help = "E; 1e10 as measured on ice, 1e9 and less for longer time steps"},
    Key{.name = "ice.poisson_ratio",
        .member = member<&Scene::ice, &Ice::model, &mpm::IceModel::poisson_ratio>(),
        .range = {.min = 0.0, .max = 0.49},
        .effect = "ice",
        .stages = by_simulate,
        .help = "ν"},
    Key{.name = "ice.moduli",
        .member = member<&Scene::ice, &Ice::model, &mpm::IceModel::moduli>(),
        .effect = "ice",
        .stages = by_simulate,
        .help = "of a 2D scene: a slice's, as E and ν say; or the paper's κ = λ + 2μ/3, whose beams are 4 % "
                "softer"},
};

// Checks ice.profile. Returns false if it is not an outline.
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
    if (geometry::area(outline) <= 0.0) return report("the outline has no area; its corners lie on one line");
    return true;
}

// The size and the corner become the box around the outline. In 3D it spans the tank's width.
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
    if (share >= 1.0) {
        return reading.report("ice.base",
                              "\"floating\" needs an ice.density below water.density; lower ice.density or "
                              "set base = \"given\"");
    }
    const double rise = geometry::rise_to_float(ice_outline(scene), scene.water.depth, share);
    scene.ice.corner.back() += rise;
    for (std::size_t n = 1; n < scene.ice.profile.size(); n += 2) scene.ice.profile[n] += rise;
    scene.ice.base = IceBase::given;
    if (scene.ice.corner.back() >= 0.0) return;
    reading.report("ice.base", "floating, the ice's base would be " +
                                   metres(short_number(-scene.ice.corner.back())) +
                                   " below the tank's bottom; raise water.depth or make the ice thinner");
}

void derive(Reading& reading) {
    if (!reading.usable({"dimension", "ice.profile", "domain.size"})) return;
    if (!reading.scene.ice.profile.empty()) {
        if (!check_outline(reading)) return;
        derive_box(reading);
    }
    if (reading.usable({"ice.size", "ice.corner", "ice.base", "ice.density", "water.density", "water.depth"}))
        derive_floating(reading);
}

void check_inside(Reading& reading) {
    const Scene& scene = reading.scene;
    for (std::size_t axis = 0; axis < scene.ice.size.size(); ++axis) {
        const double high = scene.ice.corner[axis] + scene.ice.size[axis];
        if (high <= scene.domain.size[axis] + tolerance * scene.domain.cell_size) continue;
        reading.report("ice.corner", std::string("the ice ends outside the tank: along ") +
                                         axis_name(axis, scene.dimension) + " at " +
                                         metres(short_number(high)) + ", the tank at " +
                                         metres(scene.domain.size[axis]) +
                                         "; move ice.corner or shrink ice.size");
    }
}

void check_shelf(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!scene.has("shelf") || !reading.usable({"shelf.length", "shelf.height"})) return;
    const double slack = tolerance * scene.domain.cell_size;
    const bool above = scene.ice.corner.back() >= scene.shelf.height - slack;
    const bool beyond = scene.ice.corner.front() >= scene.shelf.length - slack;
    if (above || beyond) return;
    reading.report("ice.corner", "the ice reaches into the shelf: its base is at " +
                                     metres(scene.ice.corner.back()) + ", the shelf's top at " +
                                     metres(scene.shelf.height) + "; raise the ice or lower shelf.height");
}

// Only a plain box must lie above the bed. A profile may follow it, and an elevation model or base = "bed"
// cut the ice off at the ground.
void check_bed(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"ice.base"})) return;
    const bool cut = scene.ice.base == IceBase::bed;
    if (cut && !scene.has("bed")) {
        reading.report("ice.base",
                       "\"bed\" needs ground to rest on; add \"bed\" to effects, or set \"given\"");
    }
    if (cut || !bed_profile_known(reading) || !scene.dem.surface.empty() || !scene.ice.profile.empty())
        return;
    const double ground = bed_profile(scene).highest(scene.ice.corner.front(), front_of(scene));
    if (scene.ice.corner.back() >= ground - tolerance * scene.domain.cell_size) return;
    reading.report("ice.corner", "the ice reaches into the bed: its base is at " +
                                     metres(scene.ice.corner.back()) + ", the ground below it rises to " +
                                     metres(short_number(ground)) +
                                     "; raise the ice, lower bed.profile, or set ice.base = \"bed\"");
}

void check(Reading& reading) {
    if (!ice_box_known(reading)) return;
    check_inside(reading);
    check_shelf(reading);
    check_bed(reading);
}

std::vector<Body> bodies(const Scene& scene) {
    Body ice{"the ice", {}};
    for (const double edge : scene.ice.size) ice.edges.push_back({edge, "ice.size"});
    return {ice};
}

}  // namespace

geometry::Box ice_box(const Scene& scene) {
    std::vector<double> center = scene.ice.corner;
    for (std::size_t axis = 0; axis < center.size(); ++axis) center[axis] += 0.5 * scene.ice.size[axis];
    return make_box(scene, center, scene.ice.size);
}

geometry::Polygon ice_outline(const Scene& scene) {
    geometry::Polygon outline;
    const auto& list = scene.ice.profile;
    for (std::size_t n = 0; n + 1 < list.size(); n += 2) outline.emplace_back(list[n], list[n + 1]);
    if (!outline.empty()) return outline;
    const auto corners = geometry::corners(ice_box(scene));
    return {corners.begin(), corners.end()};
}

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

bool ice_box_known(const Reading& reading) {
    return reading.scene.has("ice") &&
           reading.usable({"dimension", "domain.size", "domain.cell_size", "ice.size", "ice.corner"});
}

double front_of(const Scene& scene) { return scene.ice.corner.front() + scene.ice.size.front(); }

constinit const Effect ice_effect{
    .name = "ice", .keys = keys, .derive = derive, .check = check, .bodies = bodies};

}  // namespace tidewater::scene
