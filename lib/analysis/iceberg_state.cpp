#include "analysis/iceberg_state.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace tidewater::analysis {
namespace {

using Members = std::span<const std::uint32_t>;

Eigen::Vector3d row(std::span<const float> values, std::uint32_t p) {
    return Eigen::Vector3f(values[3 * p], values[3 * p + 1], values[3 * p + 2]).cast<double>();
}

// Volume, centroid and velocity.
void find_means(const IcebergParticles& particles, Members members, IcebergState& state) {
    for (const std::uint32_t p : members) {
        const double volume = particles.volume[p];
        state.volume += volume;
        state.centroid += volume * row(particles.points, p);
        state.velocity += volume * row(particles.velocity, p);
    }
    state.centroid /= state.volume;
    state.velocity /= state.volume;
}

// Sets the rotation; returns ∫ r rᵀ dV about the centroid.
Eigen::Matrix3d find_rotation(const IcebergParticles& particles, Members members, int dimension,
                              IcebergState& state) {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
    for (const std::uint32_t p : members) {
        const double volume = particles.volume[p];
        const Eigen::Vector3d r = row(particles.points, p) - state.centroid;
        spread += volume * r * r.transpose();
        momentum += volume * r.cross(row(particles.velocity, p) - state.velocity);
    }
    if (dimension == 2) momentum = {0.0, momentum[1], 0.0};
    const Eigen::Matrix3d inertia = spread.trace() * Eigen::Matrix3d::Identity() - spread;
    state.rotation = inertia.completeOrthogonalDecomposition().solve(momentum);
    return spread;
}

void find_box(const IcebergParticles& particles, Members members, const Surroundings& surroundings,
              const Eigen::Matrix3d& spread, IcebergState& state) {
    const Eigen::Matrix3d along =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().transpose();
    Eigen::Vector3d low = Eigen::Vector3d::Constant(INFINITY), high = -low;
    for (const std::uint32_t p : members) {
        const Eigen::Vector3d place = along * (row(particles.points, p) - state.centroid);
        low = low.cwiseMin(place);
        high = high.cwiseMax(place);
    }
    Eigen::Vector3d edge = high - low + Eigen::Vector3d::Constant(surroundings.spacing);
    if (surroundings.dimension == 2) {  // the axis across the slice is the width's
        for (int k = 0; k < 3; ++k) {
            if (std::abs(along(k, 1)) > 0.5) edge[k] = -1.0;
        }
    }
    std::array<int, 3> order{0, 1, 2};
    std::ranges::stable_sort(order, std::ranges::greater(), [&](int axis) { return edge[axis]; });
    if (surroundings.dimension == 2) std::swap(order[1], order[2]);
    for (int k = 0; k < 3; ++k) state.axes.col(k) = along.row(order[static_cast<std::size_t>(k)]).transpose();
    state.length = edge[order[0]];
    state.width = std::max(0.0, edge[order[1]]);
    state.height = edge[order[2]];
}

// Draft, freeboard, what is below the still level, and clearance; each particle is a spacing high.
void find_heights(const IcebergParticles& particles, Members members, const Surroundings& surroundings,
                  IcebergState& state) {
    const double spacing = surroundings.spacing, level = surroundings.still_level;
    double lowest = INFINITY, highest = -INFINITY, submerged = 0.0, clearance = INFINITY;
    for (const std::uint32_t p : members) {
        const Eigen::Vector3d at = row(particles.points, p);
        const double low = at[2] - 0.5 * spacing;
        lowest = std::min(lowest, low);
        highest = std::max(highest, low + spacing);
        submerged += particles.volume[p] * std::clamp((level - low) / spacing, 0.0, 1.0);
        if (surroundings.ground) clearance = std::min(clearance, low - surroundings.ground(at[0], at[1]));
    }
    state.draft = level - lowest;
    state.freeboard = highest - level;
    state.submerged = submerged / state.volume;
    if (surroundings.ground) state.clearance = clearance;
}

double plan_area(const IcebergParticles& particles, Members members, const Surroundings& surroundings) {
    const double spacing = surroundings.spacing;
    std::vector<std::pair<int, int>> squares;
    for (const std::uint32_t p : members) {
        const Eigen::Vector3d at = row(particles.points, p);
        squares.emplace_back(static_cast<int>(std::floor(at[0] / spacing)),
                             static_cast<int>(std::floor(at[1] / spacing)));
    }
    std::ranges::sort(squares);
    const auto repeated = std::ranges::unique(squares);
    squares.erase(repeated.begin(), repeated.end());
    if (surroundings.dimension == 2) return spacing * (squares.back().first - squares.front().first + 1);
    return spacing * spacing * static_cast<double>(squares.size());
}

}  // namespace

double IcebergState::tilt() const {
    return std::asin(std::min(1.0, std::abs(axes(2, 0)))) * 180.0 / std::numbers::pi;
}

IcebergState describe_iceberg(const IcebergParticles& particles, Members members,
                              const Surroundings& surroundings) {
    assert(!members.empty() && surroundings.spacing > 0.0);
    assert(surroundings.dimension == 2 || surroundings.dimension == 3);
    IcebergState state;
    find_means(particles, members, state);
    const Eigen::Matrix3d spread = find_rotation(particles, members, surroundings.dimension, state);
    find_box(particles, members, surroundings, spread, state);
    find_heights(particles, members, surroundings, state);
    state.area = plan_area(particles, members, surroundings);
    return state;
}

}  // namespace tidewater::analysis
