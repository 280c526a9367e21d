#include "mpm/bodies/collide.h"

#include <algorithm>
#include <cmath>

#include "mpm/base/instantiate.h"
#include "mpm/bodies/lift.h"

namespace tidewater::mpm {
namespace {

constexpr int max_rounds = 100;

Vector6 lever(const Eigen::Vector3d& normal, const Eigen::Vector3d& arm) {
    Vector6 on;
    on << normal, arm.cross(normal);
    return on;
}

// The distance of a point from a body's surface, negative inside, and the direction out of it.
struct Nearest {
    double distance = 0.0;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};

template <int D>
Nearest nearest_surface(const RigidBody& body, const Eigen::Vector3d& arm) {
    const Eigen::Vector3d r = body.rotation.conjugate() * arm;
    Eigen::Vector3d beyond = r.cwiseAbs() - body.half_size;
    if (D == 2) beyond[1] = -body.radius();
    int axis = 0;
    const double most = beyond.maxCoeff(&axis);
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    if (most <= 0.0) {
        normal[axis] = r[axis] < 0.0 ? -1.0 : 1.0;
        return {most, body.rotation * normal};
    }
    for (int k = 0; k < 3; ++k) {
        if (beyond[k] > 0.0) normal[k] = r[k] < 0.0 ? -beyond[k] : beyond[k];
    }
    const double distance = normal.norm();
    return {distance, body.rotation * (normal / distance)};
}

// Keeps the contacts of one body with one thing, and pushes the body back by the deepest.
struct FoundContacts {
    std::vector<ContactPoint>& contacts;
    double deepest = 0.0;
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();

    void add(int a, int b, const Eigen::Vector3d& normal, const Eigen::Vector3d& arm_a,
             const Eigen::Vector3d& arm_b, double gap) {
        contacts.push_back(
            {.a = a, .b = b, .on_a = lever(normal, arm_a), .on_b = lever(normal, arm_b), .gap = gap});
        if (gap >= -deepest) return;
        deepest = -gap;
        direction = normal;
    }
    Eigen::Vector3d push_back(double cell_size) const {
        return std::min(deepest, max_correction * cell_size) * direction;
    }
};

template <int D>
void collide_with_walls(const Layout<D>& layout, int index, double reach, RigidBody& body,
                        std::vector<ContactPoint>& contacts) {
    const Index<D> anchor = anchor_of<D>(body);
    const Eigen::Matrix3d rotation = body.rotation.toRotationMatrix();
    for (int wall = 0; wall < 2 * D; ++wall) {
        const auto a = static_cast<std::size_t>(wall / 2);
        const double inward = wall % 2 == 0 ? 1.0 : -1.0;
        const int axis = wall / 2 == D - 1 ? 2 : wall / 2;
        const double plane = layout.cell_size * ((wall % 2 == 0 ? 0 : layout.cells[a]) - anchor[a]);
        if (inward * (body.center[axis] - plane) > body.radius() + reach) continue;
        const Eigen::Vector3d normal = inward * Eigen::Vector3d::Unit(axis);
        FoundContacts found{contacts};
        for (std::size_t corner = 0; corner < static_cast<std::size_t>(power(2, D)); ++corner) {
            const Eigen::Vector3d arm = rotation * body.surface[corner];
            const double gap = inward * (body.center[axis] + arm[axis] - plane);
            if (gap < reach) found.add(index, -1, normal, arm, arm, gap);
        }
        body.center += found.push_back(layout.cell_size);
    }
}

template <int D>
void collide_with_bed(const Layout<D>& layout, const Bed<D>& bed, int index, double reach, RigidBody& body,
                      std::vector<ContactPoint>& contacts) {
    if (!bed.exists()) return;
    const Eigen::Matrix3d rotation = body.rotation.toRotationMatrix();
    const Eigen::Vector3d center = body.center_in_box(layout.cell_size);
    FoundContacts found{contacts};
    for (const Eigen::Vector3d& point : body.surface) {
        const Eigen::Vector3d arm = rotation * point;
        const Vector<D, double> place = drop<D>(center + arm);
        const Vector<D - 1, double> below = place.template head<D - 1>();
        const Vector<D - 1, double> slope = bed.slope(below, layout.cell_size);
        Vector<D, double> normal;
        normal << -slope, 1.0;
        normal.normalize();
        const double gap = (place[D - 1] - bed.height(below)) * normal[D - 1];
        if (gap < reach) found.add(index, -1, lift<D>(normal), arm, arm, gap);
    }
    body.center += found.push_back(layout.cell_size);
}

// The surface points of `of` against the faces of `other`.
template <int D>
void collide_with_faces(int of_index, const RigidBody& of, int other_index, const RigidBody& other,
                        const Eigen::Vector3d& between, double reach, FoundContacts& found) {
    const Eigen::Matrix3d rotation = of.rotation.toRotationMatrix();
    for (const Eigen::Vector3d& point : of.surface) {
        const Eigen::Vector3d arm = rotation * point, from_other = between + arm;
        if (from_other.norm() > other.radius() + reach) continue;
        const Nearest nearest = nearest_surface<D>(other, from_other);
        if (nearest.distance < reach)
            found.add(of_index, other_index, nearest.normal, arm, from_other, nearest.distance);
    }
}

template <int D>
void collide_with_each_other(double cell_size, int first, int second, double reach,
                             std::vector<RigidBody>& bodies, std::vector<ContactPoint>& contacts) {
    RigidBody &a = bodies[static_cast<std::size_t>(first)], &b = bodies[static_cast<std::size_t>(second)];
    Eigen::Vector3d between = a.center - b.center;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        between[static_cast<int>(axis)] += cell_size * (a.anchor[axis] - b.anchor[axis]);
    }
    if (between.norm() > a.radius() + b.radius() + reach) return;
    const double share = b.mass / (a.mass + b.mass);
    const auto push_apart = [&](RigidBody& out, RigidBody& back, double out_share,
                                const FoundContacts& found) {
        const Eigen::Vector3d push = found.push_back(cell_size);
        out.center += out_share * push;
        back.center -= (1.0 - out_share) * push;
    };
    FoundContacts of_a{contacts}, of_b{contacts};
    collide_with_faces<D>(first, a, second, b, between, reach, of_a);
    collide_with_faces<D>(second, b, first, a, -between, reach, of_b);
    push_apart(a, b, share, of_a);
    push_apart(b, a, 1.0 - share, of_b);
}

}  // namespace

