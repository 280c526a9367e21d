// What the nodes are made of: ice or water, whichever most of a node's mass is.
//
// Ice and water share one velocity per node, but the ground acts on each by its own rule
// (mpm/boundaries/ground.h). The mass of ice is summed only in blocks of nodes in which both may be and where
// a boundary tells them apart; elsewhere the particle blocks around tell all nodes' matter at no cost.
//
// Test: tests/unit/mpm/step/matter_test.cpp.
#pragma once

#include <vector>

#include "mpm/boundaries/boundaries.h"
#include "mpm/particles/particles.h"
#include "mpm/step/blocks.h"

namespace tidewater::mpm {

template <class Real>
struct NodeMatter {
    Material everywhere = Material::water;  // unless the lists below are filled
    std::vector<Material> of_block;         // [node block]
    std::vector<int> mixed;       // [node block] its place in `ice`, or −1 if it is all of one kind
    std::vector<Node<Real>> ice;  // [mixed block][node] the mass of ice in mass_lane
    int nodes_per_block = 0;

    BlockMatter<Real> of(std::size_t slot) const {
        if (of_block.empty()) return {everywhere};
        if (mixed[slot] < 0) return {of_block[slot]};
        return {of_block[slot], ice.data() + static_cast<std::ptrdiff_t>(mixed[slot]) * nodes_per_block};
    }
};

// The matter of the nodes in `slots`, from the particles where they are now. What it says of nodes for which
// no boundary tells ice and water apart is not to be used.
template <int D, class Real>
NodeMatter<Real> find_matter(const Boundaries<D>& boundaries, const BoundaryStep& step, const Slots& slots,
                             const std::vector<Particles<D, Real>>& bodies, const Grid<D, Real>& grid);

}  // namespace tidewater::mpm
