// What all boundaries of the engine share: the rules by which they hold nodes, and the account of what they
// did. The table of boundaries is mpm/boundaries/boundaries.h.
//
// Test: tests/unit/mpm/boundaries/boundaries_test.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "mpm/grid/grid.h"

namespace tidewater::mpm {

// How a wall holds the nodes on it.
//     slip      the velocity into or out of the wall is zero; along the wall it is free
//     stick     the velocity is zero
//     separate  as slip, but nodes that move away from the wall may do so
enum class WallRule { slip, stick, separate };

// A surface that lies anywhere between nodes holds the nodes behind it and those up to this many cells in
// front of it. A free node nearer to it would find too little water behind it and sink
// (mpm/boundaries/bed.h).
inline constexpr double wall_reach = 0.75;

// What a boundary needs to know of a step.
struct BoundaryStep {
    std::optional<double> time;       // s; empty while the scene settles, before any boundary moves
    double dt = 0.0;                  // s, over which a sponge damps, and pressure and sliding laws act
    bool left_wall_moves = false;     // a push or a piston replaces the left wall
    std::span<const double> slowing;  // m/s, by drag (mpm/boundaries/drag.h); empty without drag
};

// What boundaries did to the nodes of one block.
template <int D>
struct WallAction {
    Vector<D, double> impulse = Vector<D, double>::Zero();  // kg m/s given to the nodes
    double work = 0.0;  // J done on the nodes: impulse times speed of what moves; of a sponge ≤ 0
    double friction_work = 0.0, drag_work = 0.0;  // J done on the nodes by the ground

    void add(const WallAction& other) {
        impulse += other.impulse;
        work += other.work;
        friction_work += other.friction_work;
        drag_work += other.drag_work;
    }
};

// The node on which a boundary acts.
template <int D>
struct NodeAt {
    Index<D> node;
    Material matter = Material::water;  // ice or water: what most of its mass is
    // m/s that friction could still take in this step; null where a step meets its boundaries once.
    float* grip = nullptr;
};

// What the nodes of one block are made of.
template <class Real>
struct BlockMatter {
    Material all = Material::water;   // of every node, unless they differ:
    const Node<Real>* ice = nullptr;  // [node] the mass of ice in mass_lane
    Material of(int n, const Node<Real>& node) const {
        if (ice == nullptr) return all;
        return Real(2) * ice[n][mass_lane] > node[mass_lane] ? Material::ice : Material::water;
    }
};

// Applies the rule of a wall to the velocity of a node on it or beyond it.
//     axis     normal to the wall
//     outward  −1 at the origin's wall, +1 at the far one
template <int D, class Real>
void apply_rule(WallRule rule, int axis, int outward, Node<Real>& velocity) {
    switch (rule) {
        case WallRule::stick:
            velocity.template head<D>().setZero();
            break;
        case WallRule::slip:
            velocity[axis] = Real(0);
            break;
        case WallRule::separate:
            velocity[axis] =
                outward < 0 ? std::max(velocity[axis], Real(0)) : std::min(velocity[axis], Real(0));
            break;
    }
}

// Calls change(n, node) for each node n of a block that lies in the box and has mass. Returns the impulse
// that the changes of velocity gave to the nodes, kg m/s.
template <int D, class Real, class Change>
Vector<D, double> change_nodes(const NodeBox<D>& box, Node<Real>* nodes, const Change& change) {
    Vector<D, double> impulse = Vector<D, double>::Zero();
    const auto change_one = [&](int n) {
        Node<Real>& node = nodes[n];
        if (!(node[mass_lane] > Real(0))) return;
        const Node<Real> before = node;
        change(n, node);
        if ((node == before).all()) return;  // most nodes of a block that a wall meets
        const auto velocity = [](const Node<Real>& of) {
            return of.template head<D>().template cast<double>().matrix();
        };
        impulse += static_cast<double>(node[mass_lane]) * (velocity(node) - velocity(before));
    };
    box.for_each_run([&](int first, int count) {
        for (int n = first; n < first + count; ++n) change_one(n);
    });
    return impulse;
}

// ½ m v², J.
template <int D, class Real>
double kinetic_energy_of(const Node<Real>& node) {
    return 0.5 * static_cast<double>(node[mass_lane]) *
           node.template head<D>().template cast<double>().matrix().squaredNorm();
}

// Whether a node lies behind x (m) along an axis, or at most `reach` cells beyond it.
inline bool behind(int node, double x, double reach, double cell_size) {
    return node <= x / cell_size + reach;
}

// The last node along an axis at or before x (m), with a margin for rounding.
inline int node_at_or_before(double x, double cell_size) {
    return static_cast<int>(std::floor(x / cell_size + 1e-6));
}

}  // namespace tidewater::mpm
