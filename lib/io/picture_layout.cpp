#include "io/picture_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tidewater::io {
namespace {

// Looking along the tank's width in 2D; in 3D turned by 14° and from 25° above.
View make_view(const PictureSettings& settings) {
    if (settings.dimension == 2) return {};
    const double turn = 14.0 * std::numbers::pi / 180.0, tilt = 25.0 * std::numbers::pi / 180.0;
    const double ct = std::cos(turn), st = std::sin(turn), cp = std::cos(tilt), sp = std::sin(tilt);
    return {.right = {ct, st, 0.0},
            .up = {-st * sp, ct * sp, cp},
            .toward = {st * cp, -ct * cp, sp},
            .origin = {}};
}

}  // namespace

std::array<double, 3> corner(const PictureSettings& settings, int index) {
    const auto at = [&](int bit, std::size_t axis) {
        return index & bit ? settings.high[axis] : settings.low[axis];
    };
    return {at(1, 0), at(2, 1), at(4, 2)};
}

Layout make_layout(const PictureSettings& settings) {
    Layout layout;
    layout.width = settings.width;
    layout.unit = settings.width / 1600.0;
    layout.letters = std::max(19.0 * layout.unit, 9.0);
    layout.view = make_view(settings);
    constexpr double far = std::numeric_limits<double>::infinity();
    double left = far, right = -far, top = far, bottom = -far;  // of the silhouette at scale 1
    for (int i = 0; i < 8; ++i) {
        const Pixel p = layout.view.project(corner(settings, i));
        left = std::min(left, p.x);
        right = std::max(right, p.x);
        top = std::min(top, p.y);
        bottom = std::max(bottom, p.y);
    }
    const double u = layout.unit, margin_left = 84 * u, margin_right = 36 * u, margin_top = 134 * u;
    const double room = settings.width - margin_left - margin_right;
    layout.view.scale = std::min(room / (right - left), 1100.0 * u / (bottom - top));
    const double width = layout.view.scale * (right - left), height = layout.view.scale * (bottom - top);
    layout.left = margin_left;
    layout.right = margin_left + room;
    layout.low = {std::round(margin_left + 0.5 * (room - width)), std::round(margin_top)};
    layout.high = {layout.low.x + width, layout.low.y + height};
    layout.view.origin = {layout.low.x - layout.view.scale * left, layout.low.y - layout.view.scale * top};
    layout.height = static_cast<int>(std::ceil(layout.high.y + 76 * u));
    return layout;
}

}  // namespace tidewater::io
