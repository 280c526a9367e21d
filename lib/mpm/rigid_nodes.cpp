#include "mpm/rigid_nodes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bitset>
#include <cmath>

#include "mpm/lift.h"
#include "mpm/transfer.h"

namespace tidewater::mpm {
namespace {

// Mass moments of nodes about a point, and the rigid motion that has their momenta.
struct NodeMoments {
    double mass = 0.0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();    // Σ m r
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();   // Σ m r rᵀ
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();   // Σ m v
    Eigen::Vector3d angular = Eigen::Vector3d::Zero();  // Σ m r × v

    void add(double m, const Eigen::Vector3d& r, const Eigen::Vector3d& v) {
        mass += m;
        first += m * r;
        second += m * r * r.transpose();
        linear += m * v;
        angular += m * r.cross(v);
    }
    void add(const NodeMoments& other) {
        mass += other.mass;
        first += other.first;
        second += other.second;
        linear += other.linear;
        angular += other.angular;
    }
};

struct Motion {
    Eigen::Vector3d center, velocity, turning;  // r of the centre of mass, its velocity, ω
};

Motion rigid_motion(const NodeMoments& m) {
    const Eigen::Vector3d center = m.first / m.mass;
    const Eigen::Matrix3d about_center = m.second - m.mass * center * center.transpose();
    const Eigen::Matrix3d inertia = about_center.trace() * Eigen::Matrix3d::Identity() - about_center;
    const Eigen::Vector3d angular = m.angular - center.cross(m.linear);
    return {center, m.linear / m.mass, inertia.ldlt().solve(angular)};
}

template <int D>
using Marks = std::bitset<static_cast<std::size_t>(Block<D>::nodes)>;

// Calls visit(node, its place relative to the body's centre, m) for the marked nodes of a block.
template <int D, class Visit>
void for_each_marked(const Marks<D>& marks, const Layout<D>& layout, const Index<D>& block,
                     const RigidBody& body, const Visit& visit) {
    if (marks.none()) return;
    const Index<D> anchor = anchor_of<D>(body);
    for (int n = 0; n < Block<D>::nodes; ++n) {
        if (!marks[static_cast<std::size_t>(n)]) continue;
        Vector<D, double> point;
        for (int axis = D - 1, rest = n; axis >= 0; --axis, rest /= Block<D>::width) {
            const auto a = static_cast<std::size_t>(axis);
            point[axis] =
                layout.cell_size * (layout.first_node(block[a]) - anchor[a] + rest % Block<D>::width);
        }
        visit(static_cast<std::size_t>(n), lift<D>(point) - body.center);
    }
}

// Which nodes of each node block belong to the body.
template <int D, class Real>
std::vector<Marks<D>> nodes_of_body(const Particles<D, Real>& particles, const Grid<D, Real>& grid) {
    std::vector<int> own_tile(grid.particle_blocks.size(), -1);
    int count = 0;
    for (std::size_t slot = 0; slot < own_tile.size(); ++slot) {
        if (particles.begin[slot] < particles.begin[slot + 1]) own_tile[slot] = count++;
    }
    std::vector<Node<Real>> tiles(static_cast<std::size_t>(count) * Block<D>::tile_size, Node<Real>::Zero());
    parallel_for(own_tile.size(), [&](std::size_t slot) {
        if (own_tile[slot] < 0) return;
        Node<Real>* tile = tiles.data() + static_cast<std::size_t>(own_tile[slot]) * Block<D>::tile_size;
        for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
            scatter<D, Real>(local_position(particles, p), Real(1), Vector<D, Real>::Zero(),
                             Matrix<D, Real>::Zero(), tile);
        }
    });
    // The particles' weight on a node deep inside is the number of particles in a cell.
    const double full = std::pow(grid.layout.cell_size, D) / particles.volume;
    const auto threshold = static_cast<Real>(least_share * full);
    std::vector<Marks<D>> marks(grid.node_blocks.size());
    parallel_for(marks.size(), [&](std::size_t slot) {
        typename Grid<D, Real>::Neighbours near;
        bool any = false;
        for (std::size_t k = 0; k < near.size(); ++k) {
            const int tile = grid.tiles_of_node[slot][k];
            near[k] = tile < 0 ? -1 : own_tile[static_cast<std::size_t>(tile)];
            any = any || near[k] >= 0;
        }
        if (!any) return;
        std::array<Node<Real>, static_cast<std::size_t>(Block<D>::nodes)> weight;
        sum_tiles<D, Real>(near, tiles.data(), weight.data());
        for (std::size_t n = 0; n < weight.size(); ++n) marks[slot][n] = weight[n][mass_lane] > threshold;
    });
    return marks;
}

}  // namespace

template <int D, class Real>
void move_nodes_as_one(const Particles<D, Real>& particles, const RigidBody& body, Grid<D, Real>& grid) {
    const std::vector<Marks<D>> marks = nodes_of_body(particles, grid);
    std::vector<NodeMoments> of_block(marks.size());
    parallel_for(marks.size(), [&](std::size_t slot) {
        const Node<Real>* nodes = grid.block_nodes(slot);
        const Index<D> block = block_at<D>(grid.node_blocks[slot]);
        for_each_marked<D>(
            marks[slot], grid.layout, block, body, [&](std::size_t n, const Eigen::Vector3d& r) {
                const Vector<D, double> velocity =
                    nodes[n].template head<D>().template cast<double>().matrix();
                of_block[slot].add(static_cast<double>(nodes[n][mass_lane]), r, lift<D>(velocity));
            });
    });
    // In the order of places, which stays when the scene is moved.
    std::vector<std::size_t> own;
    for (std::size_t slot = 0; slot < marks.size(); ++slot) {
        if (marks[slot].any()) own.push_back(slot);
    }
    std::sort(own.begin(), own.end(), [&](std::size_t a, std::size_t b) {
        return block_at<D>(grid.node_blocks[a]) < block_at<D>(grid.node_blocks[b]);
    });
    NodeMoments total;
    for (const std::size_t slot : own) total.add(of_block[slot]);
    if (total.mass == 0.0) return;
    const Motion motion = rigid_motion(total);
    parallel_for(marks.size(), [&](std::size_t slot) {
        Node<Real>* nodes = grid.block_nodes(slot);
        const Index<D> block = block_at<D>(grid.node_blocks[slot]);
        for_each_marked<D>(marks[slot], grid.layout, block, body,
                           [&](std::size_t n, const Eigen::Vector3d& r) {
                               const Vector<D, double> velocity =
                                   drop<D>(motion.velocity + motion.turning.cross(r - motion.center));
                               nodes[n].template head<D>() = velocity.template cast<Real>().array();
                           });
    });
}

#define TIDEWATER_INSTANTIATE(D, Real) \
    template void move_nodes_as_one(const Particles<D, Real>&, const RigidBody&, Grid<D, Real>&);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
