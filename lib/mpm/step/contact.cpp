#include "mpm/step/contact.h"

#include <algorithm>
#include <cmath>

#include "mpm/bodies/collide.h"
#include "mpm/bodies/lift.h"

namespace tidewater::mpm {
namespace {

constexpr int greatest_turns = 12;    // to find which nodes press
constexpr double least_slope = 0.02;  // |∇s| Δx below which a node sticks

struct Meeting {
    int node = 0;  // of its block
    double mass = 0.0;
    Eigen::Vector3d arm, velocity, normal;  // of the node before; from the body's centre; outward
    bool sticks = false, presses = true;
};

// The nodes of one block that meet one body.
struct Encounter {
    std::size_t slot = 0;  // of the node block
    std::vector<Meeting> meetings;
};

// The node blocks in a body's reach, in the order of their places.
template <int D, class Real>
std::vector<Encounter> blocks_near(const Grid<D, Real>& grid, const NodeRange<D>& range) {
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
    std::vector<Encounter> near;
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

// Whether another body has a larger share of the node; of equal ones the first body counts.
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

template <int D, class Real>
void meet_block(const Simulation<D, Real>& s, const std::vector<NodeRange<D>>& ranges, std::size_t self,
                Encounter& encounter) {
    const Layout<D>& layout = s.grid.layout;
    const RigidBody& body = s.rigid[self];
    const Index<D> block = block_at<D>(s.grid.node_blocks[encounter.slot]), anchor = anchor_of<D>(body);
    const Node<Real>* nodes = s.grid.block_nodes(encounter.slot);
    for (int n = 0; n < Block<D>::nodes; ++n) {
        if (!(nodes[n][mass_lane] > Real(0))) continue;
        const Index<D> place = node_at(layout, block, n);
        if (!within<D>(ranges[self], place)) continue;
        const NodeShare share = share_of_node<D>(layout, body, place);
        if (share.value <= least_share || taken<D>(layout, s.rigid, ranges, self, place, share.value))
            continue;
        Meeting meeting;
        meeting.node = n;
        meeting.mass = static_cast<double>(nodes[n][mass_lane]);
        Vector<D, double> from_anchor;
        for (std::size_t axis = 0; axis < D; ++axis) {
            from_anchor[static_cast<int>(axis)] = layout.cell_size * (place[axis] - anchor[axis]);
        }
        meeting.arm = lift<D>(from_anchor) - body.center;
        meeting.velocity = lift<D>(nodes[n].template head<D>().template cast<double>().matrix().eval());
        const double slope = share.slope.norm();
        const bool stick = body.contact == BodyContact::stick && s.settling.going == 0;
        meeting.sticks = stick || slope * layout.cell_size < least_slope;
        meeting.normal = meeting.sticks ? Eigen::Vector3d::Zero().eval() : (-share.slope / slope).eval();
        encounter.meetings.push_back(meeting);
    }
}

// A body's equation A u = b.
struct System {
    Matrix6 a = Matrix6::Zero();
    Vector6 b = Vector6::Zero();

    // A node of this mass and velocity v whose motion along n is the body's.
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
System system_of(const Encounter& encounter) {
    System sum;
    for (const Meeting& m : encounter.meetings) {
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

// Which slipping nodes press at this motion of the body. Returns whether that changed. In later turns nodes
// only stop to press, so that it comes to an end.
bool update_presses(const Vector6& motion, bool late, Encounter& encounter) {
    bool changed = false;
    for (Meeting& m : encounter.meetings) {
        if (m.sticks) continue;
        const bool presses =
            m.normal.dot(velocity_at(motion, m.arm) - m.velocity) > 0.0 && (m.presses || !late);
        changed = changed || presses != m.presses;
        m.presses = presses;
    }
    return changed;
}

struct Given {
    Eigen::Vector3d impulse = Eigen::Vector3d::Zero(), turn = Eigen::Vector3d::Zero(),
                    friction = Eigen::Vector3d::Zero(), friction_turn = Eigen::Vector3d::Zero();
};

// Gives the nodes of a block their velocities; returns what the body got.
template <int D, class Real>
Given move_nodes(const Vector6& motion, double friction, const Encounter& encounter, Node<Real>* nodes) {
    Given given;
    for (const Meeting& m : encounter.meetings) {
        const Eigen::Vector3d relative = velocity_at(motion, m.arm) - m.velocity;
        Eigen::Vector3d change = Eigen::Vector3d::Zero(), rubbing = Eigen::Vector3d::Zero();
        if (m.sticks) {
            change = relative;
        } else if (m.presses) {
            const double along = m.normal.dot(relative);
            change = along * m.normal;
            const Eigen::Vector3d slipping = relative - change;
            const double speed = slipping.norm(), most = friction * std::abs(along);
            rubbing = speed > most ? Eigen::Vector3d(most / speed * slipping) : slipping;
            if (friction == 0.0) rubbing.setZero();
        } else {
            continue;
        }
        given.impulse -= m.mass * change;
        given.turn -= m.mass * m.arm.cross(change);
        given.friction -= m.mass * rubbing;
        given.friction_turn -= m.mass * m.arm.cross(rubbing);
        const Vector<D, double> velocity = drop<D>(m.velocity + change + rubbing);
        nodes[m.node].template head<D>() = velocity.template cast<Real>().array();
    }
    return given;
}

// Where one body is in the search for all motions.
struct Partner {
    std::vector<Encounter> encounters;
    System alone;  // without nodes
};

template <int D, class Real>
std::vector<Partner> find_partners(double falling, const Simulation<D, Real>& s) {
    std::vector<NodeRange<D>> ranges;
    for (const RigidBody& body : s.rigid) ranges.push_back(reach_of<D>(s.grid.layout, body));
    std::vector<Partner> partners(s.rigid.size());
    for (std::size_t n = 0; n < partners.size(); ++n) {
        Partner& partner = partners[n];
        partner.encounters = blocks_near(s.grid, ranges[n]);
        parallel_for(partner.encounters.size(),
                     [&](std::size_t k) { meet_block(s, ranges, n, partner.encounters[k]); });
        const RigidBody& body = s.rigid[n];
        Eigen::Vector3d fallen = body.velocity;
        fallen[2] -= falling * s.parameters.gravity;
        partner.alone.a.diagonal().head<3>().setConstant(body.mass);
        partner.alone.a.bottomRightCorner<3, 3>() = turned_inertia(body);
        partner.alone.b << body.mass * fallen, body.angular_momentum;
    }
    return partners;
}

// The motions of all bodies for the nodes that press now, and the touches' impulses with them.
template <int D>
std::vector<Vector6> solve(double dt, const std::vector<Partner>& partners, std::vector<Touch>& touches) {
    std::vector<Matrix6> inverse;
    std::vector<Vector6> motion;
    for (const Partner& partner : partners) {
        std::vector<System> of_block(partner.encounters.size());
        parallel_for(of_block.size(),
                     [&](std::size_t k) { of_block[k] = system_of<D>(partner.encounters[k]); });
        System system = partner.alone;
        for (const System& part : of_block) system.add(part);
        inverse.push_back(system.a.ldlt().solve(Matrix6::Identity()));
        motion.push_back(inverse.back() * system.b);
    }
    for (Touch& touch : touches) touch.impulse = 0.0;
    stop_at_touches(dt, inverse, touches, motion);
    return motion;
}

template <int D>
std::vector<Vector6> find_motions(double dt, bool held, std::vector<Partner>& partners,
                                  std::vector<Touch>& touches) {
    std::vector<Vector6> motion(partners.size(), Vector6::Zero());
    for (int turn = 0; turn < greatest_turns; ++turn) {
        if (!held) motion = solve<D>(dt, partners, touches);
        bool changed = false;
        for (std::size_t n = 0; n < partners.size(); ++n) {
            for (Encounter& encounter : partners[n].encounters) {
                changed = update_presses(motion[n], 2 * turn > greatest_turns, encounter) || changed;
            }
        }
        if (!changed || held) return motion;
    }
    return solve<D>(dt, partners, touches);
}

}  // namespace

template <int D, class Real>
void meet_bodies(double dt, double falling, Simulation<D, Real>& s) {
    if (s.rigid.empty()) return;
    std::vector<Touch> touches = find_touches(s.grid.layout, s.parameters.boundaries, dt, s.rigid);
    std::vector<Partner> partners = find_partners(falling, s);
    const bool held = s.settling.going != 0;
    const std::vector<Vector6> motion = find_motions<D>(dt, held, partners, touches);
    for (std::size_t n = 0; n < partners.size(); ++n) {
        RigidBody& body = s.rigid[n];
        const std::vector<Encounter>& encounters = partners[n].encounters;
        std::vector<Given> of_block(encounters.size());
        parallel_for(of_block.size(), [&](std::size_t k) {
            of_block[k] = move_nodes<D, Real>(motion[n], body.friction, encounters[k],
                                              s.grid.block_nodes(encounters[k].slot));
        });
        Given given;
        for (const Given& part : of_block) {
            given.impulse += part.impulse;
            given.turn += part.turn;
            given.friction += part.friction;
            given.friction_turn += part.friction_turn;
        }
        body.water_impulse += given.impulse + given.friction;
        body.water_turn += given.turn + given.friction_turn;
        if (held) {
            s.wall_impulse -= drop<D>(given.impulse + given.friction);  // who holds it
            continue;
        }
        body.velocity = motion[n].head<3>() + given.friction / body.mass;
        body.angular_momentum = turned_inertia(body) * motion[n].tail<3>() + given.friction_turn;
        body.angular_velocity = turned_inertia(body).ldlt().solve(body.angular_momentum);
    }
    for (const Touch& touch : touches) {
        const Eigen::Vector3d impulse = touch.impulse * touch.on_a.head<3>();
        s.rigid[static_cast<std::size_t>(touch.a)].contact_impulse += impulse;
        if (touch.b >= 0)
            s.rigid[static_cast<std::size_t>(touch.b)].contact_impulse -= impulse;
        else
            s.wall_impulse += drop<D>(impulse);
    }
}

#define TIDEWATER_INSTANTIATE(D, Real) template void meet_bodies(double, double, Simulation<D, Real>&);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
