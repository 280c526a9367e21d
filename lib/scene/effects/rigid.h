// The effect "rigid": one or several rigid blocks, each under a [block] or [[block]] of its own.
#pragma once

#include <vector>

#include "geometry/box.h"
#include "mpm/bodies/rigid.h"

namespace tidewater::scene {

struct Effect;
struct Scene;

// The keys of one [[block]]; rigid.cpp says what each means.
struct Block {
    std::vector<double> size;    // m
    std::vector<double> center;  // m
    double angle = 0.0;          // degrees
    double density = 920.0;      // kg/m³
    mpm::BodyContact contact = mpm::BodyContact::slip;
    double friction = 0.0, drag = 0.0;
    std::vector<double> velocity;  // m/s
    double spin = 0.0;             // degrees/s
};

geometry::Box block_box(const Scene& scene, const Block& block);

// An estimate of the fastest speed that any block reaches, m/s.
double fastest_block(const Scene& scene);

extern const Effect rigid_effect;

}  // namespace tidewater::scene
