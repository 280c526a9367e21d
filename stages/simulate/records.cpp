#include "records.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>
#include <set>

#include "common/tank.h"
#include "core/error.h"
#include "io/snapshot.h"
#include "io/text.h"
#include "mpm/bodies/lift.h"
#include "mpm/particles/motion.h"
#include "mpm/readings/pressure.h"
#include "mpm/readings/principal_stress.h"

namespace tidewater {
namespace {

std::vector<std::string> gauge_columns(const scene::Points& gauges) {
    std::vector<std::string> columns{"time"};
    for (const auto& gauge : gauges) columns.push_back(io::place_name(gauge_name(gauge)));
    return columns;
}

std::vector<std::string> pressure_columns(const scene::Points& gauges) {
    std::vector<std::string> columns{"time"};
    for (const auto& at : gauges) {
        io::NamedPlace place{.x = at.front(), .z = at.back()};
        if (at.size() == 3) place.y = at[1];
        columns.push_back(io::place_name(place));
    }
    return columns;
}

template <int D>
std::vector<Vector<D, double>> pressure_points(const scene::Points& gauges) {
    std::vector<Vector<D, double>> points;
    for (const auto& at : gauges) points.push_back(Eigen::Map<const Vector<D, double>>(at.data()));
    return points;
}

template <int D>
std::vector<std::string> ledger_columns() {
    const std::vector<std::string> axes =
        D == 2 ? std::vector<std::string>{"x", "z"} : std::vector<std::string>{"x", "y", "z"};
    std::vector<std::string> columns{"time", "step", "mass"};
    for (const auto& axis : axes) columns.push_back("momentum_" + axis);
    for (const auto& axis : axes) columns.push_back("wall_impulse_" + axis);
    columns.insert(columns.end(), {"gravity_impulse_z", "kinetic", "gravitational", "elastic",
                                   "boundary_work", "friction_work", "drag_work", "outflow_mass"});
    for (const auto& axis : axes) columns.push_back("outflow_momentum_" + axis);
    columns.insert(columns.end(), {"outflow_energy", "energy"});
    return columns;
}

// momentum + outflow − walls' impulse − gravity's impulse of a row of the ledger: it stays what it was.
template <int D>
Vector<D, double> momentum_balance(const std::vector<double>& row) {
    constexpr std::size_t momentum = 3, walls = momentum + D, gravity = walls + D, outflow = gravity + 8;
    using Vec = Eigen::Map<const Vector<D, double>>;
    Vector<D, double> balance = Vec(&row[momentum]) + Vec(&row[outflow]) - Vec(&row[walls]);
    balance[D - 1] -= row[gravity];
    return balance;
}

// Writes (x, y, z), y = 0 in 2D.
template <int D, class Real>
void lift(const Vector<D, Real>& v, float* to) {
    to[0] = static_cast<float>(v[0]);
    to[1] = D == 3 ? static_cast<float>(v[1]) : 0.0f;
    to[2] = static_cast<float>(v[D - 1]);
}

void remove_file(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::remove(path, error);
    if (!error) return;
    throw OutputError(path.string() + ": cannot be removed: " + error.message() + "; remove it by hand");
}

// Removes what simulate writes, whole or as a part, but for the files with these names.
void remove_all_but(const std::filesystem::path& folder, const std::set<std::string>& kept) {
    const std::regex ours(
        R"((frame_\d+\.hdf|frame\.hdf\.series|gauges\.csv|pressures\.csv|bodies\.csv|ledger\.csv|checkpoint\.h5|run\.json|log)(\.part)?)");
    std::vector<std::filesystem::path> old;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (std::regex_match(name, ours) && !kept.contains(name)) old.push_back(entry.path());
    }
    // First what says that the run is whole, then what says that it can go on: a process that is killed in
    // between leaves neither without the rest.
    const auto last = std::partition(old.begin(), old.end(),
                                     [](const auto& path) { return path.filename() == "ledger.csv"; });
    std::partition(last, old.end(), [](const auto& path) { return path.filename() == "checkpoint.h5"; });
    for (const auto& path : old) remove_file(path);
}

}  // namespace

void remove_old_records(const std::filesystem::path& folder) { remove_all_but(folder, {}); }

void remove_later_records(const std::filesystem::path& folder, std::size_t frames) {
    std::set<std::string> kept{"checkpoint.h5", "log", "log.part"};
    for (std::size_t frame = 0; frame < frames; ++frame) kept.insert(io::snapshot_name(frame));
    remove_all_but(folder, kept);
}

template <int D, class Real>
Records<D, Real>::Records(const scene::Scene& scene, const Ground& ground,
                          const std::filesystem::path& folder, const Provenance& provenance)
    : folder_(folder),
      provenance_(provenance),
      instruments_{.tank = make_tank(scene),
                   .gauges = gauge_places(scene.simulate.gauges, scene, ground),
                   .sensors = pressure_points<D>(scene.simulate.pressure_gauges)},
      gravity_(scene.domain.gravity),
      gauges_(folder / "gauges.csv", provenance, gauge_columns(scene.simulate.gauges)),
      ledger_(folder / "ledger.csv", provenance, ledger_columns<D>()),
      spacing_(scene.domain.cell_size / scene.particles.per_axis) {
    if (!instruments_.sensors.empty()) {
        pressures_.emplace(folder / "pressures.csv", provenance,
                           pressure_columns(scene.simulate.pressure_gauges));
    }
    if (scene.has("rigid")) bodies_.emplace(folder / "bodies.csv", provenance, D);
}

