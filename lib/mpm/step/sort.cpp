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

namespace tidewater::mpm {
namespace {

// An upper bound of the speed of all particles, m/s. It is the nodes' speed or, only where that is too much
// for the step, the particles' own: a node at the rim of a lone particle's stencil has almost none of its
// mass and may be several times as fast.
template <int D, class Real>
double max_particle_speed(const Grid<D, Real>& grid, const std::vector<Particles<D, Real>>& bodies,
                          double node_speed, double dt) {
    if (node_speed * dt / grid.layout.cell_size <= sorting_margin) return node_speed;
    double speed = 0.0;
    for (const auto& particles : bodies) speed = std::max(speed, max_motion(grid, particles));
    return speed;
}

}  // namespace

template <int D, class Real>
void sort_if_needed(const Interval& interval, const Parameters<D>& parameters, double node_speed,
                    Grid<D, Real>& grid, std::vector<Particles<D, Real>>& bodies,
                    std::vector<std::uint8_t>& unknown_fill, double& drift, Skimming& skimming,
                    Outflow<D>& outflow) {
    const double speed = max_particle_speed(grid, bodies, node_speed, interval.dt);
    const double cells = speed * interval.dt / grid.layout.cell_size;
    if (cells > sorting_margin) {
        throw NumericsError(where(interval, "sort") + "something moves by " + std::to_string(cells) +
                            " cells in one step, at " + std::to_string(speed) +
                            " m/s; use a smaller simulate.cfl");
    }
    if (drift + cells > sorting_margin) {
        if (!interval.settling) {
            drain(parameters, grid, bodies, outflow);
            skim(parameters, interval.begin, grid, bodies, skimming, outflow);
        }
        sort_into_blocks<D, Real>(grid, bodies);
        unknown_fill = find_unknown_fill(parameters, interval.begin, grid, bodies);
        drift = 0.0;
    }
    drift += cells;
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                  \
    template void sort_if_needed(const Interval&, const Parameters<D>&, double, Grid<D, Real>&,         \
                                 std::vector<Particles<D, Real>>&, std::vector<std::uint8_t>&, double&, \
                                 Skimming&, Outflow<D>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
