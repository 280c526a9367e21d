#include "readings.h"

#include <algorithm>
#include <cmath>

#include "mpm/readings/sensor.h"

namespace tidewater {
namespace {

// Whether a block, with what may have drifted out of it, reaches the columns that a gauge reads.
template <int D>
bool near_place(const mpm::Layout<D>& layout, const mpm::Index<D>& block, const analysis::Place& place) {
    for (int axis = 0; axis < D - 1; ++axis) {
        const double at = (axis == 0 ? place.x : place.y) / layout.cell_size;
        const double first = layout.first_node(block[static_cast<std::size_t>(axis)]);
        const double reach = analysis::surface_reach + 1.0;
        if (at < first - reach || at > first + mpm::Block<D>::width + reach) return false;
    }
    return true;
}

template <int D, class Real>
std::vector<double> surface_at_gauges(const mpm::Simulation<D, Real>& s, const Instruments<D>& instruments) {
    if (instruments.gauges.empty()) return {};
    std::vector<float> points, volume;
    for (const auto& particles : s.bodies) {
        if (particles.material != Material::water) continue;
        for (std::size_t slot = 0; slot + 1 < particles.begin.size(); ++slot) {
            const auto block = mpm::block_at<D>(s.grid.particle_blocks[slot]);
            const auto reaches = [&](const analysis::Place& place) {
                return near_place<D>(s.grid.layout, block, place);
            };
            if (std::none_of(instruments.gauges.begin(), instruments.gauges.end(), reaches)) continue;
            for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
                const auto point = mpm::global_position(s.grid.layout, block, particles, p);
                points.push_back(static_cast<float>(point[0]));
                points.push_back(D == 3 ? static_cast<float>(point[1]) : 0.0f);
                points.push_back(static_cast<float>(point[D - 1]));
                volume.push_back(static_cast<float>(particles.volume));
            }
        }
    }
    return analysis::surface_elevation({.points = points, .volume = volume, .material = {}}, instruments.tank,
                                       instruments.gauges);
}

BodyReading read_body(const mpm::RigidBody& body, double cell_size) {
    return {.center = body.center_in_box(cell_size),
            .rotation = body.rotation,
            .velocity = body.velocity,
            .angular_velocity = body.angular_velocity,
            .water_impulse = body.water_impulse,
            .water_angular_impulse = body.water_angular_impulse,
            .contact_impulse = body.contact_impulse,
            .fastest = max_speed(body),
            .kinetic = kinetic_energy(body),
            .mass = body.mass};
}

// (1 − share) a + share b: exactly a and b at the ends.
template <class T>
T mixed(const T& a, const T& b, double share) {
    return (1.0 - share) * a + share * b;
}

std::vector<double> mixed(const std::vector<double>& a, const std::vector<double>& b, double share) {
    std::vector<double> values(a.size());
    for (std::size_t n = 0; n < values.size(); ++n) {
        values[n] = mixed(a[n], b[n], share);
        if (std::isnan(a[n]) || std::isnan(b[n])) values[n] = share < 0.5 ? a[n] : b[n];
    }
    return values;
}

BodyReading mixed(const BodyReading& a, const BodyReading& b, double place, double motion) {
    return {.center = mixed(a.center, b.center, place),
            .rotation = a.rotation.slerp(place, b.rotation),
            .velocity = mixed(a.velocity, b.velocity, motion),
            .angular_velocity = mixed(a.angular_velocity, b.angular_velocity, motion),
            .water_impulse = mixed(a.water_impulse, b.water_impulse, motion),
            .water_angular_impulse = mixed(a.water_angular_impulse, b.water_angular_impulse, motion),
            .contact_impulse = mixed(a.contact_impulse, b.contact_impulse, motion),
            .fastest = mixed(a.fastest, b.fastest, motion),
            .kinetic = mixed(a.kinetic, b.kinetic, motion),
            .mass = b.mass};
}

template <int D>
mpm::Ledger<D> mixed(const mpm::Ledger<D>& a, const mpm::Ledger<D>& b, double place, double motion) {
    mpm::Ledger<D> ledger;
    ledger.mass = mixed(a.mass, b.mass, place);
    ledger.momentum = mixed(a.momentum, b.momentum, motion);
    ledger.kinetic = mixed(a.kinetic, b.kinetic, motion);
    ledger.gravitational = mixed(a.gravitational, b.gravitational, place);
    ledger.elastic = mixed(a.elastic, b.elastic, place);
    return ledger;
}

template <int D>
mpm::Accounts<D> mixed(const mpm::Accounts<D>& a, const mpm::Accounts<D>& b, double place, double motion) {
    mpm::Accounts<D> accounts;
    accounts.wall_impulse = mixed(a.wall_impulse, b.wall_impulse, motion);
    accounts.gravity_impulse = mixed(a.gravity_impulse, b.gravity_impulse, motion);
    accounts.boundary_work = mixed(a.boundary_work, b.boundary_work, motion);
    accounts.friction_work = mixed(a.friction_work, b.friction_work, motion);
    accounts.drag_work = mixed(a.drag_work, b.drag_work, motion);
    accounts.outflow.mass = mixed(a.outflow.mass, b.outflow.mass, place);
    accounts.outflow.momentum = mixed(a.outflow.momentum, b.outflow.momentum, motion);
    accounts.outflow.kinetic = mixed(a.outflow.kinetic, b.outflow.kinetic, motion);
    accounts.outflow.potential = mixed(a.outflow.potential, b.outflow.potential, place);
    return accounts;
}

}  // namespace

template <int D, class Real>
Reading<D> read_state(const mpm::Simulation<D, Real>& s, const Instruments<D>& instruments) {
    Reading<D> reading{.time = s.time,
                       .motion_time = s.motion_time(),
                       .step = s.step,
                       .surface = surface_at_gauges(s, instruments),
                       .pressure = mpm::pressure_at<D, Real>(s, instruments.sensors),
                       .bodies = {},
                       .ledger = mpm::take_ledger(s),
                       .accounts = s.accounts};
    for (const mpm::RigidBody& body : s.rigid)
        reading.bodies.push_back(read_body(body, s.grid.layout.cell_size));
    return reading;
}

template <int D>
Reading<D> reading_between(const Reading<D>& before, const Reading<D>& after, double time) {
    const double place = (time - before.time) / (after.time - before.time);
    const double motion = (time - before.motion_time) / (after.motion_time - before.motion_time);
    Reading<D> reading{.time = time,
                       .motion_time = time,
                       .step = time < after.time ? before.step : after.step,
                       .surface = mixed(before.surface, after.surface, place),
                       .pressure = mixed(before.pressure, after.pressure, place),
                       .bodies = {},
                       .ledger = mixed(before.ledger, after.ledger, place, motion),
                       .accounts = mixed(before.accounts, after.accounts, place, motion)};
    for (std::size_t n = 0; n < after.bodies.size(); ++n)
        reading.bodies.push_back(mixed(before.bodies[n], after.bodies[n], place, motion));
    return reading;
}

#define TIDEWATER_INSTANTIATE(D)                                                              \
    template Reading<D> read_state(const mpm::Simulation<D, float>&, const Instruments<D>&);  \
    template Reading<D> read_state(const mpm::Simulation<D, double>&, const Instruments<D>&); \
    template Reading<D> reading_between(const Reading<D>&, const Reading<D>&, double);
TIDEWATER_INSTANTIATE(2)
TIDEWATER_INSTANTIATE(3)

}  // namespace tidewater
