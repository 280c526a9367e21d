// What every boundary of the engine has in common: what it lets happen, and what it did.
#pragma once

#include "mpm/grid/grid.h"

namespace tidewater::mpm {

//     slip      the velocity into or out of the wall is zero, along it free
//     stick     the velocity is zero
//     separate  as slip, but what moves away from the wall may leave it
enum class WallRule { slip, stick, separate };

// Nodes up to this many cells before a surface that lies anywhere between nodes are held with those behind
// it. A free node nearer to it finds too little water behind it and sinks (mpm/boundaries/bed.h).
inline constexpr double wall_reach = 0.75;

// What boundaries did to the nodes of one block.
template <int D>
struct WallAction {
    Vector<D, double> impulse = Vector<D, double>::Zero();  // kg m/s given to the nodes
    double work = 0.0;  // J, of what moves: its impulse times its speed; of a sponge: less than zero

    void add(const WallAction& other) {
        impulse += other.impulse;
        work += other.work;
    }
};

// Calls change(node's place, node) for each node with mass of one block; `block` as block_at gives it.
// Returns what the changes of velocity gave in momentum, kg m/s.
template <int D, class Real, class Change>
Vector<D, double> change_nodes(const Layout<D>& layout, const Index<D>& block, Node<Real>* nodes,
                               const Change& change) {
    Vector<D, double> impulse = Vector<D, double>::Zero();
    for (int n = 0; n < Block<D>::nodes; ++n) {
        Node<Real>& node = nodes[n];
        if (!(node[mass_lane] > Real(0))) continue;
        const Vector<D, double> before = node.template head<D>().template cast<double>().matrix();
        change(node_at(layout, block, n), node);
        const Vector<D, double> after = node.template head<D>().template cast<double>().matrix();
        impulse += static_cast<double>(node[mass_lane]) * (after - before);
    }
    return impulse;
}

}  // namespace tidewater::mpm
