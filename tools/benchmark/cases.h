// The scenes that are timed: a fjord 100 m deep, cut into as many cells as the wanted number of particles
// asks for, with 4 particles per cell in 2D and 8 in 3D, each moved at random by up to a quarter of their
// spacing.
//
//     water2d, water3d   a tank of water that turns over at up to 10 m/s (in 3D along and across)
//     plain2d, plain3d   the same with the scheme of the paper
//     restored2d, restored3d   the same with the transfer that loses less
//     ice2d, ice3d       a slab under gravity that slides at 10 m/s and is shaken lengthwise, its front
//                        harder than its rear, so that part of it yields and the rest stays elastic
//     elastic2d, elastic3d   the same without fracture
//     mixed3d            an ice cliff that advances into turning water, in which an iceberg (rigid) floats
//
// Speeds are such that particles change their blocks as in a scene with a calving glacier.
#pragma once

#include <span>
#include <string_view>

#include "mpm/step/start.h"
#include "mpm/step/step.h"

namespace tidewater::benchmark {

struct Case {
    std::string_view name;
    int dimension = 0;
    std::string_view material;
};

std::span<const Case> cases();

// The scene of this case and dimension with about so many particles, at least 64 cells.
template <int D>
mpm::Start<D> make_scene(std::string_view name, long particles);

}  // namespace tidewater::benchmark
