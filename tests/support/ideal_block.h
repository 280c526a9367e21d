// A block that moves freely in ideal water: what water without friction or wakes would let it do. Panels on
// its wetted sides; the still level is kept at the water's pressure 0 and makes no waves.
//
//     φ = Σ_j σ_j ∫_j G ds,   ∂φ/∂n = u·n on the wetted panels,   φ = 0 at z = D,   ∂φ/∂n = 0 at z = 0
//     G = Σ_n (−1)ⁿ [ln r(x, z − 2nD) + ln r(x, −z − 2nD)]/2π     so that both hold; no walls at the sides
//     A_ik = −ρ Σ φ_i n_k ds      added masses of unit motions i, k = along x, z, and turning by θ
//
//     T = ½ q̇ᵀ 𝓜 q̇,   𝓜 = diag(M, M, I) + A(z, θ),   p = 𝓜 q̇
//     ṗ = ½ q̇ᵀ (∂𝓜/∂q) q̇ + F     F: weight and hydrostatic pressure, from the area below z = D
//
// q = (x, z, θ) of the centre, θ counterclockwise from x to z. Per metre of width. What it leaves out, waves,
// wakes and walls, only takes speed from the block. Constant strength on each panel, exactly integrated:
// first order in the panels' length. Source: J. N. Newman, Marine Hydrodynamics (1977), §4.13–4.16. Test:
// tests/validation/ideal_block_test.cpp.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace tidewater::test {

struct IdealBlock {
    double width = 0.0, height = 0.0;  // along x and z at θ = 0, m
    double density = 920.0, water_density = 1000.0, depth = 1.0, gravity = 9.81;
    int panels = 20;  // per side of the block

    double mass() const { return density * width * height; }
    double inertia() const { return mass() * (width * width + height * height) / 12.0; }
};

using Pose = Eigen::Vector3d;  // x, z of the centre, m; θ

inline std::array<Eigen::Vector2d, 4> corners_of(const IdealBlock& block,
                                                 const Pose& at) {  // counterclockwise
    const Eigen::Rotation2Dd turn(at[2]);
    const Eigen::Vector2d center = at.head<2>(), half(0.5 * block.width, 0.5 * block.height);
    const Eigen::Vector2d other(half[0], -half[1]);
    return {center - turn * half, center + turn * other, center + turn * half, center - turn * other};
}

// The part of the block below the still level: corners counterclockwise, and which edges are the block's own.
struct Wetted {
    std::vector<Eigen::Vector2d> corners;
    std::vector<bool> own;  // the edge from corner k to k + 1
    double area = 0.0;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
};

inline Wetted wetted(const IdealBlock& block, const Pose& at) {
    const auto box = corners_of(block, at);
    Wetted part;
    for (std::size_t k = 0; k < 4; ++k) {
        const Eigen::Vector2d& here = box[k];
        const Eigen::Vector2d& next = box[(k + 1) % 4];
        const bool below = here[1] < block.depth;
        if (below) part.corners.push_back(here), part.own.push_back(true);
        if (below == (next[1] < block.depth)) continue;
        part.corners.emplace_back(here + (block.depth - here[1]) / (next[1] - here[1]) * (next - here));
        part.own.push_back(!below);  // coming up again, an edge of the block; else the level's
    }
    for (std::size_t k = 0; k < part.corners.size(); ++k) {
        const Eigen::Vector2d& a = part.corners[k];
        const Eigen::Vector2d& b = part.corners[(k + 1) % part.corners.size()];
        const double twice = a[0] * b[1] - a[1] * b[0];
        part.area += 0.5 * twice;
        part.centre += twice / 6.0 * (a + b);
    }
    if (part.area > 0.0) part.centre /= part.area;
    return part;
}

struct Panel {
    Eigen::Vector2d from, to;
    Eigen::Vector2d middle() const { return 0.5 * (from + to); }
    double length() const { return (to - from).norm(); }
    Eigen::Vector2d normal() const { return Eigen::Vector2d(to[1] - from[1], from[0] - to[0]) / length(); }
};

// ∫ ln r ds / 2π of a panel at a point, and its gradient.
inline double panel_potential(const Panel& panel, const Eigen::Vector2d& at, Eigen::Vector2d& gradient) {
    const double length = panel.length();
    const Eigen::Vector2d along = (panel.to - panel.from) / length, across(-along[1], along[0]);
    const double x = (at - panel.from).dot(along), y = (at - panel.from).dot(across);
    const double first = x * x + y * y, last = (x - length) * (x - length) + y * y;
    const double angle = std::atan2(y, x - length) - std::atan2(y, x);
    gradient = (0.5 * std::log(first / last) * along + angle * across) / (2.0 * std::numbers::pi);
    return (0.5 * (x * std::log(first) - (x - length) * std::log(last)) - length + y * angle) /
           (2.0 * std::numbers::pi);
}

