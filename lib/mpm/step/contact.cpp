#include "mpm/step/contact.h"

#include <algorithm>
#include <cmath>

#include "mpm/base/instantiate.h"
#include "mpm/bodies/collide.h"
#include "mpm/bodies/lift.h"

namespace tidewater::mpm {
namespace {

constexpr int max_rounds = 12;  // of the iteration that finds which nodes press
// The mean, over places of a flat face between nodes, of the part of its area for which nodes in contact
// stand.
constexpr double mean_held_area = 1.0 - min_share;
constexpr double min_slope = 0.02;  // |∇s| Δx below which a node sticks

struct NodeContact {
    int node = 0;              // in its block
    double mass = 0.0;         // kg
    Eigen::Vector3d arm;       // m, from the body's centre
    Eigen::Vector3d velocity;  // m/s, before the contact
    Eigen::Vector3d normal;    // outward; zero where the node sticks
    double area = 0.0;         // m², of the face
    bool sticks = false, presses = true;
};

// The nodes of one block that are in contact with one body.
struct BlockContacts {
    std::size_t slot = 0;  // in grid.node_blocks
    std::vector<NodeContact> nodes;
};

// The node blocks within a range of nodes, by ascending index along x, then y, then z.
template <int D, class Real>
std::vector<BlockContacts> blocks_near(const Grid<D, Real>& grid, const NodeRange<D>& range) {
    Index<D> first, last;
    const auto block_of = [](int node) {
        const int width = Block<D>::width;
        return (node >= 0 ? node / width : -((width - 1 - node) / width)) + 2;
    };
    for (std::size_t axis = 0; axis < D; ++axis) {
        first[axis] = std::max(block_of(range.first[axis]), 0);
        last[axis] = block_of(range.last[axis]);
        if (last[axis] < first[axis]) return {};
    }
    std::vector<BlockContacts> near;
    for (Index<D> block = first;;) {
        const BlockKey key = block_key<D>(block);
        const auto found = std::lower_bound(grid.node_blocks.begin(), grid.node_blocks.end(), key);
        if (found != grid.node_blocks.end() && *found == key) {
            near.push_back({static_cast<std::size_t>(found - grid.node_blocks.begin()), {}});
        }
        std::size_t axis = D;
        while (axis-- > 0) {
            if (++block[axis] <= last[axis]) break;
            block[axis] = first[axis];
        }
        if (axis >= D) return near;
    }
}

template <int D>
bool within(const NodeRange<D>& range, const Index<D>& node) {
    for (std::size_t axis = 0; axis < D; ++axis) {
        if (node[axis] < range.first[axis] || node[axis] > range.last[axis]) return false;
    }
    return true;
}

// Whether another body has a larger share of the node; of equal shares the first body's counts.
template <int D>
bool taken(const Layout<D>& layout, const std::vector<RigidBody>& bodies,
           const std::vector<NodeRange<D>>& ranges, std::size_t self, const Index<D>& node, double share) {
    for (std::size_t other = 0; other < bodies.size(); ++other) {
        if (other == self || !within<D>(ranges[other], node)) continue;
        const double theirs = share_of_node<D>(layout, bodies[other], node).value;
        if (theirs > share || (theirs == share && other < self)) return true;
    }
    return false;
}

// What the search for contacts reads.
template <int D, class Real>
struct ContactScene {
    const Grid<D, Real>& grid;
    const std::vector<RigidBody>& bodies;
    std::vector<NodeRange<D>> ranges;  // [body] the nodes of which it may have a share
    bool held;                         // the scene settles: water slips along all bodies, to find its balance
};

template <int D, class Real>
void find_block_contacts(const ContactScene<D, Real>& scene, std::size_t self, BlockContacts& contacts) {
    const Layout<D>& layout = scene.grid.layout;
    const RigidBody& body = scene.bodies[self];
    const Index<D> block = block_at<D>(scene.grid.node_blocks[contacts.slot]), anchor = anchor_of<D>(body);
    const Node<Real>* nodes = scene.grid.block_nodes(contacts.slot);
    for (int n = 0; n < Block<D>::nodes; ++n) {
        if (!(nodes[n][mass_lane] > Real(0))) continue;
        const Index<D> place = node_at(layout, block, n);
        if (!within<D>(scene.ranges[self], place)) continue;
        const NodeShare share = share_of_node<D>(layout, body, place);
        if (share.value <= min_share) continue;
        if (taken<D>(layout, scene.bodies, scene.ranges, self, place, share.value)) continue;
        NodeContact contact;
        contact.node = n;
        contact.mass = static_cast<double>(nodes[n][mass_lane]);
        Vector<D, double> from_anchor;
        for (std::size_t axis = 0; axis < D; ++axis) {
            from_anchor[static_cast<int>(axis)] = layout.cell_size * (place[axis] - anchor[axis]);
        }
        contact.arm = lift<D>(from_anchor) - body.center;
        contact.velocity = lift<D>(nodes[n].template head<D>().template cast<double>().matrix().eval());
        const double slope = share.slope.norm();
        const bool stick = body.contact == BodyContact::stick && !scene.held;
        contact.sticks = stick || slope * layout.cell_size < min_slope;
        contact.normal = contact.sticks ? Eigen::Vector3d::Zero().eval() : (-share.slope / slope).eval();
        contact.area = contact.sticks ? 0.0 : slope * std::pow(layout.cell_size, D) / mean_held_area;
        contacts.nodes.push_back(contact);
    }
}

// A body's equation A u = b.
struct System {
    Matrix6 a = Matrix6::Zero();
    Vector6 b = Vector6::Zero();

