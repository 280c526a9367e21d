#include "mpm/rigid_nodes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>

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

// Calls visit(node, place of the node relative to `center`) for the nodes of a block whose bit is set.
template <int D, class Visit>
void for_each_marked(std::uint64_t marks, const Layout<D>& layout, const Index<D>& block,
                     const Eigen::Vector3d& center, const Visit& visit) {
    static_assert(Block<D>::nodes == 64, "one bit per node");
    for (int n = 0; n < Block<D>::nodes; ++n) {
        if (!(marks >> n & 1u)) continue;
        Vector<D, double> point;
        for (int axis = D - 1, rest = n; axis >= 0; --axis, rest /= Block<D>::width) {
            const int first = layout.first_node(block[static_cast<std::size_t>(axis)]);
            point[axis] = layout.cell_size * (first + rest % Block<D>::width);
        }
        visit(n, lift<D>(point) - center);
    }
}

// Which nodes of each node block belong to the body, one bit per node.
template <int D, class Real>
std::vector<std::uint64_t> touched_nodes(const Particles<D, Real>& particles, Grid<D, Real>& grid) {
    const auto holds_particles = [&](int tile) {
        const auto slot = static_cast<std::size_t>(tile);
        return tile >= 0 && particles.begin[slot] < particles.begin[slot + 1];
    };
    parallel_for(grid.particle_blocks.size(), [&](std::size_t slot) {
        Node<Real>* tile = grid.tile(slot);
        std::fill_n(tile, Block<D>::tile_nodes, Node<Real>::Zero());
        for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
            scatter<D, Real>(particles.position[p], Real(1), Vector<D, Real>::Zero(), Matrix<D, Real>::Zero(),
                             tile);
        }
    });
    const double full =
        std::pow(grid.layout.cell_size, D) / particles.volume;  // particles' weight deep inside
    const auto threshold = static_cast<Real>(least_share * full);
    std::vector<std::uint64_t> marks(grid.node_blocks.size(), 0);
    parallel_for(marks.size(), [&](std::size_t slot) {
        const auto& tiles = grid.tiles_of_node[slot];
        if (std::none_of(tiles.begin(), tiles.end(), holds_particles)) return;
        std::array<Node<Real>, static_cast<std::size_t>(Block<D>::nodes)> touch;
        sum_tiles(grid, slot, touch.data());
        for (std::size_t n = 0; n < touch.size(); ++n) {
            if (touch[n][mass_lane] > threshold) marks[slot] |= std::uint64_t{1} << n;
        }
    });
    return marks;
}

}  // namespace

template <int D, class Real>
void move_nodes_as_one(const Particles<D, Real>& particles, const Eigen::Vector3d& center,
                       Grid<D, Real>& grid) {
    const std::vector<std::uint64_t> marks = touched_nodes(particles, grid);
    std::vector<NodeMoments> of_block(marks.size());
    parallel_for(marks.size(), [&](std::size_t slot) {
        const Node<Real>* nodes = grid.block_nodes(slot);
        const Index<D> block = grid.layout.block_at(grid.node_blocks[slot]);
        for_each_marked<D>(marks[slot], grid.layout, block, center, [&](int n, const Eigen::Vector3d& r) {
            const Vector<D, double> velocity = nodes[n].template head<D>().template cast<double>().matrix();
            of_block[slot].add(static_cast<double>(nodes[n][mass_lane]), r, lift<D>(velocity));
        });
    });
    NodeMoments total;
    for (const NodeMoments& moments : of_block) total.add(moments);
    if (total.mass == 0.0) return;
    const Motion motion = rigid_motion(total);
    parallel_for(marks.size(), [&](std::size_t slot) {
        Node<Real>* nodes = grid.block_nodes(slot);
        const Index<D> block = grid.layout.block_at(grid.node_blocks[slot]);
        for_each_marked<D>(marks[slot], grid.layout, block, center, [&](int n, const Eigen::Vector3d& r) {
            const Vector<D, double> velocity =
                drop<D>(motion.velocity + motion.turning.cross(r - motion.center));
            nodes[n].template head<D>() = velocity.template cast<Real>().array();
        });
    });
}

#define TIDEWATER_INSTANTIATE(D, Real) \
    template void move_nodes_as_one(const Particles<D, Real>&, const Eigen::Vector3d&, Grid<D, Real>&);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
