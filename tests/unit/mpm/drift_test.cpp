// Slow motion in `float`, far from the origin, to 0.1 % after a million steps.
// Why that is asked for: lib/mpm/README.md, Grid and transfer.
#include <doctest/doctest.h>

#include <initializer_list>

#include <algorithm>

#include "core/random.h"
#include "mpm/step/start.h"
#include "mpm/step/step.h"
#include "support/state.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

struct DriftError {
    double way = 0.0, velocity = 0.0;  // relative, worst of all particles
};

// 15 particles of elastic ice that feel nothing of each other, and a cell filled with 3 × 3, near the far end
// of 5 km.
Start<2> drifting_ice(double cell_size, const Vector<2, double>& velocity) {
    Start<2> start;
    start.cell_size = cell_size;
    start.cells.fill(static_cast<int>(std::lround(5000.0 / cell_size)));
    start.parameters.gravity = 0.0;
    start.parameters.ice.youngs_modulus = 1e10;
    start.parameters.ice.fracture = false;
    auto& body = start.bodies.emplace_back();
    body.material = Material::ice;
    const Vector<2, double> corner = cell_size * (start.cells[0] - 14) * Vector<2, double>::Ones();
    for (int n = 0; n < 16; ++n) {
        const Vector<2, double> place(4.0 * (n / 4), 4.0 * (n % 4));
        for (int m = 0; m < (n == 0 ? 9 : 1); ++m) {
            Vector<2, double> within(m / 3 / 3.0, m % 3 / 3.0);
            for (int axis = 0; axis < 2 && n > 0; ++axis) {
                within[axis] =
                    0.7 * random_uniform(1, static_cast<std::uint64_t>(axis), static_cast<std::uint64_t>(n));
            }
            body.points.push_back(corner + cell_size * (place + within - Vector<2, double>(1.9, 1.9)));
        }
    }
    body.velocity.assign(body.points.size(), velocity);
    body.volume = cell_size * cell_size * static_cast<double>(body.points.size()) / 9.0;
    body.mass = 900.0 * body.volume;
    return start;
}

DriftError drift_error(double cell_size, long steps) {
    const ThreadLimit serial(1);
    const Vector<2, double> velocity(1e-3, -0.5e-3);
    auto s = make_simulation<2, float>(drifting_ice(cell_size, velocity));
    const auto before = test::read_state(s);
    const double dt = 0.5 * cell_size / 3900.0;
    for (long n = 0; n <= steps; ++n) advance(s, dt);
    const auto after = test::read_state(s);
    DriftError error;
    for (std::size_t p = 0; p < after.x.size(); ++p) {
        const Vector<2, double> way = after.x[p] - before.x[p];
        error.way = std::max(error.way, (way - s.time * velocity).norm() / (s.time * velocity.norm()));
        error.velocity = std::max(error.velocity, (after.v[p] - velocity).norm() / velocity.norm());
    }
    return error;
}

void check_drift(double cell_size) {
    const DriftError error = drift_error(cell_size, 1'000'000);
    MESSAGE("cells of " << cell_size << " m: way off by " << 100 * error.way << " %, velocity by "
                        << 100 * error.velocity << " %");
    CHECK(error.way < 1e-3);
    CHECK(error.velocity < 1e-3);
}

}  // namespace

TEST_CASE("a drift of 1 mm/s is kept within 0.1 % over a million float steps, cells of 5 m") {
    check_drift(5.0);
}

TEST_CASE("a drift of 1 mm/s is kept within 0.1 % over a million float steps, cells of 5 cm") {
    check_drift(0.05);
}