template <int D>
std::vector<ContactPoint> find_contacts(const Layout<D>& layout, const Boundaries<D>& boundaries, double dt,
                                        std::vector<RigidBody>& bodies) {
    // Further than anything moves in a step: forces may make bodies faster meanwhile.
    double fastest = 0.0;
    for (const RigidBody& body : bodies) fastest = std::max(fastest, max_speed(body));
    const double reach = 2.0 * dt * fastest + 0.1 * layout.cell_size;
    std::vector<ContactPoint> contacts;
    for (std::size_t n = 0; n < bodies.size(); ++n) {
        const int index = static_cast<int>(n);
        collide_with_walls(layout, index, reach, bodies[n], contacts);
        collide_with_bed(layout, boundaries.bed, index, reach, bodies[n], contacts);
        for (int other = 0; other < index; ++other) {
            collide_with_each_other<D>(layout.cell_size, other, index, reach, bodies, contacts);
        }
    }
    return contacts;
}

void solve_contacts(double dt, const std::vector<Matrix6>& inverse, std::vector<ContactPoint>& contacts,
                    std::vector<Vector6>& motion) {
    double max_impulse = 0.0;  // of all impulses
    for (int round = 0; round < max_rounds; ++round) {
        double change = 0.0;
        for (ContactPoint& contact : contacts) {
            const auto a = static_cast<std::size_t>(contact.a), b = static_cast<std::size_t>(contact.b);
            const bool fixed = contact.b < 0;
            const Vector6 from_a = inverse[a] * contact.on_a;
            Vector6 from_b = Vector6::Zero();
            double approach = contact.on_a.dot(motion[a]), yields = contact.on_a.dot(from_a);
            if (!fixed) {
                from_b = inverse[b] * contact.on_b;
                approach -= contact.on_b.dot(motion[b]);
                yields += contact.on_b.dot(from_b);
            }
            const double wanted = -(approach + std::max(contact.gap, 0.0) / dt) / yields;
            const double given = std::max(contact.impulse + wanted, 0.0) - contact.impulse;
            contact.impulse += given;
            motion[a] += given * from_a;
            if (!fixed) motion[b] -= given * from_b;
            change = std::max(change, std::abs(given));
            max_impulse = std::max(max_impulse, contact.impulse);
        }
        if (change <= 1e-12 * max_impulse) return;
    }
}

#define TIDEWATER_INSTANTIATE(D)                                                                     \
    template std::vector<ContactPoint> find_contacts(const Layout<D>&, const Boundaries<D>&, double, \
                                                     std::vector<RigidBody>&);
TIDEWATER_FOR_EACH_DIMENSION(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