// Appends points that stand for a rigid body; their numbers count down from the greatest, which no particle
// has, so that they stay when particles leave. `number` is the next one.
template <int D>
void append_body(const mpm::RigidBody& body, double cell_size, double spacing, std::uint32_t& number,
                 io::Snapshot& snapshot) {
    const auto points = mpm::points_within<D>(body, cell_size, spacing);
    const double volume = 1.0 / static_cast<double>(points.size());
    Vector<D, double> size = 2.0 * mpm::drop<D>(body.half_size);
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    const bool fractures = !snapshot.damage.empty(), has_ice = !snapshot.principal_stress.empty();
    for (const auto& point : points) {
        const Eigen::Vector3d arm = mpm::lift<D>(point) - body.center_in_box(cell_size);
        snapshot.id.push_back(number--);
        snapshot.points.resize(snapshot.points.size() + 3);
        lift<D>(point, &snapshot.points.back() - 2);
        snapshot.velocity.resize(snapshot.velocity.size() + 3);
        lift<D>(mpm::drop<D>(body.velocity_at(arm)), &snapshot.velocity.back() - 2);
        snapshot.pressure.push_back(0.0f);
        snapshot.volume.push_back(static_cast<float>(volume * size.prod()));
        snapshot.material.push_back(static_cast<std::uint8_t>(Material::rigid));
        if (has_ice) snapshot.principal_stress.push_back(none);
        if (fractures) {
            snapshot.damage.push_back(0.0f);
            snapshot.alpha.push_back(none);
            snapshot.failure_time.push_back(none);
        }
    }
}

// Appends what is known of a body's failure; NaN where there is nothing to know, as snapshots have it.
template <int D, class Real>
void append_failure(const mpm::IceModel& ice, const mpm::Particles<D, Real>& particles,
                    io::Snapshot& snapshot) {
    const double limit = ice.hardening * std::abs(ice.initial_alpha(D)), whole = std::sinh(limit);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        float damage = 0.0f, alpha = std::numeric_limits<float>::quiet_NaN(), failed = alpha;
        if (!particles.alpha.empty()) {
            alpha = static_cast<float>(particles.alpha[p]);
            const double angle = ice.hardening * std::max(-static_cast<double>(particles.alpha[p]), 0.0);
            if (angle < limit) damage = static_cast<float>(1.0 - std::sinh(angle) / whole);
            if (std::isfinite(particles.failure_time[p]))
                failed = static_cast<float>(particles.failure_time[p]);
        }
        snapshot.damage.push_back(damage);
        snapshot.alpha.push_back(alpha);
        snapshot.failure_time.push_back(failed);
    }
}

// Appends the body's stress; NaN for what is no ice.
template <int D, class Real>
void append_stress(const mpm::IceModel& ice, const mpm::Particles<D, Real>& particles,
                   io::Snapshot& snapshot) {
    const auto stress = mpm::principal_stress(ice, particles);
    auto& all = snapshot.principal_stress;
    all.insert(all.end(), stress.begin(), stress.end());
    all.resize(snapshot.id.size(), std::numeric_limits<float>::quiet_NaN());
}

template <int D, class Real>
void Records<D, Real>::write_frame(const mpm::Simulation<D, Real>& s) {
    io::Snapshot snapshot;
    snapshot.dimension = D;
    snapshot.time = s.time;
    const auto pressure = mpm::grid_pressure(s);
    const bool has_ice = std::ranges::any_of(
        s.bodies, [](const auto& particles) { return particles.material == Material::ice; });
    for (std::size_t body = 0; body < s.bodies.size(); ++body) {
        const auto& particles = s.bodies[body];
        snapshot.pressure.insert(snapshot.pressure.end(), pressure[body].begin(), pressure[body].end());
        snapshot.id.insert(snapshot.id.end(), particles.id.begin(), particles.id.end());
        snapshot.material.insert(snapshot.material.end(), particles.size(),
                                 static_cast<std::uint8_t>(particles.material));
        snapshot.volume.insert(snapshot.volume.end(), particles.size(), static_cast<float>(particles.volume));
        if (has_ice) append_stress<D>(s.parameters.ice, particles, snapshot);
        if (s.parameters.ice.fracture) append_failure<D>(s.parameters.ice, particles, snapshot);
        const std::size_t first = snapshot.points.size();
        snapshot.points.resize(first + 3 * particles.size(), 0.0f);
        snapshot.velocity.resize(first + 3 * particles.size(), 0.0f);
        mpm::for_each_motion(s.grid, particles,
                             [&](std::size_t, const mpm::Index<D>& block, std::size_t p,
                                 const Vector<D, Real>& velocity, const Matrix<D, Real>&) {
                                 const auto point = mpm::global_position(s.grid.layout, block, particles, p);
                                 lift<D>(point, snapshot.points.data() + first + 3 * p);
                                 lift<D>(velocity, snapshot.velocity.data() + first + 3 * p);
                             });
    }
    auto number = std::numeric_limits<std::uint32_t>::max();
    for (const mpm::RigidBody& body : s.rigid) {
        append_body<D>(body, s.grid.layout.cell_size, spacing_, number, snapshot);
    }
    io::write_snapshot(folder_ / io::snapshot_name(frame_times_.size()), snapshot, provenance_);
    frame_times_.push_back(s.time);
    io::write_series(folder_, frame_times_);
}

