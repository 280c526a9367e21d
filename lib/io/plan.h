// A scene from above: ice, land and the water's depths.
#pragma once

#include <functional>

#include "io/drawing.h"
#include "io/panel.h"
#include "io/substance.h"

namespace tidewater::io {

// What is seen from above at a place.
struct Top {
    Substance substance = Substance::nothing;
    double height = 0.0;  // m, z of the uppermost surface
    double bed = 0.0;     // m, z of the ground below; read where the substance is water
};

// Fills the panel, with two colour bars to the right of it; `top` is asked once a pixel, in parallel. Ice and
// land are shaded as by light from the upper left; ice is coloured by its height above `still_level`, water
// by its depth, with up to ten contours that its colour bar shows too. The front is drawn where ice meets
// open water: water in cracks and crevasses less than 9 pixels wide is not open. `unit` as for draw_axes.
void draw_plan(Drawing& drawing, const Panel& panel, const std::function<Top(double x, double y)>& top,
               double still_level, double unit);

// How far the colour bars reach below the panel's upper side, in pixels.
double plan_bars_height(const Panel& panel, double unit);

// Colour of water of this share of the greatest depth, and of ice of this share of the greatest height above
// the still level before shading; clamped.
Color depth_color(double share);
Color ice_height_color(double share);

inline constexpr Color front_color{213, 94, 0};

}  // namespace tidewater::io
