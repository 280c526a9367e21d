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

// The nearest point of a body's surface, as another point sees it.
struct Nearest {
    double distance = 0.0;                             // m, negative inside the body
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // outward
};

template <int D>
Nearest nearest_surface(const RigidBody& body, const Eigen::Vector3d& arm) {
    const Eigen::Vector3d r = body.rotation.conjugate() * arm;
    Eigen::Vector3d beyond = r.cwiseAbs() - body.half_size;
    if (D == 2) beyond[1] = -body.radius();
    int axis = 0;
    const double max_beyond = beyond.maxCoeff(&axis);
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    if (max_beyond <= 0.0) {
        normal[axis] = r[axis] < 0.0 ? -1.0 : 1.0;
        return {max_beyond, body.rotation * normal};
    }
    for (int k = 0; k < 3; ++k) {
        if (beyond[k] > 0.0) normal[k] = r[k] < 0.0 ? -beyond[k] : beyond[k];
    }
    const double distance = normal.norm();
    return {distance, body.rotation * (normal / distance)};
}

// Collects the contacts of one body with one obstacle, and keeps the deepest, which pushes the body back.
struct FoundContacts {
    std::vector<ContactPoint>& contacts;
    double max_depth = 0.0;                               // m
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // normal of the deepest contact

    void add(std::size_t a, std::optional<std::size_t> b, const Eigen::Vector3d& normal,
             const Eigen::Vector3d& arm_a, const Eigen::Vector3d& arm_b, double gap) {
        contacts.push_back(
            {.a = a, .b = b, .on_a = lever(normal, arm_a), .on_b = lever(normal, arm_b), .gap = gap});
        if (gap >= -max_depth) return;
        max_depth = -gap;
        direction = normal;
    }
    Eigen::Vector3d push_back(double cell_size) const {
        return std::min(max_depth, max_correction * cell_size) * direction;
    }
};

template <int D>
void collide_with_walls(const Layout<D>& layout, std::size_t index, double reach, RigidBody& body,
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
            if (gap < reach) found.add(index, std::nullopt, normal, arm, arm, gap);
        }
        body.center += found.push_back(layout.cell_size);
    }
}

template <int D>
void collide_with_bed(const Layout<D>& layout, const Bed<D>& bed, std::size_t index, double reach,
                      RigidBody& body, std::vector<ContactPoint>& contacts) {
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
        if (gap < reach) found.add(index, std::nullopt, lift<D>(normal), arm, arm, gap);
    }
    body.center += found.push_back(layout.cell_size);
}

// Finds the contacts of the surface points of `of` with the faces of `other`.
//     between  from the centre of `other` to that of `of`, m
template <int D>
void collide_with_faces(std::size_t of_index, const RigidBody& of, std::size_t other_index,
                        const RigidBody& other, const Eigen::Vector3d& between, double reach,
                        FoundContacts& found) {
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
void collide_with_each_other(double cell_size, std::size_t first, std::size_t second, double reach,
                             std::vector<RigidBody>& bodies, std::vector<ContactPoint>& contacts) {
    RigidBody &a = bodies[first], &b = bodies[second];
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
    // More than the distance at the present speeds, since forces may make bodies faster meanwhile.
    double speed = 0.0;
    for (const RigidBody& body : bodies) speed = std::max(speed, max_speed(body));
    const double reach = 2.0 * dt * speed + 0.1 * layout.cell_size;
    std::vector<ContactPoint> contacts;
    for (std::size_t index = 0; index < bodies.size(); ++index) {
        collide_with_walls(layout, index, reach, bodies[index], contacts);
        collide_with_bed(layout, boundaries.bed, index, reach, bodies[index], contacts);
        for (std::size_t other = 0; other < index; ++other) {
            collide_with_each_other<D>(layout.cell_size, other, index, reach, bodies, contacts);
        }
    }
    return contacts;
}

void solve_contacts(double dt, const std::vector<Matrix6>& inverse, std::vector<ContactPoint>& contacts,
                    std::vector<Vector6>& motion) {
    double max_impulse = 0.0;  // over all contacts and rounds
    for (int round = 0; round < max_rounds; ++round) {
        double change = 0.0;
        for (ContactPoint& contact : contacts) {
            const auto& [a, b, on_a, on_b, gap, impulse] = contact;
            const Vector6 from_a = inverse[a] * on_a;
            Vector6 from_b = Vector6::Zero();
            double parting = on_a.dot(motion[a]), compliance = on_a.dot(from_a);
            if (b) {
                from_b = inverse[*b] * on_b;
                parting -= on_b.dot(motion[*b]);
                compliance += on_b.dot(from_b);
            }
            const double wanted = -(parting + std::max(gap, 0.0) / dt) / compliance;
            const double given = std::max(impulse + wanted, 0.0) - impulse;
            contact.impulse += given;
            motion[a] += given * from_a;
            if (b) motion[*b] -= given * from_b;
            change = std::max(change, std::abs(given));
            max_impulse = std::max(max_impulse, impulse);
        }
        if (change <= 1e-12 * max_impulse) return;
    }
}

#define TIDEWATER_INSTANTIATE(D)                                                                     \
    template std::vector<ContactPoint> find_contacts(const Layout<D>&, const Boundaries<D>&, double, \
                                                     std::vector<RigidBody>&);
TIDEWATER_FOR_EACH_DIMENSION(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
