#include "mpm/materials/single_point.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "mpm/base/instantiate.h"
#include "mpm/materials/ice_lane.h"
#include "mpm/materials/ice_yield.h"

namespace tidewater::mpm {
namespace {

// A model with the constants that the kernels use.
template <int D, class Real>
struct Law {
    const IceModel& model;
    IceConstants<D, Real> constants;
    double kappa = model.bulk_modulus(D);

    explicit Law(const IceModel& of) : model(of), constants(of) {}

    double p0(Real alpha) const {
        const Real angle = std::min(constants.xi * std::max(-alpha, Real(0)), constants.max_angle);
        return kappa * std::sinh(static_cast<double>(angle));
    }
};

// The column of the principal value along `axis`.
template <int D>
std::size_t diagonal(int axis) {
    return static_cast<std::size_t>(ice_lane::column<D>(axis, axis));
}

template <int D>
double pressure(const std::array<double, D>& stress) {
    return 0.0 - std::accumulate(stress.begin(), stress.end(), 0.0) / D;  // never −0
}

template <int D>
double equivalent_shear(const std::array<double, D>& stress) {
    const double p = pressure<D>(stress);
    double norm2 = 0.0;
    for (const double tau : stress) norm2 += (tau + p) * (tau + p);
    return std::sqrt(0.5 * (6 - D) * norm2);
}

template <int D, class Real>
double energy(const Law<D, Real>& law, const std::array<Real, D>& strain) {
    std::array<double, symmetric_size<D>> full{};
    for (int i = 0; i < D; ++i)
        full[diagonal<D>(i)] = static_cast<double>(strain[static_cast<std::size_t>(i)]);
    return ice_energy<D>(law.model, full);
}

template <int D, class Real>
YieldCase applied_case(const Law<D, Real>& law, Real old_alpha, const std::array<Real, D>& trial,
                       const std::array<Real, D>& mapped) {
    if (trial == mapped) return YieldCase::elastic;
    const double p0 = law.p0(old_alpha), beta = law.model.beta;
    if (p0 == 0.0) return YieldCase::failed;
    double log_j2 = 0.0;
    for (const Real strain : trial) log_j2 += std::log1p(static_cast<double>(strain));
    const double p = -0.5 * law.kappa * std::expm1(log_j2);
    if (p > p0) return YieldCase::compressive_tip;
    if (p < -beta * p0) return YieldCase::tensile_tip;
    return p > 0.5 * (1 - beta) * p0 ? YieldCase::hardening : YieldCase::softening;
}

// Advances all but the energies of a point. The kernels work on whole rows of lanes: the point is lane 0, and
// the other lanes stay at rest.
template <int D, class Real>
void apply_kernels(const Law<D, Real>& law, const std::array<double, D>& log_stretch,
                   IcePoint<D, Real>& point) {
    Column<Real> increment[D * D] = {}, strain[symmetric_size<D>] = {}, alpha = {},
                               stress[symmetric_size<D>] = {};
    for (int i = 0; i < D; ++i) {
        const auto axis = static_cast<std::size_t>(i);
        increment[i * D + i][0] = static_cast<Real>(std::expm1(log_stretch[axis]));
        strain[diagonal<D>(i)][0] = point.strain[axis];
    }
    alpha[0] = point.alpha;
    advance_strain<D, Real>(increment, lanes, strain);
    std::array<Real, D> trial;
    for (int i = 0; i < D; ++i) trial[static_cast<std::size_t>(i)] = strain[diagonal<D>(i)][0];

    return_to_yield<D, Real>(law.constants, lanes, strain, &alpha, stress);
    for (int i = 0; i < D; ++i) {
        const auto axis = static_cast<std::size_t>(i);
        point.strain[axis] = strain[diagonal<D>(i)][0];
        point.stress[axis] = static_cast<double>(stress[diagonal<D>(i)][0]);
        point.log_volume += log_stretch[axis];
    }
    point.applied = applied_case<D, Real>(law, point.alpha, trial, point.strain);
    point.alpha = alpha[0];
}

template <int D, class Real>
void advance_point(const Law<D, Real>& law, const std::array<double, D>& log_stretch,
                   IcePoint<D, Real>& point) {
    const IcePoint<D, Real> before = point;
    apply_kernels<D, Real>(law, log_stretch, point);
    double work = 0.0;
    for (std::size_t i = 0; i < D; ++i) work += 0.5 * (before.stress[i] + point.stress[i]) * log_stretch[i];
    point.work += work;
    // Elastic steps dissipate nothing; their difference is rounding.
    if (point.applied != YieldCase::elastic)
        point.dissipated += work - (energy<D, Real>(law, point.strain) - energy<D, Real>(law, before.strain));
}

// The logarithmic stretches of a step by `h`. `x` is the unknown increment, used if has_unknown.
template <int D>
std::array<double, D> increments(LoadPath path, double h, double x) {
    std::array<double, D> log_stretch{};
    if (path == LoadPath::isotropic) {
        log_stretch.fill(h / D);
    } else if (path == LoadPath::shear) {
        log_stretch.fill(x / D);
        log_stretch[0] += 0.5 * h;
        log_stretch[D - 1] -= 0.5 * h;
    } else {
        log_stretch.fill(x);
        log_stretch[0] = h;
    }
    return log_stretch;
}

// Whether a stress is prescribed, so that an increment must be found.
bool has_unknown(const Loading& loading) {
    return loading.path == LoadPath::uniaxial || (loading.path == LoadPath::shear && loading.held_pressure);
}

// The function of the unknown increment whose root is wanted; it increases with the increment.
template <int D, class Real>
double excess(const Loading& loading, const IcePoint<D, Real>& point) {
    if (loading.path == LoadPath::uniaxial) return point.stress[D - 1];
    return *loading.held_pressure - pressure<D>(point.stress);
}

// The root of an increasing f, by alternating false position (fast where f is nearly linear) and bisection
// (always converges). Returns 0 if f(0) = 0, and −reach if f has the same sign up to `limit` on both sides.
template <class Function>
double root(const Function& f, double reach, double limit) {
    if (f(0.0) == 0.0) return 0.0;
    double high = reach, at_high = f(high), low = -reach, at_low = f(low);
    while (at_low > 0.0 || at_high < 0.0) {
        if (high > limit) return -reach;
        high *= 2, low *= 2;
        at_high = f(high), at_low = f(low);
    }
    for (int n = 0; n < 100 && high - low > 1e-9 * reach; ++n) {
        const bool bisect = n % 2 == 1 || at_high == at_low;
        const double x = bisect ? 0.5 * (low + high) : low - at_low * (high - low) / (at_high - at_low);
        const double at = f(x);
        if (at == 0.0) return x;
        (at < 0.0 ? low : high) = x;
        (at < 0.0 ? at_low : at_high) = at;
    }
    return -at_low < at_high ? low : high;
}

template <int D, class Real>
double find_unknown(const Law<D, Real>& law, const Loading& loading, double h,
                    const IcePoint<D, Real>& point) {
    const auto excess_of = [&](double x) {
        IcePoint<D, Real> tried = point;
        apply_kernels<D, Real>(law, increments<D>(loading.path, h, x), tried);
        return excess(loading, tried);
    };
    // The bracket may grow until it spans the whole yield surface and the held pressure several times.
    const double pressures = 4 * (law.p0(point.alpha) + std::abs(loading.held_pressure.value_or(0.0)));
    return root(excess_of, std::abs(h), 1024 * std::abs(h) + pressures / law.kappa);
}

template <int D, class Real>
PointRow row_of(const Law<D, Real>& law, const IcePoint<D, Real>& point, int step, double strain) {
    const double p0 = law.p0(point.alpha);
    return {.step = step,
            .strain = strain,
            .log_volume = point.log_volume,
            .pressure = pressure<D>(point.stress),
            .q = equivalent_shear<D>(point.stress),
            .p0 = p0,
            .alpha = static_cast<double>(point.alpha),
            .damage = 1 - p0 / law.p0(static_cast<Real>(law.model.initial_alpha(D))),
            .dissipated = point.dissipated,
            .applied = point.applied};
}

}  // namespace

template <int D, class Real>
IcePoint<D, Real> intact_point(const IceModel& model) {
    IcePoint<D, Real> point;
    point.alpha = static_cast<Real>(model.initial_alpha(D));
    return point;
}

template <int D, class Real>
void stretch_point(const IceModel& model, const std::array<double, D>& log_stretch,
                   IcePoint<D, Real>& point) {
    advance_point<D, Real>(Law<D, Real>(model), log_stretch, point);
}

double strain_at(const Loading& loading, int step) {
    assert(step >= 0 && step <= loading.steps);
    const double share = static_cast<double>(step) / loading.steps;
    if (loading.cycles == 0) return loading.strain * share;
    const double turns = share * loading.cycles, turn = turns - std::floor(turns);
    return loading.strain * (turn <= 0.25 ? 4 * turn : (turn <= 0.75 ? 2 - 4 * turn : 4 * turn - 4));
}

template <int D, class Real>
std::vector<PointRow> drive_point(const IceModel& model, const Loading& loading, IcePoint<D, Real> point) {
    assert(loading.steps >= 1 && loading.cycles >= 0);
    const Law<D, Real> law(model);
    std::vector<PointRow> rows{row_of(law, point, 0, 0.0)};
    rows.reserve(static_cast<std::size_t>(loading.steps) + 1);
    for (int step = 1; step <= loading.steps; ++step) {
        const double strain = strain_at(loading, step), h = strain - rows.back().strain;
        const double x = has_unknown(loading) ? find_unknown(law, loading, h, point) : 0.0;
        advance_point<D, Real>(law, increments<D>(loading.path, h, x), point);
        rows.push_back(row_of(law, point, step, strain));
    }
    return rows;
}

Milestones find_milestones(const std::vector<PointRow>& rows) {
    Milestones found;
    for (const PointRow& row : rows) {
        if (!found.onset && row.applied != YieldCase::elastic) found.onset = row;
        if (!found.max_q || row.q > found.max_q->q) found.max_q = row;
        if (!found.failure && row.alpha >= 0) found.failure = row;
    }
    return found;
}

double tension_onset(const IceModel& model, int dimension) {
    return 0.5 * std::log1p(2 * model.beta_p0 / model.bulk_modulus(dimension));
}

double shear_strength(const IceModel& model) {
    return model.friction * model.beta_p0 / model.beta * std::sqrt(model.beta / (1 + 2 * model.beta));
}

// The equation of uniaxial_strength with −σ for σ.
double uniaxial_crushing_strength(const IceModel& model, int dimension) {
    const double d = dimension, m2 = model.friction * model.friction, p0 = model.beta_p0 / model.beta;
    const double a = 1 + 2 * model.beta + m2 / (d * d), b = m2 * (1 - model.beta) * p0 / d;
    return (b + std::sqrt(b * b + 4 * a * m2 * model.beta_p0 * p0)) / (2 * a);
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                       \
    template IcePoint<D, Real> intact_point<D, Real>(const IceModel&);                                       \
    template void stretch_point<D, Real>(const IceModel&, const std::array<double, D>&, IcePoint<D, Real>&); \
    template std::vector<PointRow> drive_point<D, Real>(const IceModel&, const Loading&, IcePoint<D, Real>);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
