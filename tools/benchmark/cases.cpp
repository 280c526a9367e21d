#include "cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/random.h"

namespace tidewater::benchmark {
namespace {

constexpr double depth = 100.0;                                                    // of the fjord, m
constexpr double turning_speed = 10.0, sliding_speed = 10.0, shaking_speed = 1.0;  // m/s
constexpr double ice_density = 900.0, rigid_density = 920.0;                       // kg/m³
constexpr int per_axis = 2;                                                        // particles in a cell
constexpr double jitter = 0.5;  // greatest distance between two places of a particle, in spacings

// Of measured strengths (90–320 kPa, Vaughan 1993) a middle one: the greatest stress that shaking makes at
// the front, ρ c v = 1.1 MPa with E = 1 GPa, is well above what it lets the ice bear, at the rear it is
// below.
void set_ice(mpm::IceModel& ice) {
    ice.density = ice_density;
    ice.youngs_modulus = 1e9;
    ice.beta_p0 = 0.2e6;
}

// A box of space from low to high, m.
template <int D>
struct Box {
    Vector<D, double> low, high;

    bool holds(const Vector<D, double>& point) const {
        return (point - low).minCoeff() >= 0.0 && (high - point).minCoeff() > 0.0;
    }
};

// A box that spans the fjord's whole width (one depth), from x0 to x1 and from the floor to `top`, all in
// depths.
template <int D>
Box<D> across(double x0, double x1, double top) {
    Box<D> box{Vector<D, double>::Zero(), Vector<D, double>::Constant(depth)};
    box.low[0] = x0 * depth;
    box.high[0] = x1 * depth;
    box.high[D - 1] = top * depth;
    return box;
}

// An empty fjord, its length and height in depths. `share` is the particles' volume, in cubes of the depth.
template <int D>
mpm::Start<D> make_fjord(double length, double height, double share, long particles) {
    const double per_cell = std::pow(per_axis, D);
    const double cells = std::pow(static_cast<double>(particles) / (per_cell * share), 1.0 / D);
    const int across_depth = std::max(4, static_cast<int>(std::lround(cells)));
    mpm::Start<D> start;
    start.cell_size = depth / across_depth;
    start.cells.fill(across_depth);
    start.cells[0] = static_cast<int>(std::lround(length * across_depth));
    start.cells[D - 1] = static_cast<int>(std::lround(height * across_depth));
    set_ice(start.parameters.ice);
    return start;
}

// The lattice's point number n, moved by jitter.
template <int D>
Vector<D, double> lattice_point(const mpm::Start<D>& start, long n) {
    const double spacing = start.cell_size / per_axis;
    Vector<D, double> point;
    long rest = n;
    for (int axis = D - 1; axis >= 0; --axis) {
        const long along = static_cast<long>(start.cells[static_cast<std::size_t>(axis)]) * per_axis;
        const double move =
            random_uniform(1, static_cast<std::uint64_t>(axis), static_cast<std::uint64_t>(n)) - 0.5;
        point[axis] = spacing * (static_cast<double>(rest % along) + 0.5 + jitter * move);
        rest /= along;
    }
    return point;
}

// Adds a body where inside(point) holds, moving with velocity(point).
template <int D, class Inside, class Velocity>
void add_body(mpm::Start<D>& start, Material material, double density, const Inside& inside,
              const Velocity& velocity) {
    typename mpm::Start<D>::Body body;
    body.material = material;
    long count = 1;
    for (const int along : start.cells) count *= static_cast<long>(along) * per_axis;
    for (long n = 0; n < count; ++n) {
        const Vector<D, double> point = lattice_point(start, n);
        if (!inside(point)) continue;
        body.points.push_back(point);
        body.velocity.push_back(velocity(point));
    }
    body.volume = std::pow(start.cell_size / per_axis, D) * static_cast<double>(body.points.size());
    body.mass = density * body.volume;
    start.bodies.push_back(std::move(body));
}

// Turning water: no flow through the sides of its box, no divergence. With ξ, ζ from 0 to 1 along and up:
//     u = U sin(πξ) cos(πζ),   w = −U (height/length) cos(πξ) sin(πζ),   and in 3D the same across.
template <int D>
Vector<D, double> turning(const Box<D>& box, const Vector<D, double>& point) {
    const Vector<D, double> size = box.high - box.low;
    const Vector<D, double> phase = std::numbers::pi * (point - box.low).cwiseQuotient(size);
    Vector<D, double> velocity = Vector<D, double>::Zero();
    for (int axis = 0; axis < D - 1; ++axis) {
        velocity[axis] = turning_speed * std::sin(phase[axis]) * std::cos(phase[D - 1]);
        velocity[D - 1] -=
            turning_speed * size[D - 1] / size[axis] * std::cos(phase[axis]) * std::sin(phase[D - 1]);
    }
    return velocity;
}

// Sliding ice that is shaken along x, from rear to front: u = U + V ξ sin(8πξ).
template <int D>
Vector<D, double> sliding(const Box<D>& box, const Vector<D, double>& point) {
    const double along = (point[0] - box.low[0]) / (box.high[0] - box.low[0]);
    Vector<D, double> velocity = Vector<D, double>::Zero();
    velocity[0] = sliding_speed + shaking_speed * along * std::sin(8.0 * std::numbers::pi * along);
    return velocity;
}

template <int D>
void add_water(mpm::Start<D>& start, const Box<D>& box, const Box<D>* without = nullptr) {
    add_body(
        start, Material::water, start.parameters.water.density,
        [&](const auto& point) { return box.holds(point) && !(without && without->holds(point)); },
        [&](const auto& point) { return turning(box, point); });
    start.bodies.back().surface = box.high[D - 1];
}

template <int D>
void add_ice(mpm::Start<D>& start, const Box<D>& box) {
    add_body(
        start, Material::ice, ice_density, [&](const auto& point) { return box.holds(point); },
        [&](const auto& point) { return sliding(box, point); });
}

// A tank four times as long as deep, in 3D twice.
template <int D>
mpm::Start<D> make_water(long particles) {
    const double length = D == 2 ? 4.0 : 2.0;
    mpm::Start<D> start = make_fjord<D>(length, 1.5, length, particles);
    add_water(start, across<D>(0.0, length, 1.0));
    return start;
}

// A slab of these proportions, with air before and behind it.
template <int D>
mpm::Start<D> make_ice(long particles, bool fracture) {
    const double length = D == 2 ? 4.0 : 2.0;
    mpm::Start<D> start = make_fjord<D>(length + 0.5, 1.25, length, particles);
    start.parameters.ice.fracture = fracture;
    add_ice(start, across<D>(0.25, 0.25 + length, 1.0));
    return start;
}

// Cliff of a depth's height, the water 0.8 of it; the iceberg is a cube of 0.4 and floats level.
mpm::Start<3> make_mixed(long particles) {
    constexpr double length = 3.0, level = 0.8, size = 0.4;
    mpm::Start<3> start = make_fjord<3>(length, 1.5, 1.0 + (length - 1.0) * level, particles);
    const double base = level - size * rigid_density / start.parameters.water.density;
    const Box<3> iceberg{depth * Vector<3, double>(1.8, 0.3, base),
                         depth * Vector<3, double>(1.8 + size, 0.3 + size, base + size)};
    add_water(start, across<3>(1.0, length, level), &iceberg);
    add_ice(start, across<3>(0.0, 1.0, 1.0));
    start.rigid.push_back({.size = iceberg.high - iceberg.low,
                           .center = 0.5 * (iceberg.low + iceberg.high),
                           .density = rigid_density});
    return start;
}

// What the names of water's cases choose.
template <int D>
mpm::Start<D> make_water(std::string_view name, long particles) {
    mpm::Start<D> start = make_water<D>(particles);
    if (name.starts_with("plain")) start.parameters.water.scheme = mpm::WaterScheme::paper;
    if (name.starts_with("restored")) start.parameters.transfer = mpm::Transfer::restored;
    return start;
}

bool is_water(std::string_view name) {
    return name.starts_with("water") || name.starts_with("plain") || name.starts_with("restored");
}

constexpr std::array<Case, 11> all_cases{{{"water2d", 2, "water"},
                                          {"water3d", 3, "water"},
                                          {"plain2d", 2, "water"},
                                          {"plain3d", 3, "water"},
                                          {"restored2d", 2, "water"},
                                          {"restored3d", 3, "water"},
                                          {"ice2d", 2, "ice"},
                                          {"ice3d", 3, "ice"},
                                          {"elastic2d", 2, "ice"},
                                          {"elastic3d", 3, "ice"},
                                          {"mixed3d", 3, "water+ice+rigid"}}};

}  // namespace

std::span<const Case> cases() { return all_cases; }

template <>
mpm::Start<2> make_scene<2>(std::string_view name, long particles) {
    if (is_water(name)) return make_water<2>(name, particles);
    return make_ice<2>(particles, name == "ice2d");
}

template <>
mpm::Start<3> make_scene<3>(std::string_view name, long particles) {
    if (name == "mixed3d") return make_mixed(particles);
    if (is_water(name)) return make_water<3>(name, particles);
    return make_ice<3>(particles, name == "ice3d");
}

}  // namespace tidewater::benchmark
