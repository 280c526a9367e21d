#include "glacier.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/error.h"
#include "geometry/front.h"
#include "geometry/height_solid.h"
#include "io/text.h"

namespace tidewater {
namespace {

using geometry::common;
using geometry::HeightField;
using geometry::Point;
using geometry::Solid;
using geometry::without;

constexpr double most_shared = 1e-3;  // of the ice's volume in the ground: what volumes are found to

geometry::Extent extent_of_ice(const scene::Scene& scene, double amplitude) {
    const geometry::Box box = ice_box(scene);
    const Point room(amplitude, 0.0, 0.0);
    return {box.center - box.half_size, box.center + box.half_size + room};
}

// The outline's top along x at every node line; constant of a box.
HeightField outline_surface(const scene::Scene& scene) {
    const geometry::Polygon outline = ice_outline(scene);
    const auto& corner = scene.ice.corner;
    const auto& size = scene.ice.size;
    HeightField field{.spacing = scene.domain.cell_size, .heights = {}};
    field.nx = scene.ice.profile.empty()
                   ? 1
                   : static_cast<int>(std::lround(scene.domain.size.front() / field.spacing)) + 1;
    for (int n = 0; n < field.nx; ++n) {
        const double x = std::clamp(n * field.spacing, corner.front(), corner.front() + size.front());
        field.heights.push_back(geometry::top_at(outline, x).value_or(corner.back() + size.back()));
    }
    return field;
}

// Where the front is at a height; that of the box where the outline does not reach it.
double front_of(const scene::Scene& scene, double z) {
    return geometry::front_at(ice_outline(scene), z)
        .value_or(scene.ice.corner.front() + scene.ice.size.front());
}

geometry::Notch notch_of(const scene::Scene& scene) {
    if (!scene.has("undercut")) return {};
    return {.depth = scene.undercut.depth,
            .height = scene.undercut.height,
            .top = scene.water.depth - scene.undercut.below};
}

geometry::Cliff cliff_of(const scene::Scene& scene) {
    if (!scene.has("cliff")) return {};
    return {.amplitude = scene.cliff.amplitude,
            .wavelength = scene.cliff.wavelength,
            .wavelength_up = scene.cliff.wavelength_up,
            .seed = scene.seed + 1};  // another noise than the crevasses'
}

Solid crack_solid(const geometry::Cracks& cracks, double width) {
    const auto finder = std::make_shared<geometry::CrackFinder>(cracks);
    return [finder, width](const Point& point) { return finder->wall_distance(point) - 0.5 * width; };
}

// The greatest x of the ice at a height and mid-width, to a thousandth of a cell; the rear if there is none.
double front_at_height(const scene::Scene& scene, const Glacier& glacier, double z) {
    const double y = scene.dimension == 2 ? 0.0 : 0.5 * scene.domain.size[1];
    const double step = 0.25 * scene.domain.cell_size, rear = glacier.extent.low[0];
    double inside = glacier.extent.high[0];
    while (inside > rear && glacier.uncut({inside, y, z}) > 0.0) inside -= step;
    double outside = inside + step;
    for (int n = 0; n < 8; ++n) {
        const double middle = 0.5 * (inside + outside);
        (glacier.uncut({middle, y, z}) > 0.0 ? outside : inside) = middle;
    }
    return std::max(inside, rear);
}

void measure_front(const scene::Scene& scene, bool surface, Glacier& glacier) {
    const double level =
        scene.has("water") ? scene.water.depth : 0.5 * (glacier.extent.low[2] + glacier.extent.high[2]);
    const double z = std::clamp(level, glacier.extent.low[2], glacier.extent.high[2]);
    glacier.front =
        surface ? front_at_height(scene, glacier, z + scene.domain.cell_size) : front_of(scene, z);
}

// Where the surface lies on the vertical between a height inside and one outside, m.
double height_between(const Solid& ice, Point inside, double outside) {
    for (int n = 0; n < 40; ++n) {
        Point middle = inside;
        middle[2] = 0.5 * (inside[2] + outside);
        if (ice(middle) <= 0.0)
            inside = middle;
        else
            outside = middle[2];
    }
    return inside[2];
}

// Base and top of the uncut ice, over the tenth of its length behind the front, at mid-width.
void measure_height(const scene::Scene& scene, Glacier& glacier) {
    const double cell = scene.domain.cell_size, y = scene.dimension == 2 ? 0.0 : 0.5 * scene.domain.size[1];
    const double low = glacier.extent.low[2] - cell, high = glacier.extent.high[2] + cell;
    glacier.base = high, glacier.top = low;
    for (double x = glacier.front - 0.1 * (glacier.front - glacier.extent.low[0]); x < glacier.front;
         x += cell) {
        for (double z = low; z < high; z += 0.25 * cell) {
            if (glacier.uncut({x, y, z}) > 0.0) continue;
            if (z < glacier.base) glacier.base = height_between(glacier.uncut, {x, y, z}, z - 0.25 * cell);
            if (z > glacier.top) glacier.top = height_between(glacier.uncut, {x, y, z}, z + 0.25 * cell);
        }
    }
}

// Ice that is not cut off at the ground must not reach into it.
void check_overlap(const scene::Scene& scene, const Solid& ground, const Glacier& glacier, int levels) {
    const double shared = geometry::volume(common(glacier.uncut, ground), glacier.extent,
                                           scene.domain.cell_size, levels, scene.dimension);
    if (shared < most_shared * glacier.uncut_volume) return;
    throw SceneError("the ice and the ground share room: " + io::format_fixed(shared, 0) +
                     (scene.dimension == 2 ? " m²" : " m³") + " of the ice, " +
                     io::format_fixed(100.0 * shared / glacier.uncut_volume, 1) +
                     " %, lies in the ground; set ice.base = \"bed\" to cut it off there, or raise the ice");
}

}  // namespace

Glacier make_glacier(const scene::Scene& scene, const Solid& ground,
                     const std::optional<HeightField>& surface) {
    Glacier glacier;
    const geometry::Cliff cliff = cliff_of(scene);
    glacier.extent = extent_of_ice(scene, cliff.amplitude);
    glacier.surface = surface ? *surface : outline_surface(scene);

    const geometry::Notch notch = notch_of(scene);
    const double low = scene.ice.corner.front(), front = front_of(scene, notch.top - 0.5 * notch.height);
    const bool outline = !scene.ice.profile.empty();
    Solid ice = outline ? geometry::prism(ice_outline(scene), glacier.extent.low[1], glacier.extent.high[1])
                        : box_solid(ice_box(scene));
    ice = geometry::with_front(std::move(ice), low, front, cliff, notch);
    const bool grounded = ground && (scene.ice.base == scene::IceBase::bed || surface);
    if (surface) ice = common(std::move(ice), geometry::below(*surface));
    if (grounded) ice = without(std::move(ice), ground);
    glacier.uncut = ice;

    glacier.crevasses = scene_crevasses(scene);
    if (glacier.crevasses) {
        const auto list = std::make_shared<geometry::Crevasses>(*glacier.crevasses);
        const auto top = std::make_shared<HeightField>(glacier.surface);
        ice = without(std::move(ice), [list, top](const Point& p) {
            return signed_distance(*list, p[0], p[1], top->height(p[0], p[1]) - p[2]);
        });
    }
    glacier.whole = ice;
    glacier.cracks = scene_cracks(scene);
    glacier.shown = glacier.cracks ? without(ice, crack_solid(*glacier.cracks, scene.cracks.width)) : ice;

    const int dimension = scene.dimension, levels = volume_levels(dimension);
    const auto measured = [&](const Solid& solid) {
        return geometry::volume(solid, glacier.extent, scene.domain.cell_size, levels, dimension);
    };
    const bool exact = cliff.amplitude == 0.0 && notch.depth == 0.0 && !surface && !grounded;
    const double width = dimension == 2 ? 1.0 : scene.ice.size[1];
    glacier.uncut_volume = exact ? width * geometry::area(ice_outline(scene)) : measured(glacier.uncut);
    if (ground && !grounded) check_overlap(scene, ground, glacier, levels);
    glacier.volume = glacier.crevasses ? measured(glacier.whole) : glacier.uncut_volume;
    measure_front(scene, surface.has_value(), glacier);
    measure_height(scene, glacier);
    return glacier;
}

}  // namespace tidewater
