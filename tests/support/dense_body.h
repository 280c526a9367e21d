// The slow twin's rigid body: a box, and how the nodes of a dense grid meet it (mpm/bodies/rigid.h,
// mpm/step/contact.h). No walls: bodies of twins stay away from them.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "mpm/step/start.h"
#include "mpm/step/step.h"

namespace tidewater::test {

template <int D>
struct DenseBody {
    using Vec = Vector<D, double>;
    using Vec3 = Eigen::Vector3d;

    mpm::RigidStart<D> start;
    Vec3 center, velocity, spin, momentum;  // momentum: angular, about the centre
    Eigen::Matrix3d turned;                 // from its own axes
    Eigen::Matrix3d own_inertia = Eigen::Matrix3d::Zero();
    double mass;

    static Vec3 lift(const Vec& v) {
        if constexpr (D == 3)
            return v;
        else
            return {v[0], 0, v[1]};
    }

    explicit DenseBody(const mpm::RigidStart<D>& from)
        : start(from),
          center(lift(from.center)),
          velocity(lift(from.velocity)),
          spin(0, -from.spin, 0),
          mass(from.density * from.size.prod()) {
        const double c = std::cos(from.angle), s = std::sin(from.angle);
        turned << c, 0, -s, 0, 1, 0, s, 0, c;
        const Vec3 edge = lift(from.size);
        for (int k = 0; k < 3; ++k) {
            own_inertia(k, k) = mass / 12 * (edge.squaredNorm() - edge[k] * edge[k]);
        }
        momentum = inertia() * spin;
    }

    Eigen::Matrix3d inertia() const { return turned * own_inertia * turned.transpose(); }

    static double least_share() { return 0.75 * 0.75 * 0.75 / 6; }

    // ∫ of the quadratic B-spline up to t.
    static double integral(double t) {
        if (t <= -1.5) return 0;
        if (t <= -0.5) return std::pow(t + 1.5, 3) / 6;
        if (t <= 0.5) return 0.5 + 0.75 * t - t * t * t / 3;
        return t <= 1.5 ? 1 - std::pow(1.5 - t, 3) / 6 : 1;
    }
    static double spline(double t) {
        if (std::abs(t) >= 1.5) return 0;
        return std::abs(t) < 0.5 ? 0.75 - t * t : std::pow(1.5 - std::abs(t), 2) / 2;
    }

    struct Share {
        double value;
        Vec slope;
    };
    Share share(const Vec& x, double dx) const {
        const Vec3 r = turned.transpose() * (lift(x) - center), half = lift(start.size) / 2;
        double along[3] = {1, 1, 1}, change[3] = {0, 0, 0};
        for (int k = 0; k < 3; ++k) {
            if (D == 2 && k == 1) continue;
            along[k] = integral((half[k] - r[k]) / dx) - integral((-half[k] - r[k]) / dx);
            change[k] = (spline((half[k] + r[k]) / dx) - spline((half[k] - r[k]) / dx)) / dx;
        }
        const Vec3 own(change[0] * along[1] * along[2], along[0] * change[1] * along[2],
                       along[0] * along[1] * change[2]);
        const Vec3 slope = turned * own;
        Share share{along[0] * along[1] * along[2], Vec::Zero()};
        for (int k = 0; k < D; ++k) share.slope[k] = slope[D == 2 ? 2 * k : k];
        return share;
    }

    struct Touched {
        std::size_t index;
        double mass;
        Vec3 arm, velocity, normal;
        bool sticks, presses;
    };
    Touched touch(std::size_t index, const Vec& x, double m, const Vec& v, const Share& share,
                  double dx) const {
        const double slope = share.slope.norm();
        const bool sticks = start.contact == mpm::BodyContact::stick || slope * dx < 0.02;
        return {index,
                m,
                lift(x) - center,
                lift(v),
                sticks ? Vec3::Zero().eval() : lift(-share.slope / slope),
                sticks,
                false};
    }

    Vec3 velocity_at(const Vec3& arm) const { return velocity + spin.cross(arm); }

    // The body and the nodes that press on it move as one along what they share; nodes that would be pulled
    // are let go, nodes that would be run into taken in, until neither happens.
    void meet(std::vector<Touched>& nodes) {
        const Vec3 free_velocity = velocity, free_momentum = momentum;
        for (int turn = 0; turn < 50; ++turn) {
            Eigen::Matrix<double, 6, 6> a = Eigen::Matrix<double, 6, 6>::Zero();
            Eigen::Matrix<double, 6, 1> b;
            a.topLeftCorner<3, 3>() = mass * Eigen::Matrix3d::Identity();
            a.bottomRightCorner<3, 3>() = inertia();
            b << mass * free_velocity, free_momentum;
            for (const Touched& node : nodes) {
                if (!node.sticks && !node.presses) continue;
                Eigen::Matrix<double, 3, 6> motion;
                motion.leftCols<3>() = Eigen::Matrix3d::Identity();
                for (int k = 0; k < 3; ++k) motion.col(3 + k) = Vec3::Unit(k).cross(node.arm);
                const Eigen::Matrix3d held = node.sticks ? Eigen::Matrix3d::Identity().eval()
                                                         : (node.normal * node.normal.transpose()).eval();
                a += node.mass * motion.transpose() * held * motion;
                b += node.mass * motion.transpose() * held * node.velocity;
            }
            const Eigen::Matrix<double, 6, 1> u = a.fullPivLu().solve(b);
            velocity = u.template head<3>();
            spin = u.template tail<3>();
            bool changed = false;
            for (Touched& node : nodes) {
                const bool presses = node.normal.dot(velocity_at(node.arm) - node.velocity) > 0;
                changed = changed || (!node.sticks && presses != node.presses);
                node.presses = presses;
            }
            if (!changed) break;
        }
        Vec3 rubbed = Vec3::Zero(), turned_by = Vec3::Zero();
        const Vec3 met = velocity, met_spin = spin;
        for (Touched& node : nodes) {
            const Vec3 apart = met + met_spin.cross(node.arm) - node.velocity;
            if (node.sticks) {
                node.velocity += apart;
            } else if (node.presses) {
                const double along = node.normal.dot(apart);
                const Vec3 slip = apart - along * node.normal;
                const double most = start.friction * along;
                const Vec3 rubbing =
                    most == 0 ? Vec3::Zero().eval() : (slip * std::min(1.0, most / slip.norm())).eval();
                node.velocity += along * node.normal + rubbing;
                rubbed -= node.mass * rubbing;
                turned_by -= node.mass * node.arm.cross(rubbing);
            }
        }
        velocity += rubbed / mass;
        momentum = inertia() * spin + turned_by;
        spin = inertia().inverse() * momentum;
    }

    void move(double dt) {
        center += dt * velocity;
        if (spin.norm() > 0) turned = Eigen::AngleAxisd(dt * spin.norm(), spin.normalized()) * turned;
        spin = inertia().inverse() * momentum;
    }
};

}  // namespace tidewater::test
