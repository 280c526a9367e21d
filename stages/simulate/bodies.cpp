#include "bodies.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace tidewater {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

// Components along the axes, in 2D without y.
void append_vector(int dimension, const Eigen::Vector3d& v, std::vector<double>& row) {
    row.push_back(v[0]);
    if (dimension == 3) row.push_back(v[1]);
    row.push_back(v[2]);
}

// What turns: in 2D from x towards z.
void append_turn(int dimension, const Eigen::Vector3d& v, std::vector<double>& row) {
    if (dimension == 3)
        append_vector(3, v, row);
    else
        row.push_back(-v[1]);
}

std::vector<std::string> columns_of(int dimension) {
    std::vector<std::string> columns{"time", "body"};
    const auto vector = [&](const std::string& name) {
        for (const char* axis : {"x", "y", "z"}) {
            if (dimension == 3 || *axis != 'y') columns.push_back(name + axis);
        }
    };
    const auto turn = [&](const char* name, const std::string& in_space) {
        dimension == 3 ? vector(in_space + "_") : columns.push_back(name);
    };
    vector("");
    turn("angle", "rotation");
    vector("velocity_");
    turn("spin", "spin");
    columns.push_back("fastest");
    vector("water_force_");
    turn("water_torque", "water_torque");
    vector("contact_force_");
    columns.insert(columns.end(), {"kinetic", "potential", "mass"});
    return columns;
}

// Axis times angle, rad; the angle at most π.
Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation) {
    const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;
    const double length = rotation.vec().norm();
    if (length == 0.0) return Eigen::Vector3d::Zero();
    return 2.0 * std::atan2(length, sign * rotation.w()) * sign / length * rotation.vec();
}

using Impulses = std::array<Eigen::Vector3d, 3>;  // water's, its turn, contacts'

Impulses impulses_of(const BodyReading& body) {
    return {body.water_impulse, body.water_angular_impulse, body.contact_impulse};
}

}  // namespace

BodiesTable::BodiesTable(const std::filesystem::path& path, const Provenance& provenance, int dimension)
    : table_(path, provenance, columns_of(dimension)) {}

void BodiesTable::append(int dimension, double gravity, double time, const std::vector<BodyReading>& bodies) {
    const bool first = last.empty();
    const double seconds = first ? std::numeric_limits<double>::quiet_NaN() : time - last[0];
    std::vector<double> now{time};
    std::size_t at = 1;
    for (std::size_t n = 0; n < bodies.size(); ++n) {
        const BodyReading& body = bodies[n];
        Impulses force = impulses_of(body);
        for (Eigen::Vector3d& impulse : force) {
            now.insert(now.end(), impulse.begin(), impulse.end());
            if (!first) impulse -= Eigen::Map<const Eigen::Vector3d>(last.data() + at);
            impulse /= seconds;
            at += 3;
        }
        std::vector<double> row{time, static_cast<double>(n + 1)};
        append_vector(dimension, body.center, row);
        append_turn(dimension, degrees * rotation_vector(body.rotation), row);
        append_vector(dimension, body.velocity, row);
        append_turn(dimension, body.angular_velocity, row);
        row.push_back(body.fastest);
        append_vector(dimension, force[0], row);
        append_turn(dimension, force[1], row);
        append_vector(dimension, force[2], row);
        row.push_back(body.kinetic);
        row.push_back(body.mass * gravity * body.center[2]);
        row.push_back(body.mass);
        table_.append(row);
    }
    last = std::move(now);
}

}  // namespace tidewater
