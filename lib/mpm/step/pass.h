// The particles' part of a step, block by block: grid → particle, material, motion, particle → grid.
//
// The kernels are separate functions over a batch of particles (mpm/particles/transfer_batch.h and the table
// of mpm/materials/materials.h). This is the loop that calls them while the batch is in the first-level
// cache. There is one instance of the loop per material, chosen per block, so that there is no branch on the
// material inside.
//
// Tests: tests/unit/mpm/twin_test.cpp, tests/unit/mpm/step/blocks_test.cpp.
#pragma once

#include "mpm/materials/materials.h"
#include "mpm/state/simulation.h"
#include "mpm/step/blocks.h"

namespace tidewater::mpm {

// The numbers of a pass that are the same for all blocks.
template <int D, class Real>
struct PassContext {
    Real cells_per_speed;  // Δt/Δx
    Real shift;            // shift of the rounding of positions (mpm/particles/position.h)
    MaterialSteps<D, Real> materials;
    const Parameters<D>& parameters;

    PassContext(const Interval& interval, const Parameters<D>& of_run, double cell_size);
};

// What a pass over one block found.
template <int D>
struct PassResult {
    Findings findings;
    Vector<D, double> impulse = Vector<D, double>::Zero();  // kg m/s, from walls that mirror
    double motion = 0.0;                                    // m/s, max. |v| along an axis
    Signal signal;                                          // c of its fastest material; no motion yet
};

// What a pass found in all blocks.
struct PassFindings {
    Findings all;
    std::vector<Signal> of_block;  // [particle block] c of its fastest material; no motion yet
};

// Advances the particles of block `slot` with the velocities in `from`, and writes their mass and momentum,
// with the forces of the next step, to the block's tile of the grid, folded at walls that mirror. Blocks may
// run in parallel.
//     from    Block<D>::tile_size nodes: velocities and, for water of the scheme `density`, the crowding
//     grid    writes the tile of the block only
//     bodies  position and strain of the block's particles advance; before and after, positions must
//             lie within ½ cell of the block, for which the caller sorts in time
template <int D, class Real>
PassResult<D> pass_over_block(const PassContext<D, Real>& context, std::size_t slot, const Node<Real>* from,
                              Grid<D, Real>& grid, std::vector<Particles<D, Real>>& bodies);

// Passes over the particle blocks in `slots`: loads the velocities and the crowding around each block from
// the grid's nodes, and advances its particles. Throws a NumericsError that names a particle whose state
// cannot be used.
//     rigid, unknown_fill  as in Simulation; read for the crowding of water
//     grid                 reads the nodes, writes the tiles of the slots
//     bodies               position and strain of the slots' particles advance
//     drift                [particle block] adds the longest way of a particle along an axis, cells
//     wall_impulse         adds what walls that mirror gave, kg m/s, in the order of the slots
template <int D, class Real>
PassFindings pass_over_blocks(const Interval& interval, const Parameters<D>& parameters, const Slots& slots,
                              const std::vector<RigidBody>& rigid,
                              const std::vector<std::uint8_t>& unknown_fill, Grid<D, Real>& grid,
                              std::vector<Particles<D, Real>>& bodies, std::vector<double>& drift,
                              Vector<D, double>& wall_impulse);

}  // namespace tidewater::mpm
