// A block in a tank of still water 1 m deep, 2D: how it starts, and what is seen of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mpm/state/ledger.h"
#include "mpm/step/settle.h"
#include "support/potential_flow.h"
#include "support/tank.h"

namespace tidewater::test {

struct Block {
    Vector<2, double> size{0.5, 0.5};
    double height = 0.79;    // of its centre, m; 0.79 is where the block of 0.5 m floats
    double angle = 0.0;      // degrees
    double density = 920.0;  // kg/m³
    mpm::BodyContact contact = mpm::BodyContact::slip;
};

struct Basin {
    double length = 4.0;  // m; the block is in its middle
    int cells = 20;       // per metre
    mpm::Transfer transfer = mpm::Transfer::apic;
    double sound_speed = 30.0;  // m/s
};

inline constexpr double water_density = 1000.0, still_level = 1.0;

inline mpm::Start<2> floating_start(const Block& block, const Basin& basin) {
    const double cell = 1.0 / basin.cells, angle = block.angle * std::numbers::pi / 180.0;
    const Vector<2, double> center(0.5 * basin.length, block.height);
    const Eigen::Rotation2D<double> back(-angle);
    mpm::Start<2> start;
    start.cell_size = cell;
    start.cells = {static_cast<int>(std::lround(basin.length * basin.cells)), 8 * basin.cells / 5};
    start.parameters.water.sound_speed = basin.sound_speed;
    start.parameters.transfer = basin.transfer;
    auto& water = start.bodies.emplace_back();
    water.points = lattice<2>(cell, start.cells, 2, 0.0, [&](const Vector<2, double>& point) {
        const Vector<2, double> from = (back * (point - center)).cwiseAbs();
        return point[1] < still_level && (from - 0.5 * block.size).maxCoeff() > 0.0;
    });
    water.volume = 0.25 * cell * cell * static_cast<double>(water.points.size());
    water.mass = water_density * water.volume;
    water.surface = still_level;
    auto& body = start.rigid.emplace_back();
    body.size = block.size;
    body.center = center;
    body.angle = angle;
    body.density = block.density;
    body.contact = block.contact;
    return start;
}

// Degrees from x towards z, −180 to 180.
inline double angle_of(const mpm::RigidBody& body) {
    const Eigen::Vector3d edge = body.rotation * Eigen::Vector3d::UnitX();
    return std::atan2(edge[2], edge[0]) * 180.0 / std::numbers::pi;
}

// How far the water's deepest particle is within the body, cells; 0 if none is.
template <class Real>
double deepest_particle(const mpm::Simulation<2, Real>& s, const mpm::RigidBody& body) {
    const double cell = s.grid.layout.cell_size;
    const Eigen::Vector3d center = body.center_in_box(cell);
    double deepest = 0.0;
    for (const auto& particles : s.bodies) {
        for (std::size_t slot = 0; slot < s.grid.particle_blocks.size(); ++slot) {
            const mpm::Index<2> block = mpm::block_at<2>(s.grid.particle_blocks[slot]);
            for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
                const Vector<2, double> x = mpm::global_position(s.grid.layout, block, particles, p);
                const Eigen::Vector3d from =
                    body.rotation.conjugate() * (Eigen::Vector3d(x[0], 0.0, x[1]) - center);
                const double inside =
                    std::min(body.half_size[0] - std::abs(from[0]), body.half_size[2] - std::abs(from[2]));
                deepest = std::max(deepest, inside / cell);
            }
        }
    }
    return deepest;
}

// One block's motion, each step's, from the start on.
struct Track {
    std::vector<double> time, height, speed, angle;  // s, m, m/s upward, degrees
    double most_energy = 0.0;  // above its start, J/m (mpm/state/ledger.h: half a step ahead)
    double energy = 0.0;       // at the end, above the start, J/m
    double deepest = 0.0;      // particle within the block at any time, cells
};

template <class Real>
Track follow(double until, mpm::Simulation<2, Real>& s) {
    const auto energy = [&] {
        const auto ledger = mpm::take_ledger(s);
        return ledger.kinetic + ledger.gravitational + ledger.elastic;
    };
    const mpm::RigidBody& body = s.rigid.front();
    const double first = energy();
    Track track;
    for (double look = 0.0;;) {
        track.time.push_back(s.time);
        track.height.push_back(body.center_in_box(s.grid.layout.cell_size)[2]);
        track.speed.push_back(body.velocity[2]);
        track.angle.push_back(angle_of(body));
        if (s.time >= look) {
            look += 0.02;
            track.energy = energy() - first;
            track.most_energy = std::max(track.most_energy, track.energy);
            track.deepest = std::max(track.deepest, deepest_particle(s, body));
        }
        if (s.time >= until) return track;
        mpm::advance(s, mpm::stable_time_step(s));
    }
}

