#include "mpm/materials/single_point.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "mpm/materials/ice_yield.h"
#include "unit/mpm/ice_support.h"

using namespace tidewater::mpm;
using namespace tidewater::mpm::ice_support;
using doctest::Approx;

namespace {

using Two = std::integral_constant<int, 2>;
using Three = std::integral_constant<int, 3>;

template <int D, class Real = double>
std::vector<PointRow> drive(const IceModel& model, LoadPath path, double strain, int steps, int cycles = 0) {
    return drive_point<D, Real>(
        model, {.path = path, .strain = strain, .steps = steps, .cycles = cycles, .held_pressure = {}},
        intact_point<D, Real>(model));
}

// Failed, but not opened ice, sheared to γ while the pressure is held.
template <int D>
std::vector<PointRow> shear_failed(const IceModel& model, double pressure, double strain, int steps) {
    IcePoint<D, double> failed = intact_point<D, double>(model);
    failed.alpha = 0.0;
    return drive_point<D, double>(
        model, {.path = LoadPath::shear, .strain = strain, .steps = steps, .held_pressure = pressure},
        failed);
}

IceModel with(double beta, double hardening = 3.0) {
    IceModel model;
    model.beta = beta;
    model.hardening = hardening;
    return model;
}

double p0_at_start(const IceModel& model) { return model.beta_p0 / model.beta; }

// E, or what the plane makes of it: E/(1 − ν²) in a slice, 4μκ/(κ+μ) for any κ.
double uniaxial_modulus(const IceModel& model, int dimension) {
    const double mu = model.shear_modulus(), kappa = model.bulk_modulus(dimension);
    return dimension == 2 ? 4 * mu * kappa / (kappa + mu) : 9 * kappa * mu / (3 * kappa + mu);
}

// Isotropic tension, then pure shear, against the closed forms. A path's rows are so close that one step is
// far less than half a percent.
template <int D, class Real>
void check_table(const IceModel& model) {
    const double onset = tension_onset(model, D), start = -model.initial_alpha(D);
    const double loss = std::max(onset, start);  // at βξ > 1 a snap
    const auto tension = drive<D, Real>(model, LoadPath::isotropic, 1.1 * loss, 10000);
    const double step = tension[1].strain;
    const Milestones pulled = find_milestones(tension);
    REQUIRE((pulled.onset && pulled.failure));
    const double rounding = std::is_same_v<Real, float> ? 2e-3 * onset : 1e-12;
    CHECK(pulled.onset->strain >= onset - rounding);
    CHECK(pulled.onset->strain <= onset + step + rounding);
    CHECK(pulled.failure->strain == Approx(loss).epsilon(5e-3));

    const double strength = shear_strength(model);
    const double gamma = strength / (std::sqrt(D == 3 ? 3.0 : 4.0) * model.shear_modulus());
    const auto shear = drive<D, Real>(model, LoadPath::shear, 1.2 * gamma, 2000);
    const Milestones sheared = find_milestones(shear);
    REQUIRE(sheared.onset);
    CHECK(sheared.onset->strain == Approx(gamma).epsilon(2e-3));
    CHECK(sheared.max_q->q == Approx(strength).epsilon(5e-3));
    CHECK(sheared.onset->log_volume == 0.0);
}

struct Row {
    double beta_p0, beta, xi, friction, alpha0, onset, loss, peak_q, onset_shear;
};
constexpr Row rows_of_table[] = {{0.5e6, 1.0, 3.0, 1.4, -2.0e-4, 6.00e-4, 6.1e-4, 404.15e3, 6.07e-4},
                                 {0.5e6, 0.2, 3.0, 1.4, -1.0e-3, 6.00e-4, 1.00e-3, 1322.9e3, 1.986e-3},
                                 {0.8e6, 1.0, 0.1, 0.13, -9.6e-3, 9.59e-4, 9.60e-3, 60.04e3, 9.01e-5}};

IceModel model_of(const Row& row) {
    IceModel model = with(row.beta, row.xi);
    model.beta_p0 = row.beta_p0;
    model.friction = row.friction;
    return model;
}

template <int D>
double energy_of(const IceModel& model, const Batch<D, double>& batch, int p) {
    std::array<double, symmetric_size<D>> strain{};
    for (std::size_t c = 0; c < strain.size(); ++c) strain[c] = batch.strain[c][p];
    return ice_energy<D>(model, strain);
}

double min_increment_of_dissipation(const std::vector<PointRow>& rows) {
    double smallest = 0.0;
    for (std::size_t i = 1; i < rows.size(); ++i)
        smallest = std::min(smallest, rows[i].dissipated - rows[i - 1].dissipated);
    return smallest;
}

}  // namespace

