#include "mpm/step/sort.h"

#include <algorithm>
#include <string>

#include "core/error.h"
#include "mpm/base/instantiate.h"
#include "mpm/particles/binning.h"
#include "mpm/particles/motion.h"
#include "mpm/step/crowding.h"
#include "mpm/step/drain.h"
#include "mpm/step/failures.h"
#include "mpm/step/skim.h"
#include "mpm/step/spray.h"

namespace tidewater::mpm {
namespace {

// What the step at hand would do to the particles of one block.
struct BlockStep {
    bool leaves = false;  // one may pass the margin
    double speed = 0.0;   // m/s, of what moves too far for one step; 0 where nothing does
};

template <int D, class Real>
BlockStep step_of_block(const Grid<D, Real>& grid, const std::vector<Particles<D, Real>>& bodies,
                        std::size_t slot, double near_speed, double drift, double dt) {
    const double cells_per_speed = dt / grid.layout.cell_size;
    if (drift + near_speed * cells_per_speed <= sorting_margin) return {};
    const BlockMotion motion = motion_of_block(grid, bodies, slot);
    BlockStep step;
    step.leaves = drift + motion.along * cells_per_speed > sorting_margin;
    if (motion.all * cells_per_speed > sorting_margin) step.speed = motion.all;
    return step;
}

}  // namespace

template <int D, class Real>
void sort_if_needed(const Interval& interval, const Parameters<D>& parameters,
                    const std::vector<double>& near_speed, Grid<D, Real>& grid,
                    const std::vector<RigidBody>& rigid, std::vector<Particles<D, Real>>& bodies,
                    std::vector<std::uint8_t>& unknown_fill, std::vector<double>& drift, Skimming& skimming,
                    Outflow<D>& outflow) {
    std::vector<BlockStep> steps(grid.particle_blocks.size());
    parallel_for(steps.size(), [&](std::size_t slot) {
        steps[slot] = step_of_block(grid, bodies, slot, near_speed[slot], drift[slot], interval.dt);
    });
    double speed = 0.0;
    bool leaves = false;
    for (const BlockStep& step : steps) {
        speed = std::max(speed, step.speed);
        leaves = leaves || step.leaves;
    }
    if (speed > 0.0) {
        throw NumericsError(where(interval, "sort") + "something moves by " +
                            std::to_string(speed * interval.dt / grid.layout.cell_size) +
                            " cells in one step, at " + std::to_string(speed) +
                            " m/s; use a smaller simulate.cfl");
    }
    if (!leaves) return;
    if (!interval.settling) {
        drain(parameters, grid, bodies, outflow);
        skim(parameters, interval.begin, grid, bodies, skimming, outflow);
    }
    sort_into_blocks<D, Real>(grid, bodies);
    open_spray(parameters.water, grid, rigid, bodies);
    unknown_fill = find_unknown_fill(parameters, interval.begin, grid, bodies);
    drift.assign(grid.particle_blocks.size(), 0.0);
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                              \
    template void sort_if_needed(const Interval&, const Parameters<D>&, const std::vector<double>&, \
                                 Grid<D, Real>&, const std::vector<RigidBody>&,                     \
                                 std::vector<Particles<D, Real>>&, std::vector<std::uint8_t>&,      \
                                 std::vector<double>&, Skimming&, Outflow<D>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