// Relative; doctest::Approx adds 1 to the greater of both and so says nothing of small figures.
inline double off(double measured, double reference) { return measured / reference - 1.0; }

// A value of the track at a time, by linear interpolation.
inline double value_at(const Track& track, const std::vector<double>& values, double time) {
    const auto after = std::ranges::upper_bound(track.time, time);
    const auto n = static_cast<std::size_t>(after - track.time.begin());
    if (n == track.time.size()) return values.back();
    const double share = (time - track.time[n - 1]) / (track.time[n] - track.time[n - 1]);
    return values[n - 1] + share * (values[n] - values[n - 1]);
}

// When a speed that began downward first turns upward, s; by linear interpolation. −1: never.
inline double first_turn(const std::vector<double>& time, const std::vector<double>& speed) {
    for (std::size_t n = 1; n < speed.size(); ++n) {
        if (speed[n - 1] < 0.0 && speed[n] >= 0.0) {
            return time[n] - (time[n] - time[n - 1]) * speed[n] / (speed[n] - speed[n - 1]);
        }
    }
    return -1.0;
}

// The mean from a time on.
inline double mean_after(const Track& track, const std::vector<double>& values, double from) {
    double sum = 0.0, span = 0.0;
    for (std::size_t n = 1; n < values.size(); ++n) {
        if (track.time[n - 1] < from) continue;
        const double dt = track.time[n] - track.time[n - 1];
        sum += dt * values[n];
        span += dt;
    }
    return sum / span;
}

// The block of 0.5 m, let go a hundredth above where it floats: its draft's mean from 3 to 6 s, m. The level
// is that of as much water as there was.
inline double draft_of(mpm::BodyContact contact, const Basin& basin, Track& track) {
    const auto start = floating_start({.height = 0.8, .contact = contact}, basin);
    auto s = mpm::make_simulation<2, float>(start);
    track = follow(6.0, s);
    const double bottom = mean_after(track, track.height, 3.0) - 0.25;
    return (start.bodies.front().volume - 0.5 * bottom) / (basin.length - 0.5) - bottom;
}

// A block of 0.5 m and this density, held in the middle of the water until that found its place, then let go:
// how far it rises within `time` over ½ a t² with (M + M_a) a = (ρ(z) V − M) g, ρ(z) the density of water as
// compressed in the block's middle.
inline double rise_of(double density, mpm::BodyContact contact, const Basin& basin, double time,
                      Track& track) {
    const double middle = 0.5 * basin.length, area = 0.25, sound = basin.sound_speed;
    const PotentialFlow flow(basin.length, still_level, 0.0125, {middle - 0.25, middle + 0.25, 0.25, 0.75});
    const double pressed = water_density * (1.0 + flow.gravity * 0.5 / (sound * sound));
    const double acceleration =
        (pressed - density) * area * flow.gravity / (density * area + flow.added_mass());
    auto s = mpm::make_simulation<2, float>(
        floating_start({.height = 0.5, .density = density, .contact = contact}, basin));
    mpm::begin_settling(s);
    while (!mpm::settle_step(s, 1e3)) {
    }
    track = follow(time, s);
    return (value_at(track, track.height, time) - 0.5) / (0.5 * acceleration * time * time);
}

// The block of 0.5 m, let go 0.11 m above where it floats: twice the time until it turns, s, and how deep it
// is then below where it floats, m.
struct FirstHeave {
    double period = 0.0, depth = 0.0;
};
inline constexpr double lifted = 0.11;

inline FirstHeave linear_first_heave(double length, double cell) {
    const double draft = 0.46, dt = 1e-3;
    const PotentialFlow flow(length, still_level, cell,
                             {0.5 * length - 0.25, 0.5 * length + 0.25, still_level - draft, 2.0});
    const auto motion = free_heave(flow, 920.0 * 0.25, 0.5, lifted, dt, 1.2);
    std::vector<double> time, speed;
    double depth = 0.0;
    for (std::size_t n = 0; n < motion.size(); ++n) {
        time.push_back((static_cast<double>(n) - 0.5) * dt);  // speeds are those of half a step before
        speed.push_back(motion[n].speed);
        depth = std::max(depth, -motion[n].lift);
    }
    return {2.0 * first_turn(time, speed), depth};
}

inline FirstHeave first_heave(mpm::BodyContact contact, const Basin& basin, Track& track) {
    auto s =
        mpm::make_simulation<2, float>(floating_start({.height = 0.79 + lifted, .contact = contact}, basin));
    track = follow(1.2, s);
    const double turn = first_turn(track.time, track.speed);
    return {2.0 * turn, 0.79 - value_at(track, track.height, turn)};
}

}  // namespace tidewater::test