inline Eigen::Matrix3d added_mass(const IdealBlock& block, const Pose& at) {
    const Wetted part = wetted(block, at);
    std::vector<Panel> panels;
    for (std::size_t k = 0; k < part.corners.size(); ++k) {
        if (!part.own[k]) continue;
        const Eigen::Vector2d& a = part.corners[k];
        const Eigen::Vector2d side = part.corners[(k + 1) % part.corners.size()] - a;
        const auto place = [&](int n) {  // closer together at corners
            return a + 0.5 * (1.0 - std::cos(std::numbers::pi * n / block.panels)) * side;
        };
        for (int n = 0; n < block.panels; ++n) panels.push_back({place(n), place(n + 1)});
    }
    const auto count = static_cast<Eigen::Index>(panels.size());
    Eigen::MatrixXd potential(count, count), speed(count, count), motion(count, 3);
    Eigen::VectorXd length(count);
    constexpr int images = 6;
    for (Eigen::Index k = 0; k < count; ++k) {
        const Panel& panel = panels[static_cast<std::size_t>(k)];
        const Eigen::Vector2d middle = panel.middle(), normal = panel.normal(), arm = middle - at.head<2>();
        motion.row(k) << normal[0], normal[1], arm[0] * normal[1] - arm[1] * normal[0];
        length[k] = panel.length();
        for (Eigen::Index j = 0; j < count; ++j) {
            potential(k, j) = speed(k, j) = 0.0;
            for (int n = 1 - images; n <= images; ++n) {  // odd about the still level
                for (const double side : {1.0, -1.0}) {
                    Panel image = panels[static_cast<std::size_t>(j)];
                    image.from[1] = side * image.from[1] + 2.0 * n * block.depth;
                    image.to[1] = side * image.to[1] + 2.0 * n * block.depth;
                    const double sign = n % 2 == 0 ? 1.0 : -1.0;
                    if (n == 0 && side > 0.0 && j == k) {  // on its outer side
                        potential(k, j) +=
                            length[k] * (std::log(0.5 * length[k]) - 1.0) / (2.0 * std::numbers::pi);
                        speed(k, j) += 0.5;
                        continue;
                    }
                    Eigen::Vector2d gradient;
                    potential(k, j) += sign * panel_potential(image, middle, gradient);
                    speed(k, j) += sign * gradient.dot(normal);
                }
            }
        }
    }
    const Eigen::MatrixXd phi = potential * speed.partialPivLu().solve(motion);
    const Eigen::Matrix3d mass = -block.water_density * phi.transpose() * length.asDiagonal() * motion;
    return 0.5 * (mass + mass.transpose());
}

// Weight and hydrostatic pressure.
inline Eigen::Vector3d still_forces(const IdealBlock& block, const Pose& at) {
    const Wetted part = wetted(block, at);
    const double lift = block.water_density * block.gravity * part.area;
    return {0.0, lift - block.mass() * block.gravity, (part.centre[0] - at[0]) * lift};
}

struct IdealMotion {
    double time = 0.0;
    Pose at = Pose::Zero();
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    double kinetic = 0.0;  // of block and water, J/m

    double fastest_point(const IdealBlock& block) const {
        double most = 0.0;
        for (const Eigen::Vector2d& corner : corners_of(block, at)) {
            const Eigen::Vector2d arm = corner - at.head<2>();
            const Eigen::Vector2d v = velocity.head<2>() + velocity[2] * Eigen::Vector2d(-arm[1], arm[0]);
            most = std::max(most, v.norm());
        }
        return most;
    }
};

// From rest, by steps of dt (Runge–Kutta of fourth order) as long as going(motion) says.
template <class Going>
std::vector<IdealMotion> release(const IdealBlock& block, const Pose& from, double dt, const Going& going) {
    const auto inertia = [&](const Pose& at) {
        const Eigen::Vector3d own(block.mass(), block.mass(), block.inertia());
        return Eigen::Matrix3d(added_mass(block, at) + Eigen::Matrix3d(own.asDiagonal()));
    };
    using State = Eigen::Matrix<double, 6, 1>;  // q, p
    const auto rate = [&](const State& s) {
        const Pose at = s.head<3>();
        const Eigen::Vector3d velocity = inertia(at).ldlt().solve(Eigen::Vector3d(s.tail<3>()));
        State change;
        change << velocity, still_forces(block, at);
        for (const int k : {1, 2}) {  // nothing depends on x
            constexpr double h = 1e-3;
            const Pose step = h * Pose::Unit(k);
            const Eigen::Matrix3d slope = (inertia(at + step) - inertia(at - step)) / (2.0 * h);
            change[3 + k] += 0.5 * velocity.dot(slope * velocity);
        }
        return change;
    };
    State s = State::Zero();
    s.head<3>() = from;
    std::vector<IdealMotion> motion{{.at = from}};
    while (going(motion.back())) {
        const State a = rate(s), b = rate(s + 0.5 * dt * a), c = rate(s + 0.5 * dt * b), d = rate(s + dt * c);
        s += dt / 6.0 * (a + 2.0 * b + 2.0 * c + d);
        const Pose at = s.head<3>();
        const Eigen::Vector3d momentum = s.tail<3>(), velocity = inertia(at).ldlt().solve(momentum);
        motion.push_back({motion.back().time + dt, at, velocity, 0.5 * momentum.dot(velocity)});
    }
    return motion;
}

// What the still forces have done on the way, J/m, along the motion (trapezoids): what is there for
// `kinetic`.
inline double work_done(const IdealBlock& block, const std::vector<IdealMotion>& motion) {
    double work = 0.0;
    for (std::size_t n = 1; n < motion.size(); ++n) {
        const Eigen::Vector3d mean =
            0.5 * (still_forces(block, motion[n - 1].at) + still_forces(block, motion[n].at));
        work += mean.dot(motion[n].at - motion[n - 1].at);
    }
    return work;
}

}  // namespace tidewater::test