TEST_CASE("the closed forms give the table of strengths in lib/mpm/README.md") {
    for (const Row& row : rows_of_table) {
        const IceModel model = model_of(row);
        CAPTURE(row.beta);
        CHECK(model.initial_alpha(3) == Approx(row.alpha0).epsilon(5e-3));
        CHECK(tension_onset(model, 3) == Approx(row.onset).epsilon(2e-3));
        // 6.1e-4 has two digits and is that of a longer step.
        CHECK(std::max(tension_onset(model, 3), -model.initial_alpha(3)) == Approx(row.loss).epsilon(2e-2));
        CHECK(shear_strength(model) == Approx(row.peak_q).epsilon(1e-3));
        CHECK(shear_strength(model) / (std::sqrt(3) * model.shear_modulus()) ==
              Approx(row.onset_shear).epsilon(2e-3));
    }
}

TEST_CASE_TEMPLATE("a driven point yields and fails where the closed forms say, in 2D and 3D", Real, float,
                   double) {
    for (const Row& row : rows_of_table)
        for (const Moduli moduli : {Moduli::plane_strain, Moduli::paper}) {
            IceModel model = model_of(row);
            model.moduli = moduli;
            CAPTURE(row.beta);
            CAPTURE(row.xi);
            check_table<2, Real>(model);
            check_table<3, Real>(model);
        }
}

TEST_CASE_TEMPLATE(
    "uniaxial loading has no lateral stress, the modulus and the strengths of the closed forms", Dimension,
    Two, Three) {
    constexpr int D = Dimension::value;
    for (const double beta : {1.0, 0.5, 0.2, 0.1})
        for (const Moduli moduli : {Moduli::plane_strain, Moduli::paper}) {
            IceModel model = with(beta);
            model.moduli = moduli;
            CAPTURE(beta);
            const double modulus = uniaxial_modulus(model, D);
            if (D == 3 || moduli == Moduli::plane_strain)
                CHECK(modulus == Approx(D == 3 ? 1e9 : 1e9 / (1 - 0.3 * 0.3)).epsilon(1e-12));
            const auto elastic = drive<D>(model, LoadPath::uniaxial, 1e-6, 10);
            CHECK(elastic.back().q / 1e-6 == Approx(modulus).epsilon(1e-5));
            CHECK(elastic.back().pressure == Approx(-elastic.back().q / D).epsilon(1e-8));

            const double strength = model.uniaxial_strength(D);
            const auto pulled = drive<D>(model, LoadPath::uniaxial, 1.1 * strength / modulus, 1000);
            CHECK(find_milestones(pulled).max_q->q == Approx(strength).epsilon(5e-3));
            const double crushing = uniaxial_crushing_strength(model, D);
            const auto pressed = drive<D>(model, LoadPath::uniaxial, -1.1 * crushing / modulus, 1000);
            const Milestones yielded = find_milestones(pressed);
            REQUIRE(yielded.onset);
            CHECK(yielded.onset->q == Approx(crushing).epsilon(5e-3));
            CHECK(yielded.onset->pressure == Approx(crushing / D).epsilon(5e-3));
            for (const auto* rows : {&pulled, &pressed})
                for (const PointRow& row : *rows)
                    CHECK(std::abs(std::abs(row.pressure) - row.q / D) <= 1e-6 * strength);
        }
}

TEST_CASE("uniaxial strain has the modulus of P waves") {
    const IceModel model;
    const auto rows = drive<3>(model, LoadPath::uniaxial_strain, -1e-6, 10);
    const double axial = rows.back().pressure + rows.back().q * 2 / 3;
    CHECK(axial / 1e-6 == Approx(model.density * std::pow(model.wave_speed(3), 2)).epsilon(1e-5));
    CHECK(rows.back().log_volume == Approx(-1e-6));
}

TEST_CASE("cycles go to the strain, to its opposite and back") {
    const Loading loading{.strain = 2.0, .steps = 16, .cycles = 2, .held_pressure = {}};
    const double wanted[] = {0, 1, 2, 1, 0, -1, -2, -1, 0};
    for (int step = 0; step <= 16; ++step) CHECK(strain_at(loading, step) == Approx(wanted[step % 8]));
    CHECK(strain_at({.strain = -3.0, .steps = 3, .held_pressure = {}}, 3) == Approx(-3.0));
}

TEST_CASE("float follows double along every path") {
    for (const LoadPath path :
         {LoadPath::isotropic, LoadPath::uniaxial, LoadPath::uniaxial_strain, LoadPath::shear}) {
        const IceModel model = with(0.2, 0.5);
        const auto fine = drive<3, double>(model, path, 3e-3, 2000),
                   coarse = drive<3, float>(model, path, 3e-3, 2000);
        for (std::size_t i = 0; i < fine.size(); ++i) {
            CHECK(std::abs(fine[i].pressure - coarse[i].pressure) < 5e-3 * p0_at_start(model));
            CHECK(std::abs(fine[i].q - coarse[i].q) < 5e-3 * p0_at_start(model));
        }
        CHECK(fine.back().dissipated == Approx(coarse.back().dissipated).epsilon(1e-2));
    }
}