template <int D, class Real>
void Records<D, Real>::append_row(const Reading<D>& reading) {
    std::vector<double> row{reading.time};
    row.insert(row.end(), reading.surface.begin(), reading.surface.end());
    gauges_.append(row);
    if (pressures_) {
        row = {reading.time};
        row.insert(row.end(), reading.pressure.begin(), reading.pressure.end());
        pressures_->append(row);
    }
    if (bodies_) bodies_->append(D, gravity_, reading.time, reading.bodies);

    const mpm::Ledger<D>& ledger = reading.ledger;
    const mpm::Accounts<D>& accounts = reading.accounts;
    const mpm::Outflow<D>& outflow = accounts.outflow;
    const double energy = ledger.kinetic + ledger.gravitational + ledger.elastic + outflow.energy() -
                          accounts.boundary_work - accounts.friction_work - accounts.drag_work;
    if (first_row_) start_energy_ = highest_energy_ = energy;
    highest_energy_ = std::max(highest_energy_, energy);

    row = {reading.time, static_cast<double>(reading.step), ledger.mass};
    row.insert(row.end(), ledger.momentum.begin(), ledger.momentum.end());
    row.insert(row.end(), accounts.wall_impulse.begin(), accounts.wall_impulse.end());
    row.insert(row.end(), {accounts.gravity_impulse, ledger.kinetic, ledger.gravitational, ledger.elastic,
                           accounts.boundary_work, accounts.friction_work, accounts.drag_work, outflow.mass});
    row.insert(row.end(), outflow.momentum.begin(), outflow.momentum.end());
    row.insert(row.end(), {outflow.energy(), energy});
    ledger_.append(row);
    if (first_row_) first_ledger_row_ = row;
    last_ledger_row_ = row;
    first_row_ = false;
}

template <int D, class Real>
io::RunFacts::Ledger Records<D, Real>::ledger_facts() const {
    io::RunFacts::Ledger facts;
    if (last_ledger_row_.empty()) return facts;
    facts.energy_rise = highest_energy_ - start_energy_;
    const std::vector<std::string> columns = ledger_columns<D>();
    for (std::size_t c = 0; c < columns.size(); ++c) {
        facts.last.emplace_back(columns[c], last_ledger_row_[c]);
        if (!first_ledger_row_.empty()) facts.first.emplace_back(columns[c], first_ledger_row_[c]);
    }
    if (!first_ledger_row_.empty())
        facts.momentum_open =
            (momentum_balance<D>(last_ledger_row_) - momentum_balance<D>(first_ledger_row_)).norm();
    return facts;
}

template <int D, class Real>
void Records<D, Real>::store(RunState& run) {
    run.frame_times = frame_times_;
    run.gauges = gauges_.text();
    if (pressures_) run.pressures = pressures_->text();
    if (bodies_) {
        run.bodies = bodies_->table().text();
        run.last_bodies = bodies_->last;
    }
    run.ledger = ledger_.text();
    run.start_energy = start_energy_;
    run.highest_energy = highest_energy_;
    run.tally.first_ledger_row = first_ledger_row_;
    run.tally.last_ledger_row = last_ledger_row_;
}

template <int D, class Real>
void Records<D, Real>::resume(const RunState& run) {
    frame_times_ = run.frame_times;
    gauges_.resume(run.gauges);
    if (pressures_) pressures_->resume(run.pressures);
    if (bodies_) {
        bodies_->table().resume(run.bodies);
        bodies_->last = run.last_bodies;
    }
    ledger_.resume(run.ledger);
    start_energy_ = run.start_energy;
    highest_energy_ = run.highest_energy;
    first_ledger_row_ = run.tally.first_ledger_row;
    last_ledger_row_ = run.tally.last_ledger_row;
    first_row_ = false;
    io::write_series(folder_, frame_times_);
}

template <int D, class Real>
void Records<D, Real>::keep_parts() {
    gauges_.keep_part();
    if (pressures_) pressures_->keep_part();
    if (bodies_) bodies_->table().keep_part();
    ledger_.keep_part();
}

template <int D, class Real>
void Records<D, Real>::finish() {
    gauges_.finish();
    if (pressures_) pressures_->finish();
    if (bodies_) bodies_->table().finish();
    ledger_.finish();
}

template class Records<2, float>;
template class Records<2, double>;
template class Records<3, float>;
template class Records<3, double>;

}  // namespace tidewater
