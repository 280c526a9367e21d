// Ground that rubs and drags, for tests.
#pragma once

#include <functional>

#include "mpm/step/start.h"

namespace tidewater::test {

// Lays ground of this height, the same for all y, under a start.
template <int D>
void lay_bed(const std::function<double(double)>& height, const mpm::GroundRule& rule, mpm::Start<D>& start) {
    mpm::Bed<D>& bed = start.parameters.boundaries.bed;
    bed.rule = rule;
    bed.spacing = start.cell_size;
    bed.points.fill(1);
    bed.points[0] = start.cells[0] + 1;
    for (int n = 0; n <= start.cells[0]; ++n) bed.heights.push_back(height(n * start.cell_size));
}

// Ground of a cell and a half below all that a start holds, with all the laws at once.
template <int D>
mpm::Start<D> on_rough_ground(mpm::Start<D> start) {
    mpm::GroundRule rule;
    rule.ice.friction = 0.4;
    rule.ice.weertman = 1e5;
    rule.ice.pore_pressure = 0.5;
    rule.sea_level = 0.5;
    rule.sea_weight = 1e4;
    lay_bed<D>([dx = start.cell_size](double x) { return (1.4 + 0.2 * std::sin(x / dx)) * dx; }, rule, start);
    start.parameters.boundaries.drag.bed.manning = 0.05;
    for (auto& block : start.rigid) {
        block.contact = mpm::BodyContact::slip;
        block.friction = 0.1;
        block.drag = 0.01;
    }
    return start;
}

}  // namespace tidewater::test