    // Adds a node of this mass and velocity v that takes the body's velocity along n.
    void add(double mass, const Eigen::Vector3d& arm, const Eigen::Vector3d& n, const Eigen::Vector3d& v) {
        Vector6 row;
        row << n, arm.cross(n);
        a += (mass * row) * row.transpose();
        b += (mass * n.dot(v)) * row;
    }
    void add(const System& other) {
        a += other.a;
        b += other.b;
    }
};

template <int D>
System system_of(const BlockContacts& block) {
    System sum;
    for (const NodeContact& m : block.nodes) {
        if (m.sticks) {
            for (const int axis : {0, 1, 2}) {
                if (D == 3 || axis != 1) sum.add(m.mass, m.arm, Eigen::Vector3d::Unit(axis), m.velocity);
            }
        } else if (m.presses) {
            sum.add(m.mass, m.arm, m.normal, m.velocity);
        }
    }
    return sum;
}

Eigen::Vector3d velocity_at(const Vector6& motion, const Eigen::Vector3d& arm) {
    return motion.head<3>() + motion.tail<3>().cross(arm);
}

// Updates which slipping nodes press at this motion of the body, and returns whether any changed. In late
// rounds nodes can only be released, so that the iteration ends.
bool update_presses(const Vector6& motion, bool late, BlockContacts& block) {
    bool changed = false;
    for (NodeContact& m : block.nodes) {
        if (m.sticks) continue;
        const bool presses =
            m.normal.dot(velocity_at(motion, m.arm) - m.velocity) > 0.0 && (m.presses || !late);
        changed = changed || presses != m.presses;
        m.presses = presses;
    }
    return changed;
}

// Impulses (kg m/s) and angular impulses (kg m²/s) on a body from nodes: along their normals, and by friction
// and drag along the face.
struct ContactImpulse {
    Eigen::Vector3d impulse = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero(),
                    along = Eigen::Vector3d::Zero(), along_angular = Eigen::Vector3d::Zero();
    double friction_work = 0.0, drag_work = 0.0;  // J, on water and body