TEST_CASE_TEMPLATE("no path gains energy: dissipation never falls, whatever the rules", Dimension, Two,
                   Three) {
    constexpr int D = Dimension::value;
    for (const LoadPath path :
         {LoadPath::isotropic, LoadPath::uniaxial, LoadPath::uniaxial_strain, LoadPath::shear})
        for (const ShearReturn rule : {ShearReturn::pressure, ShearReturn::trace})
            for (const bool cap : {true, false})
                for (const double beta : {1.0, 0.1})
                    for (const int cycles : {0, 2})
                        for (const double strain : {4e-3, -4e-3, 0.05}) {
                            IceModel model = with(beta);
                            model.shear_return = rule;
                            model.cap_hardening = cap;
                            const auto rows = drive<D>(model, path, strain, 1000, cycles);
                            CAPTURE(static_cast<int>(path));
                            CAPTURE(static_cast<int>(rule));
                            CAPTURE(cap);
                            CAPTURE(beta);
                            CAPTURE(cycles);
                            CAPTURE(strain);
                            // A step that turns around and yields takes its work from the mean of two
                            // stresses between which the path is bent: wrong by up to ¼ E h².
                            const double h = rows[1].strain;
                            CHECK(min_increment_of_dissipation(rows) >= -0.25 * model.youngs_modulus * h * h);
                        }
}

TEST_CASE_TEMPLATE("the return never raises the stored energy, whatever the rule", Dimension, Two, Three) {
    constexpr int D = Dimension::value;
    Random random(9);
    int yielded = 0;
    for (const ShearReturn rule : {ShearReturn::pressure, ShearReturn::trace})
        for (const double beta : {1.0, 0.1})
            for (const double size : {1e-4, 1e-3, 1e-2, 0.1}) {
                IceModel model = with(beta);
                model.shear_return = rule;
                Batch<D, double> batch;
                for (int p = 0; p < batch_size; ++p) {
                    const Tensor<D> identity = Tensor<D>::Identity(),
                                    f = identity + random_tensor<D>(random, size);
                    batch.set(p, f * f.transpose() - identity);
                    batch.alpha[p] = (p % 4) / 3.0 * model.initial_alpha(D);
                }
                const Batch<D, double> trial = batch;
                return_to_yield<D, double>(IceConstants<D, double>(model), batch_size, batch.strain,
                                           &batch.alpha, batch.stress);
                for (int p = 0; p < batch_size; ++p) {
                    const double before = energy_of<D>(model, trial, p),
                                 after = energy_of<D>(model, batch, p);
                    CHECK(after <= before);
                    yielded += after < before ? 1 : 0;
                }
            }
    CHECK(yielded > 500);
}

TEST_CASE("the trace rule moves the pressure, the pressure rule keeps it") {
    // p before and after, kPa: lib/mpm/README.md, Ice. Any ice fits whose q_new is far below q.
    struct Mapping {
        double along, across, before, trace;
    };
    for (const Mapping of : {Mapping{1.02, 0.98, 333.2, -333.3}, Mapping{1.002, 0.9985, -414.3, -419.3}})
        for (const ShearReturn rule : {ShearReturn::pressure, ShearReturn::trace}) {
            IceModel model = with(1.0);
            model.moduli = Moduli::paper;
            model.shear_return = rule;
            IcePoint<2, double> point = intact_point<2, double>(model);
            stretch_point<2, double>(model, {std::log(of.along), std::log(of.across)}, point);
            const double p = -0.5 * (point.stress[0] + point.stress[1]);
            CHECK(p / 1e3 == Approx(rule == ShearReturn::trace ? of.trace : of.before).epsilon(1e-3));
        }
}

TEST_CASE_TEMPLATE("a crack band costs the asked energy at any width that does not snap", Dimension, Two,
                   Three) {
    constexpr int D = Dimension::value;
    for (const double beta : {1.0, 0.5, 0.2, 0.1}) {
        IceModel model = with(beta);
        const double strength = model.uniaxial_strength(D), modulus = uniaxial_modulus(model, D);
        const double energy = 8.0 * strength * strength / modulus;  // snaps from a width of 16 m on
        const auto cost = [&](double width) {
            model.hardening = crack_band_hardening(model, D, energy, width);
            const double end = -1.2 * model.initial_alpha(D) + 3 * strength / modulus;
            const auto rows = drive<D>(model, LoadPath::uniaxial, end, 10000);
            CHECK(rows.back().damage == 1.0);
            return rows.back().dissipated * width;
        };
        for (const double width : {1.0, 2.0, 4.0, 8.0}) CHECK(cost(width) == Approx(energy).epsilon(3e-3));
        // A wider band frees more elastic energy than the crack costs: all that it stores, ½ σt²/E per
        // volume.
        CHECK(cost(64.0) == Approx(0.5 * 64.0 * strength * strength / modulus).epsilon(0.05));
    }
}

