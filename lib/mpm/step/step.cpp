#include "mpm/step/step.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "mpm/base/instantiate.h"
#include "mpm/step/blocks.h"
#include "mpm/step/contact.h"
#include "mpm/step/failures.h"
#include "mpm/step/matter.h"
#include "mpm/step/nodes.h"
#include "mpm/step/pass.h"
#include "mpm/step/restore.h"
#include "mpm/step/slow_columns.h"
#include "mpm/step/soften.h"
#include "mpm/step/sort.h"

namespace tidewater::mpm {
namespace {

// Charges the wall time since the last call to a phase.
class PhaseClock {
public:
    explicit PhaseClock(PhaseSeconds& seconds) : seconds_(seconds) {}
    void charge(Phase phase) {
        const auto now = Clock::now();
        seconds_[static_cast<std::size_t>(phase)] += std::chrono::duration<double>(now - last_).count();
        last_ = now;
    }

private:
    using Clock = std::chrono::steady_clock;
    PhaseSeconds& seconds_;
    Clock::time_point last_ = Clock::now();
};

// Books what the boundaries did, block by block in order, and returns max. |v| of each block of nodes, m/s.
// Throws NumericsError if a velocity is not finite.
template <int D, class Real>
std::vector<double> book_boundaries(const Interval& interval, const Simulation<D, Real>& s,
                                    const std::vector<NodeResult<D>>& results, const Slots& slots,
                                    Accounts<D>& accounts) {
    std::vector<double> node_speed(s.grid.node_blocks.size(), 0.0);
    for (std::size_t n = 0; n < results.size(); ++n) {
        if (!std::isfinite(results[n].max_speed2))
            fail_at_bad_node(interval, s.parameters, s.grid, s.bodies, slots[n]);
        node_speed[slots[n]] = std::sqrt(results[n].max_speed2);
        accounts.wall_impulse += results[n].action.impulse;
        accounts.boundary_work += results[n].action.work;
        accounts.friction_work += results[n].action.friction_work;
        accounts.drag_work += results[n].action.drag_work;
    }
    return node_speed;
}

// Adds gravity's impulse (kg m/s) on particles and rigid bodies over dt (s).
template <int D, class Real>
void book_gravity(const Simulation<D, Real>& s, double dt, double& gravity_impulse) {
    for (const auto& particles : s.bodies) {
        gravity_impulse -= particles.mass * static_cast<double>(particles.size()) * s.parameters.gravity * dt;
    }
    for (const RigidBody& body : s.rigid) gravity_impulse -= body.mass * s.parameters.gravity * dt;
}

}  // namespace

template <int D, class Real>
void advance(Simulation<D, Real>& s, double next_dt) {
    const Interval interval = s.interval(next_dt);
    const Boundaries<D>& boundaries = s.parameters.boundaries;
    Vector<D, double>& wall_impulse = s.accounts.wall_impulse;
    PhaseClock clock(s.seconds);

    sort_if_needed(interval, s.parameters, s.near_speed, s.grid, s.rigid, s.bodies, s.unknown_fill, s.drift,
                   s.skimming, s.accounts.outflow);
    clock.charge(Phase::sort);

    // With several rates, only the blocks that are due would be listed here.
    const StepBlocks blocks = all_blocks(s.grid);
    PassFindings findings = pass_over_blocks(interval, s.parameters, blocks.particles, s.rigid,
                                             s.unknown_fill, s.grid, s.bodies, s.drift, wall_impulse);
    s.speeds.sound = fastest_sound(s.parameters, s.bodies, findings.all).sound;
    soften_signals(s.parameters, s.grid, s.bodies, findings.of_block);
    if (!interval.settling) {
        for (RigidBody& body : s.rigid) move_rigid_body(interval.dt, body);  // the pass reads the old place
    }
    clock.charge(Phase::pass);

    // With several machines, the tiles of the neighbours' particles would arrive here, in the places that the
    // grid has for them.

    const double force_dt = interval.force_dt();
    const auto kick = static_cast<Real>(-s.parameters.gravity * force_dt);
    BoundaryStep step = boundary_step(boundaries, interval, force_dt);
    const NodeMatter<Real> matter = find_matter(boundaries, step, blocks.nodes, s.bodies, s.grid);
    const bool twice = s.parameters.transfer == Transfer::restored;
    std::vector<float> grip;
    if (twice && rubs(boundaries)) grip.resize(s.grid.nodes.size());
    std::vector<NodeResult<D>> results(blocks.nodes.size());
    std::vector<double> node_speed;  // [node block] m/s
    const auto bound = [&](const ActingBoundaries<D>& by, std::size_t n) {
        results[n] = bound_velocities<D, Real>(by, matter, blocks.nodes[n], grip, s.grid);
    };
    const auto bound_all = [&] {
        const auto acting = acting_boundaries(s.grid.layout, boundaries, step);
        parallel_for(blocks.nodes.size(), [&](std::size_t n) { bound(acting, n); });
        node_speed = book_boundaries(interval, s, results, blocks.nodes, s.accounts);
    };
    ContactStep contact{.dt = next_dt,
                        .force_dt = force_dt,
                        .gravity = s.parameters.gravity,
                        .water_density = s.parameters.water.density,
                        .held = interval.settling};
    const bool stages_apart = !s.rigid.empty() || boundaries.drag.exists();
    if (!stages_apart) {  // both stages run on a block while it is in the cache
        const auto acting = acting_boundaries(s.grid.layout, boundaries, step);
        parallel_for(blocks.nodes.size(), [&](std::size_t n) {
            sum_momenta(kick, blocks.nodes[n], s.grid);
            bound(acting, n);
        });
        node_speed = book_boundaries(interval, s, results, blocks.nodes, s.accounts);
    } else {
        for_each_slot(blocks.nodes, [&](std::size_t slot) { sum_momenta(kick, slot, s.grid); });
        clock.charge(Phase::grid);
        resolve_contacts(contact, boundaries, s.grid, s.rigid, s.accounts);
        clock.charge(Phase::rigid);
        std::vector<double> slowing;
        if (boundaries.drag.exists())
            slowing = slow_columns(s.parameters, step, blocks.nodes, matter, s.grid);
        step.slowing = slowing;
        bound_all();
    }

    s.grid.linked_anew = false;
    if (twice) {
        restore_velocities(s.bodies, s.grid, wall_impulse);
        contact.force_dt = 0.0;  // the bodies have got it already
        resolve_contacts(contact, boundaries, s.grid, s.rigid, s.accounts);
        step.dt = 0.0;  // and so has all that works by rates
        step.slowing = {};
        bound_all();
    }

    add_unfolding_impulse(blocks.particles, s.grid, wall_impulse);
    book_gravity(s, force_dt, s.accounts.gravity_impulse);
    s.speeds.particle = 0.0;
    for (const double speed : node_speed) s.speeds.particle = std::max(s.speeds.particle, speed);
    for (const RigidBody& body : s.rigid) s.speeds.particle = std::max(s.speeds.particle, max_speed(body));
    s.speeds.signal = find_signal(s.grid, node_speed, findings.of_block, s.rigid, s.near_speed);
    clock.charge(Phase::grid);

    s.time += s.dt;
    s.dt = next_dt;
    ++s.step;
}

#define TIDEWATER_INSTANTIATE(D, Real) template void advance(Simulation<D, Real>&, double);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
