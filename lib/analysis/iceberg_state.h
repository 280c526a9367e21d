// One iceberg's size, shape, place and motion in a frame, from its own particles.
//
// Test: tests/unit/analysis/iceberg_state_test.cpp
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <span>

#include "analysis/series.h"

namespace tidewater::analysis {

struct IcebergState {
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  // of its volume, m
    double volume = 0.0;                                 // at rest, m³ (2D: m²)
    // The oriented box: edges along the principal axes of the particles' covariance, from the least to the
    // greatest centre plus a particle spacing; length ≥ width ≥ height. In 2D the width is 0. Blocks whose
    // edges are nearly equal have no such axes: the box may lie at any angle.
    double length = 0.0, width = 0.0, height = 0.0;      // m
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // unit vectors of the three edges, as columns
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // m/s
    // ω = I⁻¹ L, both about the centroid and of the particles as points, rad/s: exact for a rigid motion.
    // Of one particle, or in 3D of a row of them, it is 0 where I is singular. In 2D ω is along y.
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero();
    double draft = 0.0, freeboard = 0.0;  // m, of its lowest below and its highest above the still level
    double submerged = 0.0;               // share of its volume below the still level
    double clearance = none;              // m, least height of a particle's lower end above the ground
    double area = 0.0;  // of its outline in plan, in squares of a spacing, m² (2D: its extent along x, m)

    // The angle of its longest edge against the horizontal, degrees from 0 to 90.
    double tilt() const;
};

struct IcebergParticles {
    std::span<const float> points;    // m, (x, y, z) per particle; y = 0 in 2D
    std::span<const float> velocity;  // m/s, likewise
    std::span<const float> volume;    // at rest, m³ (2D: m²)
};

struct Surroundings {
    int dimension = 2;                                   // 2 or 3
    double spacing = 0.0;                                // of the particles, m, > 0
    double still_level = 0.0;                            // z, m
    std::function<double(double x, double y)> ground{};  // its height, m; none: clearance is NaN
};

// members: of the particles, at least one; summed in this order.
IcebergState describe_iceberg(const IcebergParticles& particles, std::span<const std::uint32_t> members,
                              const Surroundings& surroundings);

}  // namespace tidewater::analysis
