#include "mpm/rigid.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include <cmath>

#include "support/tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

// A block alone in a weightless tank.
template <int D>
Simulation<D, double> lone_block() {
    Index<D> cells;
    cells.fill(24);
    auto start = test::tank_start<D>(0.1, cells, 0.0, 20.0, 0.8, Vector<D, double>::Constant(0.8));
    start.parameters.gravity = 0.0;
    return make_simulation<D, double>(start);
}

// Sets particles on a rigid motion about the body's centre.
void set_motion(Simulation<2, double>& s, const Vector<2, double>& velocity, double turning) {
    auto& particles = s.bodies[0];
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const auto& r = particles.offset[p];
        particles.velocity[p] = velocity + turning * Vector<2, double>(r[1], -r[0]);
        particles.gradient[p] << 0.0, turning, -turning, 0.0;
        particles.gradient[p] *= s.grid.layout.cell_size;
    }
}

}  // namespace

TEST_CASE("a body's mass and inertia are those of its particles, with APIC's share") {
    const auto s = lone_block<2>();
    const RigidBody& body = s.rigid[0];
    CHECK(body.mass == doctest::Approx(920.0 * 0.64));
    CHECK(body.center.isApprox(Eigen::Vector3d(1.2, 0.0, 1.2)));
    const double lattice =
        0.64 / 6.0 - 0.05 * 0.05 / 6.0;  // (a² + b²)/12 less what points at cell centres miss
    CHECK(body.inertia(1, 1) == doctest::Approx(body.mass * (lattice + 0.5 * 0.01)).epsilon(1e-12));
}

TEST_CASE("a free body keeps its velocity and its spin for a whole turn, and stays rigid") {
    auto s = lone_block<2>();
    set_motion(s, {0.05, 0.0}, 2.0 * M_PI);
    const int steps = 1000;
    for (int n = 0; n < steps; ++n) advance(s, 1.0 / steps);
    const RigidBody& body = s.rigid[0];
    CHECK(body.velocity.isApprox(Eigen::Vector3d(0.05, 0.0, 0.0), 1e-9));
    CHECK(body.angular_velocity[1] == doctest::Approx(2.0 * M_PI).epsilon(1e-9));
    CHECK(body.center.isApprox(Eigen::Vector3d(1.25, 0.0, 1.2), 1e-9));
    CHECK(std::abs(body.rotation.w()) == doctest::Approx(1.0).epsilon(1e-9));  // back to where it began
    CHECK(kinetic_energy(body) ==
          doctest::Approx(0.5 * body.mass * 0.0025 + 0.5 * body.inertia(1, 1) * 4 * M_PI * M_PI));
}

TEST_CASE("a block dropped on the bottom comes to rest on it without leaving the tank") {
    Index<2> cells{24, 24};
    for (const double c : {20.0, 200.0}) {
        auto start = test::tank_start<2>(0.1, cells, 0.0, c, 0.8, Vector<2, double>(0.8, 0.6));
        auto s = make_simulation<2, float>(start);
        for (int n = 0; n < 4000; ++n) advance(s, 0.5 * 0.1 / (c + 5.0));
        CHECK(s.rigid[0].center[2] == doctest::Approx(0.4).epsilon(0.15));
        CHECK(std::abs(s.rigid[0].velocity[2]) < 0.2);
    }
}
