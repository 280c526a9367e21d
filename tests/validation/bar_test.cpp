// Waves along a bar of elastic ice: its free-free fundamental mode has the period 2 L/c.
//
//     c = √(stiffness/ρ): E in 3D, 4μκ/(κ+μ) in 2D for thin bars (E/(1−ν²) if κ is that of plane strain);
//     κ + 4μ/3 in 3D, κ + μ in 2D for P waves, whose bar slides between walls.
#include <doctest/doctest.h>

#include <string>

#include "support/ice_body.h"
#include "support/state.h"
#include "support/zero_crossings.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

constexpr double length = 80.0, thickness = 4.0, end = 8.0;  // cells of 1 m

template <int D>
struct Bar {
    Start<D> start;
    double wave_number = std::acos(-1.0) / length;

    double mode(const Vector<D, double>& x) const { return std::cos(wave_number * (x[0] - end)); }
};

template <int D>
Bar<D> make_bar(const IceModel& ice, bool confined) {
    Bar<D> bar;
    const double free = confined ? 0.0 : 6.0;
    bar.start.cell_size = 1.0;
    bar.start.cells.fill(static_cast<int>(thickness + 2 * free));
    bar.start.cells[0] = static_cast<int>(length + 2 * end);
    bar.start.parameters.gravity = 0.0;
    bar.start.parameters.ice = ice;
    bar.start.parameters.ice.fracture = false;
    Vector<D, double> low = Vector<D, double>::Constant(free);
    Vector<D, double> high = Vector<D, double>::Constant(free + thickness);
    low[0] = end, high[0] = end + length;
    auto& body = test::add_ice<D>(test::box_shape<D>(low, high), bar.start);
    for (const auto& x : body.points)
        body.velocity.push_back(1e-4 * ice.wave_speed(D) * bar.mode(x) * Vector<D, double>::Unit(0));
    return bar;
}

// Of the displacements' sum weighted with mode(rest): two periods, from the first zero after the start on.
template <int D, class Real, class Mode>
double measured_period(const Start<D>& start, const Mode& mode) {
    auto s = make_simulation<D, Real>(start);
    const auto rest = test::read_state(s).x;
    test::ZeroCrossings crossings;
    while (crossings.count() < 5) {
        advance(s, stable_time_step(s));
        if (s.step % 4 != 0) continue;
        const auto now = test::read_state(s).x;
        double amplitude = 0.0;
        for (std::size_t p = 0; p < rest.size(); ++p) amplitude += (now[p] - rest[p])[0] * mode(rest[p]);
        crossings.add(s.time, amplitude);
    }
    return crossings.period();
}

template <int D>
double bar_speed(const IceModel& ice) {
    const double mu = ice.shear_modulus(), kappa = ice.bulk_modulus(D);
    const double stiffness = D == 3 ? 9 * kappa * mu / (3 * kappa + mu) : 4 * kappa * mu / (kappa + mu);
    return std::sqrt(stiffness / ice.density);
}

template <int D, class Real>
void check_speeds(const IceModel& ice) {
    for (const bool confined : {false, true}) {
        const double expected = confined ? ice.wave_speed(D) : bar_speed<D>(ice);
        const Bar<D> bar = make_bar<D>(ice, confined);
        const double period = measured_period<D, Real>(bar.start, [&](const auto& x) { return bar.mode(x); });
        const double speed = 2.0 * length / period;
        const std::string wave = confined ? "P" : "bar", real = sizeof(Real) == 4 ? "float" : "double";
        MESSAGE(wave << " wave in " << D << "D, " << real << ", E " << 1e-9 * ice.youngs_modulus
                     << " GPa: " << speed << " m/s, expected " << expected);
        CHECK(speed == doctest::Approx(expected).epsilon(0.01));
    }
}

}  // namespace

TEST_CASE("bar and P waves run at their speeds in 2D for both choices of moduli") {
    for (const Moduli moduli : {Moduli::plane_strain, Moduli::paper}) {
        IceModel ice;
        ice.moduli = moduli;
        check_speeds<2, double>(ice);
    }
}

TEST_CASE("bar and P waves run at their speeds in 3D") { check_speeds<3, double>(IceModel{}); }

TEST_CASE("waves in float run at their speeds from soft to stiff ice") {
    for (const double modulus : {1e8, 1e9, 1e10}) {
        IceModel ice;
        ice.youngs_modulus = modulus;
        check_speeds<2, float>(ice);
        check_speeds<3, float>(ice);
    }
}

// The mode sin(πx/L) of ice that fills a box of slip walls.
TEST_CASE("ice between two slip walls rings as in a box of its length, with an error of second order") {
    double before = 0.0;
    for (const int cells : {10, 20, 40}) {
        Start<2> start;
        start.cell_size = 1.0;
        start.cells = {cells, 4};
        start.parameters.gravity = 0.0;
        start.parameters.ice.fracture = false;
        const double wave_number = std::acos(-1.0) / cells;
        auto& body = test::add_ice<2>([](const auto&) { return true; }, start);
        for (const auto& x : body.points) body.velocity.push_back({0.01 * std::sin(wave_number * x[0]), 0.0});
        const double period =
            measured_period<2, double>(start, [&](const auto& x) { return std::sin(wave_number * x[0]); });
        const double slow = 0.5 * period * start.parameters.ice.wave_speed(2) / cells - 1;
        MESSAGE("box of " << cells << " cells is slow by " << 100 * slow << " %, as if longer by "
                          << slow * cells << " cells");
        CHECK(slow * cells * cells == doctest::Approx(0.95).epsilon(0.05));
        if (before > 0.0) CHECK(slow == doctest::Approx(before / 4).epsilon(0.05));
        before = slow;
    }
}

TEST_CASE("the closed forms are those of E and ν") {
    const IceModel ice;
    const double nu = ice.poisson_ratio, modulus = ice.youngs_modulus;
    CHECK(bar_speed<3>(ice) == doctest::Approx(std::sqrt(modulus / ice.density)));
    CHECK(bar_speed<2>(ice) == doctest::Approx(std::sqrt(modulus / (1 - nu * nu) / ice.density)));
}
