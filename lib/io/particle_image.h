// The particles of a frame as pixels: water coloured by speed, ice by damage or by iceberg, rigid blocks.
#pragma once

#include <cstdint>
#include <span>

#include "io/splat.h"

namespace tidewater::io {

// Flat arrays as in Snapshot.
struct PictureParticles {
    std::span<const float> points;                // m, (x, y, z) per particle
    std::span<const float> velocity;              // m/s, (x, y, z) per particle
    std::span<const std::uint8_t> material;       // numbers of core's Material
    std::span<const float> damage = {};           // empty: ice is drawn as intact
    std::span<const std::uint32_t> iceberg = {};  // of each particle, 0: none; not empty: ice is coloured by
                                                  // it, what belongs to none by its damage
};

// Of what is seen in a view, with a dark outline of each solid and each iceberg `outline` pixels wide. Water
// of greatest_speed (m/s, > 0) has the scale's last colour. In 2D (shaded: false) gaps between particles,
// which are `spacing` m apart, close, and in 3D others show behind them, shaded. Elsewhere the picture is
// transparent. The same particles give the same picture.
Canvas draw_particles(const PictureParticles& particles, const View& view, int width, int height,
                      double spacing, double greatest_speed, double outline, bool shaded);

}  // namespace tidewater::io
