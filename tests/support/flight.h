// Starts for tests: cubes of water, ice and what is rigid that fly, spin and meet, with or without weight.
#pragma once

#include <cmath>

#include "core/random.h"
#include "mpm/step/start.h"
#include "mpm/step/step.h"

namespace tidewater::test {

enum class Scene { water, elastic_ice, fracturing_ice, rigid, mixed };

// How a cube of particles begins. Lengths in cells.
template <int D>
struct Cube {
    Material material = Material::water;
    Vector<D, double> corner;
    double size = 4.0;
    Vector<D, double> velocity = Vector<D, double>::Zero();  // of its middle, m/s
    double turning = 0.0;                                    // in the x–z plane, 1/s
    double stretching = 0.0;                                 // ∂v/∂x along the last axis, 1/s
    int per_axis = 2;                                        // particles to a cell and axis
};

// Adds the cube; its points are whole multiples of 2⁻¹⁶ cells, moved off the lattice by up to a quarter of
// their distance.
template <int D>
void add_cube(const Cube<D>& cube, mpm::Start<D>& start) {
    auto& body = start.bodies.emplace_back();
    body.material = cube.material;
    const int along = static_cast<int>(cube.size * cube.per_axis);
    const Vector<D, double> middle =
        start.cell_size * (cube.corner + Vector<D, double>::Constant(0.5 * cube.size));
    Matrix<D, double> gradient = Matrix<D, double>::Zero();
    gradient(0, D - 1) = cube.turning;
    gradient(D - 1, 0) = -cube.turning;
    gradient(D - 1, D - 1) = cube.stretching;
    for (int n = 0; n < mpm::power(along, D); ++n) {
        Vector<D, double> point;
        for (int axis = D - 1, rest = n; axis >= 0; --axis, rest /= along) {
            const double shift = 0.5 * (random_uniform(start.bodies.size(), static_cast<std::uint64_t>(axis),
                                                       static_cast<std::uint64_t>(n)) -
                                        0.5);
            const double cells = cube.corner[axis] + (rest % along + 0.5 + shift) / cube.per_axis;
            point[axis] = start.cell_size * std::round(cells * 65536.0) / 65536.0;
        }
        body.points.push_back(point);
        body.velocity.push_back(cube.velocity + gradient * (point - middle));
        body.gradient.push_back(gradient);
    }
    const double density = cube.material == Material::water ? 1000.0 : 900.0;
    body.volume = std::pow(cube.size * start.cell_size, D);
    body.mass = density * body.volume;
    body.surface = -1.0;  // no pressure at the start
}

// Likewise as a rigid body.
template <int D>
void add_rigid(const Cube<D>& cube, mpm::Start<D>& start) {
    const Vector<D, double> size = Vector<D, double>::Constant(start.cell_size * cube.size);
    start.rigid.push_back({.size = size,
                           .center = start.cell_size * cube.corner + 0.5 * size,
                           .density = 900.0,
                           .contact = mpm::BodyContact::stick,
                           .velocity = cube.velocity,
                           .spin = -cube.turning});
}

// Soft ice and slow water in an empty box with Δx = 1/16 m: sound at 20 … 40 m/s, failure at 0.1 % of strain.
template <int D>
mpm::Start<D> empty_start(int cells, double gravity = 0.0) {
    mpm::Start<D> start;
    start.cell_size = 0.0625;
    start.cells.fill(cells);
    start.parameters.gravity = gravity;
    start.parameters.water.sound_speed = 20.0;
    start.parameters.ice.youngs_modulus = 1e6;
    start.parameters.ice.beta_p0 = 1000.0;
    start.parameters.ice.beta = 0.5;
    return start;
}

template <int D>
Vector<D, double> cells_at(double x, double y, double z) {
    if constexpr (D == 2)
        return {x, z};
    else
        return {x, y, z};
}

// Spinning and pulsing cubes in free flight, from node `at` on each axis. They move at 0.5 m/s along x; a
// mixed scene is one of each kind, meeting in the air.
template <int D>
mpm::Start<D> flying_start(Scene scene, int cells, double at) {
    auto start = empty_start<D>(cells);
    start.parameters.ice.fracture = scene != Scene::elastic_ice;
    const double size = D == 2 ? 6.0 : 3.0;
    const auto fly = [&](Material material, double right, double up, double speed) {
        const Cube<D> cube{material, cells_at<D>(at + right, at, at + up),
                           size,     cells_at<D>(0.5 + speed, 0.05, 0.1 - 0.3 * speed),
                           0.7,      0.5};
        material == Material::rigid ? add_rigid(cube, start) : add_cube(cube, start);
    };
    const bool mixed = scene == Scene::mixed;
    if (scene == Scene::water || mixed) fly(Material::water, 0.0, 0.0, 0.0);
    if (scene == Scene::rigid || mixed)
        fly(Material::rigid, mixed ? size + 0.75 : 0.0, 0.5, mixed ? -0.4 : 0.0);
    if (scene == Scene::elastic_ice || scene == Scene::fracturing_ice || mixed)
        fly(Material::ice, 0.5, mixed ? size + 0.5 : 0.0, mixed ? 0.3 : 0.0);
    return start;
}

}  // namespace tidewater::test
