// Closed surfaces around bodies of particles, icebergs for instance, of one frame for ParaView: the files
// iceberg_surfaces_NNNN.vtp.
//
// The volume share φ of each body by itself is spread from its particles onto a grid as wide as their spacing
// s with quadratic B-splines N of width w = 2 s,
//     φ(x) = Σ_p V_p Π_axes N((x_p − x)/w) / w^d,
// and the surface is φ = c: in 3D triangles around the body (VTK's flying edges), in 2D its area, in
// triangles, in the plane y = 0. c is such that the surface encloses the volume of the body's particles, to
// 0.1 %. At c = 1/2 plane faces would stay where they are, but rounded edges would cost a box of n particles
// an axis 12/n² of its volume and a ball 15/n²; c is a little less, and faces lie at most s/4 farther out,
// for n from 8 on. Gaps within a body that are wider than s stay open. Bodies that touch have a surface each.
//
// Cell arrays: `iceberg` and `material` (numbers of core's Material), `volume` (m³, 2D: m²; of its particles
// at rest). Data is inline binary, compressed with zlib.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/provenance.h"

namespace tidewater::io {

inline constexpr int body_surfaces_format_version = 1;

// "iceberg_surfaces_0007.vtp"; more digits from frame 10000 on.
std::string body_surfaces_name(std::size_t frame);

struct BodyParticles {
    int dimension = 3;              // 2 or 3
    double spacing = 0.0;           // s > 0, m
    std::span<const float> points;  // m, (x, y, z) per particle; y is not read in 2D
    std::span<const float> volume;  // m³ (2D: m²), at rest
};

struct Body {
    std::int32_t iceberg = 0;
    std::uint8_t material = 1;
    std::vector<std::uint32_t> particles;  // entries of BodyParticles
};

// In the order of the bodies; needs 4 B per grid point in the box around the greatest body, and the surfaces.
// Replaces path as a whole. Throws OutputError.
void write_body_surfaces(const std::filesystem::path& path, const BodyParticles& particles,
                         std::span<const Body> bodies, const Provenance& provenance);

}  // namespace tidewater::io
