#include "core/spline.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace tidewater;

TEST_CASE("the spline is positive within 3/2 and smooth, and Φ is its integral") {
    const double step = 1e-4;
    double sum = 0.0;
    for (int n = -20000; n < 20000; ++n) {
        const double t = (n + 0.5) * step;
        const double value = quadratic_spline(t);
        CHECK((std::abs(t) < 1.5 ? value > 0.0 : value == 0.0));
        CHECK(std::abs(quadratic_spline(t + step) - value) <= step);  // the slope is 1 at most
        sum += step * value;
        if (n % 1000 == 0)
            CHECK(quadratic_spline_integral((n + 1) * step) == doctest::Approx(sum).epsilon(1e-7));
    }
    CHECK(quadratic_spline_integral(0.0) == 0.5);
    CHECK(quadratic_spline_integral(-1.5) == 0.0);
    CHECK(quadratic_spline_integral(7.0) == 1.0);
}

TEST_CASE_TEMPLATE("the three weights of a point are N at its nodes, sum to 1 and keep its place", Real,
                   float, double) {
    for (const double f : {-0.5, -0.31, 0.0, 0.2, 0.499}) {
        CAPTURE(f);
        const auto plain = spline_weights(static_cast<Real>(f));
        const auto closed = closed_spline_weights(static_cast<Real>(f));
        for (const auto& w : {plain, closed}) {
            CHECK(w.below == doctest::Approx(quadratic_spline(f + 1.0)).epsilon(1e-6));
            CHECK(w.at == doctest::Approx(quadratic_spline(f)).epsilon(1e-6));
            CHECK(w.above == doctest::Approx(quadratic_spline(f - 1.0)).epsilon(1e-6));
            CHECK(w.above - w.below == doctest::Approx(f).epsilon(1e-6));
        }
        CHECK(std::abs(closed.below + closed.at + closed.above - Real(1)) <=
              std::numeric_limits<Real>::epsilon());
    }
}