    void add(const ContactImpulse& other) {
        impulse += other.impulse;
        angular += other.angular;
        along += other.along;
        along_angular += other.along_angular;
        friction_work += other.friction_work;
        drag_work += other.drag_work;
    }
};

// The changes of a node's velocity that takes part, m/s.
struct NodeChange {
    Eigen::Vector3d across = Eigen::Vector3d::Zero(), friction = Eigen::Vector3d::Zero(),
                    drag = Eigen::Vector3d::Zero();
};

// What a body's motion, friction and drag change; `relative` is its surface's velocity against the node's.
NodeChange change_of(const NodeContact& m, const Eigen::Vector3d& relative, const RigidBody& body,
                     const ContactStep& step) {
    NodeChange change;
    if (m.sticks) {
        change.across = relative;
        return change;
    }
    const double along = m.normal.dot(relative);
    change.across = along * m.normal;
    Eigen::Vector3d slipping = relative - change.across;
    if (body.friction > 0.0) {
        const double speed = slipping.norm(), max_change = body.friction * std::abs(along);
        change.friction = speed > max_change ? Eigen::Vector3d(max_change / speed * slipping) : slipping;
        slipping -= change.friction;
    }
    if (body.drag > 0.0) {
        const double share =
            step.water_density * body.drag * m.area * slipping.norm() * step.force_dt / m.mass;
        change.drag = share / (1.0 + share) * slipping;
    }
    return change;
}

// Gives the nodes of a block their velocities after the contact, and returns the impulse on the body.
template <int D, class Real>
ContactImpulse move_nodes(const Vector6& motion, const RigidBody& body, const ContactStep& step,
                          const BlockContacts& block, Node<Real>* nodes) {
    ContactImpulse received;
    for (const NodeContact& m : block.nodes) {
        if (!m.sticks && !m.presses) continue;
        const Eigen::Vector3d relative = velocity_at(motion, m.arm) - m.velocity;
        const NodeChange change = change_of(m, relative, body, step);
        const Eigen::Vector3d along = change.friction + change.drag;
        received.impulse -= m.mass * change.across;
        received.angular -= m.mass * m.arm.cross(change.across);
        received.along -= m.mass * along;
        received.along_angular -= m.mass * m.arm.cross(along);
        // Impulse times the node's speed against the body that is left (mpm/boundaries/ground.h).
        const Eigen::Vector3d left = along - (relative - change.across);
        received.friction_work += m.mass * change.friction.dot(left);
        received.drag_work += m.mass * change.drag.dot(left);
        const Vector<D, double> velocity = drop<D>(m.velocity + change.across + along);
        nodes[m.node].template head<D>() = velocity.template cast<Real>().array();
    }
    return received;
}

// One body in the search for the motions of all.
struct Partner {
    std::vector<BlockContacts> blocks;
    System alone;  // the body's equation without nodes
};

template <int D, class Real>
std::vector<Partner> find_partners(const ContactScene<D, Real>& scene, const ContactStep& step) {
    std::vector<Partner> partners(scene.bodies.size());
    for (std::size_t n = 0; n < partners.size(); ++n) {
        Partner& partner = partners[n];
        partner.blocks = blocks_near(scene.grid, scene.ranges[n]);
        parallel_for(partner.blocks.size(),
                     [&](std::size_t k) { find_block_contacts(scene, n, partner.blocks[k]); });
        const RigidBody& body = scene.bodies[n];
        Eigen::Vector3d fallen = body.velocity;
        fallen[2] -= step.force_dt * step.gravity;
        partner.alone.a.diagonal().head<3>().setConstant(body.mass);
        partner.alone.a.bottomRightCorner<3, 3>() = world_inertia(body);
        partner.alone.b << body.mass * fallen, body.angular_momentum;
    }
    return partners;
}

// The motions of all bodies if the nodes that press now keep pressing; sets the contacts' impulses too.
template <int D>
std::vector<Vector6> solve(double dt, const std::vector<Partner>& partners,
                           std::vector<ContactPoint>& contacts) {
    std::vector<Matrix6> inverse;
    std::vector<Vector6> motion;
    for (const Partner& partner : partners) {
        std::vector<System> of_block(partner.blocks.size());
        parallel_for(of_block.size(), [&](std::size_t k) { of_block[k] = system_of<D>(partner.blocks[k]); });
        System system = partner.alone;
        for (const System& part : of_block) system.add(part);
        inverse.push_back(system.a.ldlt().solve(Matrix6::Identity()));
        motion.push_back(inverse.back() * system.b);
    }
    for (ContactPoint& contact : contacts) contact.impulse = 0.0;
    solve_contacts(dt, inverse, contacts, motion);
    return motion;
}

template <int D>
std::vector<Vector6> find_motions(double dt, bool held, std::vector<Partner>& partners,
                                  std::vector<ContactPoint>& contacts) {
    std::vector<Vector6> motion(partners.size(), Vector6::Zero());
    for (int round = 0; round < max_rounds; ++round) {
        if (!held) motion = solve<D>(dt, partners, contacts);
        bool changed = false;
        for (std::size_t n = 0; n < partners.size(); ++n) {
            for (BlockContacts& block : partners[n].blocks) {
                changed = update_presses(motion[n], 2 * round > max_rounds, block) || changed;
            }
        }
        if (!changed || held) return motion;
    }
    return solve<D>(dt, partners, contacts);
}

}  // namespace

template <int D, class Real>
void resolve_contacts(const ContactStep& step, const Boundaries<D>& boundaries, Grid<D, Real>& grid,
                      std::vector<RigidBody>& bodies, Accounts<D>& accounts) {
    if (bodies.empty()) return;
    std::vector<ContactPoint> points = find_contacts(grid.layout, boundaries, step.dt, bodies);
    ContactScene<D, Real> scene{grid, bodies, {}, step.held};
    for (const RigidBody& body : bodies) scene.ranges.push_back(reach_of<D>(grid.layout, body));
    std::vector<Partner> partners = find_partners(scene, step);
    const std::vector<Vector6> motion = find_motions<D>(step.dt, step.held, partners, points);
    for (std::size_t n = 0; n < partners.size(); ++n) {
        RigidBody& body = bodies[n];
        const std::vector<BlockContacts>& blocks = partners[n].blocks;
        std::vector<ContactImpulse> of_block(blocks.size());
        parallel_for(of_block.size(), [&](std::size_t k) {
            of_block[k] =
                move_nodes<D, Real>(motion[n], body, step, blocks[k], grid.block_nodes(blocks[k].slot));
        });
        ContactImpulse received;
        for (const ContactImpulse& part : of_block) received.add(part);
        accounts.friction_work += received.friction_work;
        accounts.drag_work += received.drag_work;
        body.water_impulse += received.impulse + received.along;
        body.water_angular_impulse += received.angular + received.along_angular;
        if (step.held) {  // something outside of the scene holds the body and takes its impulse
            accounts.wall_impulse -= drop<D>(received.impulse + received.along);
            continue;
        }
        body.velocity = motion[n].head<3>() + received.along / body.mass;
        body.angular_momentum = world_inertia(body) * motion[n].tail<3>() + received.along_angular;
        body.angular_velocity = world_inertia(body).ldlt().solve(body.angular_momentum);
    }
    for (const ContactPoint& point : points) {
        const Eigen::Vector3d impulse = point.impulse * point.on_a.head<3>();
        bodies[point.a].contact_impulse += impulse;
        if (point.b)
            bodies[*point.b].contact_impulse -= impulse;
        else
            accounts.wall_impulse += drop<D>(impulse);
    }
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                       \
    template void resolve_contacts(const ContactStep&, const Boundaries<D>&, Grid<D, Real>&, \
                                   std::vector<RigidBody>&, Accounts<D>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
