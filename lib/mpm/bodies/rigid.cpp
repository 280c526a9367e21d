#include "mpm/bodies/rigid.h"

#include <algorithm>
#include <cmath>

#include "core/spline.h"
#include "mpm/base/instantiate.h"
#include "mpm/bodies/lift.h"
#include "mpm/grid/mirror.h"

namespace tidewater::mpm {
namespace {

template <int D>
constexpr std::array<int, static_cast<std::size_t>(D)> own_axes() {
    if constexpr (D == 2)
        return {0, 2};
    else
        return {0, 1, 2};
}

// The corners, then a lattice on all faces; in 2D the faces are the body's outline.
template <int D>
std::vector<Eigen::Vector3d> surface_points(const Eigen::Vector3d& half, double spacing) {
    std::array<int, 3> steps{0, 0, 0};
    for (const int axis : own_axes<D>()) {
        steps[static_cast<std::size_t>(axis)] = static_cast<int>(std::ceil(2.0 * half[axis] / spacing));
    }
    std::vector<Eigen::Vector3d> corners, others;
    for (int x = 0; x <= steps[0]; ++x) {
        for (int y = 0; y <= steps[1]; ++y) {
            for (int z = 0; z <= steps[2]; ++z) {
                const std::array<int, 3> at{x, y, z};
                int ends = 0;
                Eigen::Vector3d point = Eigen::Vector3d::Zero();
                for (const int axis : own_axes<D>()) {
                    const auto a = static_cast<std::size_t>(axis);
                    ends += at[a] == 0 || at[a] == steps[a];
                    point[axis] = half[axis] * (2.0 * at[a] / steps[a] - 1.0);
                }
                if (ends == D)
                    corners.push_back(point);
                else if (ends > 0)
                    others.push_back(point);
            }
        }
    }
    corners.insert(corners.end(), others.begin(), others.end());
    return corners;
}

// A mirror near the body.
struct Pane {
    int axis = 0;
    double plane = 0.0;  // m, from the body's centre
};

struct Panes {
    std::array<Pane, 6> all;
    std::size_t count = 0;
};

template <int D>
Panes panes_near(const Layout<D>& layout, const RigidBody& body, const Index<D>& anchor) {
    const double reach = body.radius() + 3.0 * layout.cell_size;
    Panes panes;
    for_each_mirror(layout, [&](int a, std::size_t, Mirror, int node, int) {
        const int axis = a == D - 1 ? 2 : a;
        const double plane =
            layout.cell_size * (node - anchor[static_cast<std::size_t>(a)]) - body.center[axis];
        if (std::abs(plane) < reach) panes.all[panes.count++] = {axis, plane};
    });
    return panes;
}

}  // namespace

template <int D>
RigidBody make_rigid_body(const RigidStart<D>& start, double cell_size) {
    RigidBody body;
    body.half_size = 0.5 * lift<D>(start.size);
    for (int axis = 0; axis < D; ++axis) {
        const int block = static_cast<int>(std::floor(start.center[axis] / cell_size / Block<D>::width));
        body.anchor[static_cast<std::size_t>(axis == D - 1 ? 2 : axis)] = block * Block<D>::width;
    }
    body.center =
        lift<D>(start.center) - cell_size * Eigen::Vector3d(body.anchor[0], body.anchor[1], body.anchor[2]);
    // Turning from x towards z is negative about y, by the right-hand rule.
    body.rotation = Eigen::AngleAxisd(-start.angle, Eigen::Vector3d::UnitY());
    body.mass = start.density * start.size.prod();
    const Eigen::Vector3d squares = body.half_size.cwiseAbs2() * body.mass / 3.0;
    body.inertia = Eigen::Vector3d::Constant(squares.sum()) - squares;
    body.velocity = lift<D>(start.velocity);
    body.angular_velocity = {0.0, -start.spin, 0.0};
    body.angular_momentum = world_inertia(body) * body.angular_velocity;
    body.contact = start.contact;
    body.friction = start.friction;
    body.drag = start.drag;
    body.surface = surface_points<D>(body.half_size, cell_size);
    return body;
}

Eigen::Matrix3d world_inertia(const RigidBody& body) {
    const Eigen::Matrix3d r = body.rotation.toRotationMatrix();
    return r * body.inertia.asDiagonal() * r.transpose();
}

void move_rigid_body(double dt, RigidBody& body) {
    body.center += dt * body.velocity;
    const double angle = dt * body.angular_velocity.norm();
    if (angle > 0.0) {
        const Eigen::AngleAxisd turn(angle, body.angular_velocity.normalized());
        body.rotation = (Eigen::Quaterniond(turn) * body.rotation).normalized();
        body.angular_velocity = world_inertia(body).ldlt().solve(body.angular_momentum);
    }
}

double kinetic_energy(const RigidBody& body) {
    return 0.5 * body.mass * body.velocity.squaredNorm() +
           0.5 * body.angular_velocity.dot(body.angular_momentum);
}

double max_speed(const RigidBody& body) {
    double max2 = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d sign(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
        max2 =
            std::max(max2, body.velocity_at(body.rotation * sign.cwiseProduct(body.half_size)).squaredNorm());
    }
    return std::sqrt(max2);
}

template <int D>
NodeShare share_of(const RigidBody& body, double cell_size, const Eigen::Vector3d& arm) {
    const Eigen::Vector3d r = body.rotation.conjugate() * arm;
    Eigen::Vector3d share = Eigen::Vector3d::Ones(), slope = Eigen::Vector3d::Zero();
    for (const int k : own_axes<D>()) {
        const double ahead = (body.half_size[k] - r[k]) / cell_size;
        const double behind = (-body.half_size[k] - r[k]) / cell_size;
        if (ahead <= -1.5 || behind >= 1.5) return {};
        share[k] = quadratic_spline_integral(ahead) - quadratic_spline_integral(behind);
        slope[k] = (quadratic_spline(behind) - quadratic_spline(ahead)) / cell_size;
    }
    const Eigen::Vector3d others(share[1] * share[2], share[0] * share[2], share[0] * share[1]);
    return {share.prod(), body.rotation * slope.cwiseProduct(others)};
}

template <int D>
NodeShare share_of_node(const Layout<D>& layout, const RigidBody& body, const Index<D>& node) {
    const Index<D> anchor = anchor_of<D>(body);
    Vector<D, double> from_anchor;
    for (std::size_t axis = 0; axis < D; ++axis) {
        from_anchor[static_cast<int>(axis)] = layout.cell_size * (node[axis] - anchor[axis]);
    }
    const Eigen::Vector3d arm = lift<D>(from_anchor) - body.center;
    const Panes panes = panes_near(layout, body, anchor);
    NodeShare sum;
    // Sums over the node and its images in the mirrors; in a corner images have images too.
    for (unsigned through = 0; through < 1u << panes.count; ++through) {
        Eigen::Vector3d seen = arm, sign = Eigen::Vector3d::Ones();
        for (std::size_t n = 0; n < panes.count; ++n) {
            if (!(through >> n & 1u)) continue;
            const auto& [axis, plane] = panes.all[n];
            seen[axis] = 2.0 * plane - seen[axis];
            sign[axis] = -sign[axis];
        }
        const NodeShare share = share_of<D>(body, layout.cell_size, seen);
        sum.value += share.value;
        sum.slope += sign.cwiseProduct(share.slope);
    }
    return sum;
}

template <int D>
NodeRange<D> reach_of(const Layout<D>& layout, const RigidBody& body) {
    const Eigen::Vector3d spline = Eigen::Vector3d::Constant(1.5 * layout.cell_size);
    const Eigen::Vector3d reach = body.rotation.toRotationMatrix().cwiseAbs() * (body.half_size + spline);
    const Vector<D, double> low = drop<D>(body.center - reach), high = drop<D>(body.center + reach);
    const Index<D> anchor = anchor_of<D>(body);
    NodeRange<D> range;
    for (std::size_t axis = 0; axis < D; ++axis) {
        const int a = static_cast<int>(axis);
        range.first[axis] = anchor[axis] + static_cast<int>(std::ceil(low[a] / layout.cell_size));
        range.last[axis] = anchor[axis] + static_cast<int>(std::floor(high[a] / layout.cell_size));
        constexpr int images = 3;
        const auto& [near, far] = layout.mirrors[axis];
        if (near != Mirror::none && range.first[axis] <= 0)
            range.first[axis] = std::min(range.first[axis], -images);
        if (far != Mirror::none && range.last[axis] >= layout.cells[axis])
            range.last[axis] = std::max(range.last[axis], layout.cells[axis] + images);
    }
    return range;
}

template <int D>
std::vector<Vector<D, double>> points_within(const RigidBody& body, double cell_size, double spacing) {
    std::array<int, 3> count{1, 1, 1};
    for (const int axis : own_axes<D>()) {
        const double along = 2.0 * body.half_size[axis] / spacing;
        count[static_cast<std::size_t>(axis)] = std::max(1, static_cast<int>(std::lround(along)));
    }
    const Eigen::Vector3d center = body.center_in_box(cell_size);
    std::vector<Vector<D, double>> points;
    for (int x = 0; x < count[0]; ++x) {
        for (int y = 0; y < count[1]; ++y) {
            for (int z = 0; z < count[2]; ++z) {
                const Eigen::Vector3d share((2 * x + 1.0) / count[0] - 1.0, (2 * y + 1.0) / count[1] - 1.0,
                                            (2 * z + 1.0) / count[2] - 1.0);
                points.push_back(drop<D>(center + body.rotation * share.cwiseProduct(body.half_size)));
            }
        }
    }
    return points;
}

#define TIDEWATER_INSTANTIATE(D)                                                              \
    template RigidBody make_rigid_body(const RigidStart<D>&, double);                         \
    template NodeShare share_of<D>(const RigidBody&, double, const Eigen::Vector3d&);         \
    template NodeShare share_of_node<D>(const Layout<D>&, const RigidBody&, const Index<D>&); \
    template NodeRange<D> reach_of<D>(const Layout<D>&, const RigidBody&);                    \
    template std::vector<Vector<D, double>> points_within<D>(const RigidBody&, double, double);
TIDEWATER_FOR_EACH_DIMENSION(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
