// The particles' part of a step, block by block: grid → particle, material, motion, particle → grid.
//
// The three kernels are separate functions over a batch of particles (mpm/particles/transfer_batch.h, mpm/materials/water.h,
// mpm/materials/ice.h); this is the loop that calls them while the batch is in the first-level cache. One instance per
// material, chosen per block: no branch on the material inside.
#pragma once

#include "mpm/materials/ice_yield.h"
#include "mpm/state/simulation.h"

namespace tidewater::mpm {

// What the time step, the ledger and the checks need to know of the particles of a block.
template <int D>
struct PassResult {
    double least_j = 0.0;                                   // of its water, at most 0
    bool unusable = false;                                  // some ice has a strain that cannot be used
    Vector<D, double> impulse = Vector<D, double>::Zero();  // kg m/s, of walls that mirror
};

// What the blocks of one pass share.
template <int D, class Real>
struct PassContext {
    Real cells_per_speed;  // Δt/Δx with Δt = s.dt
    Real shift;            // of the rounding of positions (mpm/particles/position.h)
    Real least_growth;     // of J in a step, and
    Real greatest_j;       // J − 1 at most, mpm/step/crowding.h
    Real crowding_rate;    // mpm/step/crowding.h
    double impulse;        // 4 Δt'/Δx with Δt' = next_dt, s/m: gradient of momentum per stress and volume
    IceConstants<D, Real> ice;
    bool fracture;  // ice may fail
    Real time;      // at the end of the step, s

    PassContext(const Simulation<D, Real>& s, double next_dt);
};

// Reads velocities from `from` (a tile of Block<D>::tile_size nodes), advances the particles of block `slot`
// by s.dt and adds them with the forces of next_dt to its tile of the grid, which is cleared first and
// afterwards folded at walls that mirror. Before and after, positions must lie within ½ cell of the block:
// the caller sorts in time. Blocks may run in parallel. Test: tests/unit/mpm/twin_test.cpp.
template <int D, class Real>
PassResult<D> pass_over_block(const PassContext<D, Real>& context, std::size_t slot, const Node<Real>* from,
                              Simulation<D, Real>& s);

}  // namespace tidewater::mpm
