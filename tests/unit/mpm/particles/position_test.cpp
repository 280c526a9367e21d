#include "mpm/particles/position.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include <algorithm>
#include <vector>

#include "core/random.h"
#include "mpm/grid/stencil.h"

using namespace tidewater;
using namespace tidewater::mpm;

TEST_CASE("a stored position comes back within half a unit, a double exactly") {
    for (std::uint64_t n = 0; n < 1000; ++n) {
        const double cells = -1.0 + 31.5 * random_uniform(1, 0, n);
        CHECK(std::abs(cells_of(stored<float>(cells)) - cells) <= 0.5 / units_per_cell);
        CHECK(cells_of(stored<double>(cells)) == cells);
    }
    for (int quarter = -4; quarter < 124; ++quarter)
        CHECK(cells_of(stored<float>(0.25 * quarter)) == 0.25 * quarter);
}

TEST_CASE("the rounding shift runs evenly through 0 to 1 from any step on") {
    for (const long first : {0L, 1L, 12345L, 100'000'000L}) {
        const long count = 1000;
        std::vector<double> shifts;
        double sum = 0;
        for (long n = first; n < first + count; ++n) {
            shifts.push_back(rounding_shift(n));
            sum += shifts.back() - 0.5;
            CHECK(std::abs(sum) < 2.0);  // of every beginning of the sequence
        }
        std::sort(shifts.begin(), shifts.end());
        CHECK(shifts.front() >= 0.0);
        CHECK(shifts.back() < 1.0);
        double max_gap = 1.0 - shifts.back() + shifts.front();
        for (std::size_t n = 1; n < shifts.size(); ++n)
            max_gap = std::max(max_gap, shifts[n] - shifts[n - 1]);
        CHECK(max_gap < 3.0 / count);
    }
}

TEST_CASE("a million tiny steps sum to the exact way within a few units") {
    // Units per step, from nothing to more than the spacing of floats of that size.
    for (const double units :
         {0.0, 0.001, 0.37, -0.37, 0.5, -0.6180339887, 8.6, -8.6, 1234.567, 0.25 * 67108}) {
        CAPTURE(units);
        Column<float> velocity;
        Column<std::int32_t> position;
        for (int p = 0; p < batch_size; ++p) velocity[p] = static_cast<float>(units), position[p] = 0;
        const auto cells_per_speed = static_cast<float>(1.0 / units_per_cell);
        const double exact_step = static_cast<double>(velocity[0]);
        double way = 0, worst = 0;
        for (long n = 0; n < 1'000'000; ++n) {
            advance_positions<float>(velocity, cells_per_speed, static_cast<float>(rounding_shift(n)),
                                     position);
            way += position[0];
            if (n == 0) {
                for (int p = 1; p < batch_size; ++p) CHECK(position[p] == position[0]);
            }
            for (auto& units_moved : position.value) units_moved = 0;
            worst = std::max(worst, std::abs(way - exact_step * static_cast<double>(n + 1)));
        }
        INFO(units << " units per step: off by at most " << worst << " units");
        CHECK(worst < 4.0 + 1e-7 * std::abs(units) * 1e6);
    }
}

TEST_CASE("all lanes move alike and a double moves by the product") {
    Column<double> velocity, position;
    for (int p = 0; p < batch_size; ++p) velocity[p] = 0.1 * p, position[p] = p;
    advance_positions<double>(velocity, 0.5, 0.3, position);
    for (int p = 0; p < batch_size; ++p) CHECK(position[p] == p + 0.1 * p * 0.5);
}

TEST_CASE_TEMPLATE("node and rest make the position over the whole range of a tile", Real, float, double) {
    for (std::uint64_t n = 0; n < 2000; ++n) {
        const double cells = n == 0   ? -0.5
                             : n == 1 ? Block<2>::width + 0.4999999
                             : n < 40 ? 0.5 * static_cast<double>(n - 3)
                                      : -0.5 + (Block<2>::width + 0.9999) * random_uniform(3, 1, n);
        if (cells >= Block<2>::width + 0.5) continue;
        const Stored<Real> x = stored<Real>(cells);
        const std::int32_t node = nearest_node(x);
        const Real rest = from_node(x, node);
        CAPTURE(cells);
        CHECK(node >= 0);
        CHECK(node <= Block<2>::width);
        CHECK(rest >= Real(-0.5));
        CHECK(rest <= Real(0.5));  // a float rounds ½ − 2⁻²⁶ to ½
        CHECK(std::abs(node + static_cast<double>(rest) - cells_of(x)) < (sizeof(Real) == 4 ? 3e-8 : 1e-14));
    }
}
