#include "mpm/base/lane_math.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace tidewater::mpm;

namespace {

// Largest relative error of `ours` over `count` arguments from `first` on, each `factor` times the last, and
// their negatives if `both_signs`.
template <class Real, class Ours, class Exact>
double max_error(double first, double last, bool both_signs, const Ours& ours, const Exact& exact) {
    double worst = 0.0;
    for (double size = first; size <= last; size *= 1.0037) {
        for (const double sign : {1.0, -1.0}) {
            if (sign < 0 && !both_signs) continue;
            const Real x = static_cast<Real>(sign * std::min(size, last));
            const long double right = exact(static_cast<long double>(x));
            const long double error = std::abs((static_cast<long double>(ours(x)) - right) / right);
            worst = std::max(worst, static_cast<double>(error));
        }
    }
    return worst;
}

const auto exact_log1p = [](long double x) { return std::log1p(x); };
const auto exact_sinh = [](long double x) { return std::sinh(x); };
const auto exact_inverse_cbrt = [](long double x) { return 1.0L / std::cbrt(x); };

}  // namespace

TEST_CASE_TEMPLATE("lane_log1p is within its stated error from tiny arguments to huge ones", Real, float,
                   double) {
    const auto ours = [](Real x) { return lane_log1p(x); };
    const double allowed = sizeof(Real) == 4 ? 1.5e-7 : 5e-16;
    CHECK(max_error<Real>(1e-30, 0.9, true, ours, exact_log1p) < allowed);
    CHECK(max_error<Real>(0.01, 1e30, false, ours, exact_log1p) < allowed);
    // Where 1 + x passes √½, 1, √2 and 2, and down to the last x above −1.
    for (const double middle : {-0.5, -0.29289321881345, 0.4142135623731, 1.0, 3.0})
        for (int step = -200; step <= 200; ++step) {
            const Real x = static_cast<Real>(middle * (1 + step * 4e-8));
            const long double exact = std::log1p(static_cast<long double>(x));
            CHECK(std::abs(static_cast<double>((lane_log1p(x) - exact) / exact)) < allowed);
        }
    for (Real gap = Real(0.25); gap >= std::numeric_limits<Real>::epsilon(); gap /= 2) {
        const long double exact = std::log1p(static_cast<long double>(gap - 1));
        CHECK(std::abs(static_cast<double>((lane_log1p(gap - 1) - exact) / exact)) < allowed);
    }
    CHECK(lane_log1p(Real(0)) == Real(0));
}

TEST_CASE_TEMPLATE("small_sinh is within its stated error up to one half", Real, float, double) {
    const auto ours = [](Real x) { return small_sinh(x); };
    const double allowed = sizeof(Real) == 4 ? 1.0e-7 : 2e-16;
    CHECK(max_error<Real>(1e-30, 0.01, true, ours, exact_sinh) < allowed);
    CHECK(max_error<Real>(0.001, 0.5, true, ours, exact_sinh) < allowed);
    CHECK(small_sinh(Real(0)) == Real(0));
    CHECK(small_sinh(Real(-0.3)) == -small_sinh(Real(0.3)));
}

TEST_CASE_TEMPLATE("inverse_cbrt is within its stated error over thirty decades each way", Real, float,
                   double) {
    const auto ours = [](Real x) { return inverse_cbrt(x); };
    const double allowed = sizeof(Real) == 4 ? 1.5e-7 : 3e-16;
    CHECK(max_error<Real>(1e-30, 1e30, false, ours, exact_inverse_cbrt) < allowed);
    double worst = 0.0;
    for (int i = 0; i < 80000; ++i) {  // every mantissa and third of an exponent around 1
        const Real x = Real(0.9) + Real(1e-4) * static_cast<Real>(i);
        const long double exact = 1.0L / std::cbrt(static_cast<long double>(x));
        worst = std::max(worst, std::abs(static_cast<double>((inverse_cbrt(x) - exact) / exact)));
    }
    CHECK(worst < allowed);
    CHECK(inverse_cbrt(Real(1)) == doctest::Approx(1.0).epsilon(allowed));
}

TEST_CASE_TEMPLATE("lane_sqrt is correctly rounded", Real, float, double) {
    for (const double x : {0.0, 1e-30, 0.3, 1.0, 2.0, 1e30})
        CHECK(lane_sqrt(static_cast<Real>(x)) == std::sqrt(static_cast<Real>(x)));
}
