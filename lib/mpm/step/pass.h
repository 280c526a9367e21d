// The particles' part of a step, block by block: grid → particle, material, motion, particle → grid.
//
// The kernels are separate functions over a batch of particles (mpm/particles/transfer_batch.h and the table
// of mpm/materials/materials.h); this is the loop that calls them while the batch is in the first-level
// cache. One instance per material, chosen per block: no branch on the material inside.
#pragma once

#include "mpm/materials/materials.h"
#include "mpm/state/simulation.h"
#include "mpm/step/blocks.h"

namespace tidewater::mpm {

// What the blocks of one pass share.
template <int D, class Real>
struct PassContext {
    Real cells_per_speed;  // Δt/Δx
    Real shift;            // of the rounding of positions (mpm/particles/position.h)
    MaterialSteps<D, Real> materials;

    PassContext(const Interval& interval, const Parameters<D>& parameters, double cell_size);
};

// What a pass over one block gave.
template <int D>
struct PassResult {
    Findings findings;
    Vector<D, double> impulse = Vector<D, double>::Zero();  // kg m/s, of walls that mirror
};

// Reads velocities from `from` (a tile of Block<D>::tile_size nodes), advances the particles of block `slot`
// and adds them with the forces of the next step to its tile of the grid, which is cleared first and
// afterwards folded at walls that mirror. Before and after, positions must lie within ½ cell of the block:
// the caller sorts in time. Blocks may run in parallel. Test: tests/unit/mpm/twin_test.cpp.
template <int D, class Real>
PassResult<D> pass_over_block(const PassContext<D, Real>& context, std::size_t slot, const Node<Real>* from,
                              Grid<D, Real>& grid, std::vector<Particles<D, Real>>& bodies);

// The pass over all blocks of `slots`. Adds what the walls gave to wall_impulse, kg m/s, in the slots' order.
// Throws NumericsError naming a particle whose state cannot be used.
//     rigid, unknown_fill  as in Simulation, for the crowding of water
template <int D, class Real>
Findings pass_over_blocks(const Interval& interval, const Parameters<D>& parameters, const Slots& slots,
                          const std::vector<RigidBody>& rigid, const std::vector<std::uint8_t>& unknown_fill,
                          Grid<D, Real>& grid, std::vector<Particles<D, Real>>& bodies,
                          Vector<D, double>& wall_impulse);

}  // namespace tidewater::mpm