TEST_CASE_TEMPLATE("softening that is not stable snaps to failure within a few steps, and stays finite", Real,
                   float, double) {
    // In shear at p = 0 the ice has to have its pc above 0, or rounding decides whether it softens.
    struct Case {
        LoadPath path;
        double beta;
    };
    for (const Case of :
         {Case{LoadPath::isotropic, 1.0}, Case{LoadPath::uniaxial, 1.0}, Case{LoadPath::shear, 0.5}})
        for (const double hardening : {3.0, 30.0}) {
            const auto rows = drive<3, Real>(with(of.beta, hardening), of.path, 3e-3, 3000);
            const Milestones found = find_milestones(rows);
            REQUIRE((found.onset && found.failure));
            CHECK(found.failure->step - found.onset->step < 10);
            for (const PointRow& row : rows) {
                CHECK((std::isfinite(row.pressure) && std::isfinite(row.q) && std::isfinite(row.alpha)));
                if (row.step > found.failure->step) CHECK((row.pressure == 0.0 && row.q == 0.0));
            }
            CHECK(rows.back().alpha < 3.1e-3);
        }
}

TEST_CASE_TEMPLATE("opened ice carries pressure again once it is closed by its tensile α", Dimension, Two,
                   Three) {
    constexpr int D = Dimension::value;
    const IceModel model = with(0.2);
    const auto rows = drive<D>(model, LoadPath::isotropic, 8e-3, 4000, 1);
    const double start = -model.initial_alpha(D), step = rows[1].strain;
    const auto widest = std::ranges::max_element(rows, {}, &PointRow::strain);
    CHECK(widest->alpha == Approx(8e-3 - start).epsilon(1e-6));
    const auto closed =
        std::find_if(widest, rows.end(), [](const PointRow& row) { return row.pressure > 0; });
    REQUIRE(closed != rows.end());
    CHECK(closed->strain <= start);
    CHECK(closed->strain >= start - 3 * step);
    const auto densest = std::ranges::min_element(rows, {}, &PointRow::strain);
    CHECK(densest->pressure == Approx(p0_at_start(model)).epsilon(1e-3));
}

TEST_CASE_TEMPLATE("failed ice sheared under 1 MPa keeps its volume and at most the strength of the start",
                   Dimension, Two, Three) {
    constexpr int D = Dimension::value;
    for (const double beta : {0.3, 0.1}) {
        const IceModel model = with(beta);
        for (const PointRow& row : shear_failed<D>(model, 1e6, 1.0, 100000)) {
            REQUIRE(row.p0 <= p0_at_start(model) * (1 + 1e-12));
            REQUIRE(std::abs(row.log_volume) < 0.02);
            if (row.strain > 1e-2) REQUIRE(row.pressure == Approx(1e6).epsilon(1e-2));
        }
    }
}

TEST_CASE("sheared under pressure ice of β < 1 comes to the critical state if steps are short") {
    // There softening turns into hardening, P = p0 (1−β)/2. A step overshoots by up to κξ dγ, here 7 kPa.
    const IceModel model = with(0.1);
    const auto rows = shear_failed<3>(model, 1e6, 0.03, 10000);
    for (const PointRow& row : rows)
        if (row.strain > 0.02) CHECK(row.p0 == Approx(2e6 / (1 - model.beta)).epsilon(0.1));
}

TEST_CASE("without the cap ice of β = 1 sheared under 1 MPa gains strength without bound") {
    IceModel model = with(1.0);
    model.cap_hardening = false;
    for (const ShearReturn rule : {ShearReturn::pressure, ShearReturn::trace}) {
        model.shear_return = rule;
        const auto rows = shear_failed<3>(model, 1e6, 1.0, 10000);
        CHECK(rows[1000].p0 == Approx(56e6).epsilon(0.02));
        CHECK(rows.back().p0 > 6 * rows[1000].p0);
        CHECK(rows.back().q > 2e8);
        if (rule == ShearReturn::pressure)
            CHECK(rows.back().log_volume > -2e-3);
        else
            CHECK(rows.back().log_volume < -0.1);
    }
}

TEST_CASE("with the cap ice of β = 1 is crushed on and on by a pressure above its p0") {
    const IceModel model = with(1.0);
    const auto rows = shear_failed<3>(model, 1e6, 0.1, 1000);
    CHECK(rows.back().pressure == Approx(p0_at_start(model)).epsilon(1e-9));
    CHECK(rows.back().log_volume == Approx(-0.1).epsilon(1e-2));
}
