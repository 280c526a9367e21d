// What stands around a frame in its picture: time, title, colour scale, legend and scale bar.
#pragma once

#include "io/picture_layout.h"

namespace tidewater::io {

// In two rows above the frame: time, title and the colour scale of the water's speed, if there is water;
// below what the other colours and lines mean, of what is there.
void draw_heading(Drawing& drawing, const PictureParticles& particles, const PictureSettings& settings,
                  const Layout& layout);

// A bar of a round length along x, below the frame's right end.
void draw_scale_bar(Drawing& drawing, const PictureSettings& settings, const Layout& layout);

// Whether a particle is of this material, a number of core's Material.
bool any_of(const PictureParticles& particles, std::uint8_t material);

}  // namespace tidewater::io
