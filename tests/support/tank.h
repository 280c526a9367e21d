// Starts of simulations for tests: a box of still water, and a block in or above it.
#pragma once

#include <functional>

#include "core/random.h"
#include "mpm/step/start.h"
#include "mpm/step/step.h"

namespace tidewater::test {

// Lattice points, per_axis to a cell and axis and moved by up to jitter/2 of their spacing, where
// inside(point) holds.
template <int D>
std::vector<Vector<D, double>> lattice(double cell_size, const mpm::Index<D>& cells, int per_axis,
                                       double jitter,
                                       const std::function<bool(const Vector<D, double>&)>& inside) {
    const double spacing = cell_size / per_axis;
    long count = 1;
    for (const int along : cells) count *= along * per_axis;
    std::vector<Vector<D, double>> points;
    for (long n = 0; n < count; ++n) {
        Vector<D, double> point;
        long rest = n;
        for (int axis = D - 1; axis >= 0; --axis) {
            const long along = static_cast<long>(cells[static_cast<std::size_t>(axis)]) * per_axis;
            point[axis] = (static_cast<double>(rest % along) + 0.5) * spacing;
            rest /= along;
        }
        if (!inside(point)) continue;
        for (int axis = 0; axis < D; ++axis) {
            const auto stream = static_cast<std::uint64_t>(axis);
            point[axis] +=
                jitter * spacing * (random_uniform(1, stream, static_cast<std::uint64_t>(n)) - 0.5);
        }
        points.push_back(point);
    }
    return points;
}

// A tank of these cells with water up to `depth` and, if block_size > 0, a cubic block whose lower corner is
// `corner`.
template <int D>
mpm::Start<D> tank_start(double cell_size, const mpm::Index<D>& cells, double depth, double sound_speed,
                         double block_size = 0.0, const Vector<D, double>& corner = Vector<D, double>::Zero(),
                         int per_axis = 2, double jitter = 0.0) {
    const auto in_block = [&](const Vector<D, double>& point) {
        const Vector<D, double> from = point - corner;
        return block_size > 0.0 && from.minCoeff() > 0.0 && from.maxCoeff() < block_size;
    };
    mpm::Start<D> start;
    start.cell_size = cell_size;
    start.cells = cells;
    start.parameters.water.sound_speed = sound_speed;
    auto& water = start.bodies.emplace_back();
    water.points = lattice<D>(cell_size, cells, per_axis, jitter,
                              [&](const auto& point) { return point[D - 1] < depth && !in_block(point); });
    const double share = std::pow(cell_size / per_axis, D);
    water.volume = share * static_cast<double>(water.points.size());
    water.mass = start.parameters.water.density * water.volume;
    water.surface = depth;
    if (block_size > 0.0) {
        mpm::RigidStart<D>& block = start.rigid.emplace_back();
        block.size = Vector<D, double>::Constant(block_size);
        block.center = corner + 0.5 * block.size;
        block.contact = mpm::BodyContact::stick;
    }
    return start;
}

// A block that falls partly into disordered water, off-centre, so that it turns.
template <int D>
mpm::Start<D> dropped_block_start(mpm::WallRule rule = mpm::WallRule::slip) {
    mpm::Index<D> cells;
    cells.fill(D == 2 ? 20 : 9);
    cells[D - 1] = D == 2 ? 24 : 12;
    Vector<D, double> corner = Vector<D, double>::Constant(D == 2 ? 0.33 : 0.24);
    corner[D - 1] = D == 2 ? 0.55 : 0.35;
    mpm::Start<D> start = tank_start<D>(0.05, cells, D == 2 ? 0.6 : 0.4, 20.0, 0.2, corner, 2, 0.5);
    for (auto& axis : start.parameters.boundaries.walls) axis = {rule, rule};
    return start;
}

}  // namespace tidewater::test
