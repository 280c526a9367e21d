#include "mpm/rigid.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.h"
#include "core/random.h"
#include "mpm/motion.h"
#include "mpm/rigid_nodes.h"
#include "support/tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

// A block alone in a weightless tank.
template <int D>
Start<D> lone_block() {
    Index<D> cells;
    cells.fill(24);
    auto start = test::tank_start<D>(0.1, cells, 0.0, 20.0, 0.8, Vector<D, double>::Constant(0.8));
    start.parameters.gravity = 0.0;
    return start;
}

// Sets its particles on a rigid motion about its centre.
void set_motion(const Vector<2, double>& velocity, double turning, Start<2>& start) {
    auto& body = start.bodies[1];
    Matrix<2, double> gradient;
    gradient << 0.0, turning, -turning, 0.0;
    for (const auto& point : body.points) {
        body.velocity.push_back(velocity + gradient * (point - Vector<2, double>(1.2, 1.2)));
        body.gradient.push_back(gradient);
    }
}

// A bar 1.2 m long and 0.2 m thick, turned up at its right end, in the middle of a dry tank of 3 × 3 m.
Start<2> tilted_bar(double degrees) {
    Start<2> start;
    start.cell_size = 0.05;
    start.cells = {60, 60};
    auto& bar = start.bodies.emplace_back();
    bar.material = Material::rigid;
    const double spacing = 0.5 * start.cell_size;
    const Eigen::Rotation2Dd turn(degrees * M_PI / 180.0);
    for (int along = 0; along < 48; ++along) {
        for (int up = 0; up < 8; ++up) {
            const Vector<2, double> from_middle(spacing * (along - 23.5), spacing * (up - 3.5));
            bar.points.push_back(Vector<2, double>(1.5, 1.5) + turn * from_middle);
        }
    }
    bar.volume = 1.2 * 0.2;
    bar.mass = 920.0 * bar.volume;
    return start;
}

// The least distance of a body's particles from the sides of the box, m; negative outside.
template <int D, class Real>
double distance_from_walls(const Simulation<D, Real>& s) {
    const ThreadLimit serial(1);
    double least = 1e9;
    for (const auto& particles : s.bodies) {
        for_each_particle(s.grid, particles, [&](std::size_t, const Index<D>& block, std::size_t p) {
            const auto x = global_position(s.grid.layout, block, particles, p);
            for (int axis = 0; axis < D; ++axis) {
                const double size =
                    s.grid.layout.cell_size * s.grid.layout.cells[static_cast<std::size_t>(axis)];
                least = std::min({least, x[axis], size - x[axis]});
            }
        });
    }
    return least;
}

}  // namespace

TEST_CASE("a body's mass and inertia are those of its particles, with APIC's share") {
    const auto s = make_simulation<2, double>(lone_block<2>());
    const RigidBody& body = s.rigid[0];
    CHECK(body.mass == doctest::Approx(920.0 * 0.64));
    CHECK(body.center_in_box(0.1).isApprox(Eigen::Vector3d(1.2, 0.0, 1.2)));
    const double lattice =
        0.64 / 6.0 - 0.05 * 0.05 / 6.0;  // (a² + b²)/12 less what points at cell centres miss
    CHECK(body.inertia(1, 1) == doctest::Approx(body.mass * (lattice + 0.5 * 0.01)).epsilon(1e-12));
}

TEST_CASE("a free body keeps its velocity and its spin for a whole turn, and stays rigid") {
    auto start = lone_block<2>();
    set_motion({0.05, 0.0}, 2.0 * M_PI, start);
    auto s = make_simulation<2, double>(start);
    const int steps = 1000;
    for (int n = 0; n <= steps; ++n) advance(s, 1.0 / steps);
    const RigidBody& body = s.rigid[0];
    CHECK(body.velocity.isApprox(Eigen::Vector3d(0.05, 0.0, 0.0), 1e-9));
    CHECK(body.angular_velocity[1] == doctest::Approx(2.0 * M_PI).epsilon(1e-9));
    CHECK(body.center_in_box(0.1).isApprox(Eigen::Vector3d(1.25, 0.0, 1.2), 1e-9));
    CHECK(std::abs(body.rotation.w()) == doctest::Approx(1.0).epsilon(1e-9));  // back to where it began
    CHECK(kinetic_energy(body) ==
          doctest::Approx(0.5 * body.mass * 0.0025 + 0.5 * body.inertia(1, 1) * 4 * M_PI * M_PI));
}

TEST_CASE("a block dropped on the bottom comes to rest on it and stays there") {
    const ThreadLimit serial(1);  // 90 000 small steps
    for (const double c : {20.0, 200.0}) {
        // The sound speed is of no water; it stands for the size of the steps.
        auto s = make_simulation<2, float>(
            test::tank_start<2>(0.1, {24, 24}, 0.0, c, 0.8, Vector<2, double>(0.8, 0.6)));
        const double dt = 0.5 * 0.1 / (c + 5.0);
        while (s.time < 2.0) advance(s, dt);
        const double rest = s.rigid[0].center_in_box(s.grid.layout.cell_size)[2];
        CHECK(rest == doctest::Approx(0.4).epsilon(0.06));  // within a quarter of a cell
        while (s.time < 20.0) advance(s, dt);
        CHECK(s.rigid[0].center_in_box(s.grid.layout.cell_size)[2] == doctest::Approx(rest).epsilon(1e-3));
        CHECK(s.rigid[0].velocity.norm() < 0.05);
    }
}

TEST_CASE("a tilted bar dropped on a dry bottom comes to rest") {
    const ThreadLimit serial(1);
    for (const double degrees : {2.0, 15.0, 30.0, 45.0}) {
        CAPTURE(degrees);
        auto s = make_simulation<2, float>(tilted_bar(degrees));
        const RigidBody& bar = s.rigid[0];
        try {
            while (s.time < 2.0) advance(s, stable_time_step(s));
            CHECK(bar.velocity.norm() < 0.3);
            CHECK(distance_from_walls(s) > -0.25 * s.grid.layout.cell_size);
            // What remains is what gravity gives in one step of 22 ms; shorter steps leave less.
            while (s.time < 2.5) advance(s, 0.002);
        } catch (const NumericsError& error) {
            FAIL_CHECK(std::string(error.what()));
            continue;
        }
        CHECK(bar.velocity.norm() + bar.radius * bar.angular_velocity.norm() < 0.05);
        CHECK(distance_from_walls(s) > -1e-3);
        CHECK(bar.center_in_box(s.grid.layout.cell_size)[2] == doctest::Approx(0.0875).epsilon(0.02));
    }
}

TEST_CASE("a floating block keeps its draft and no water leaks into it") {
    // Density 920: 0.46 of the block's 0.5 m under water. One second is 1600 steps.
    auto start = test::tank_start<2>(0.05, {40, 30}, 1.0, 31.0, 0.5, Vector<2, double>(0.75, 0.54));
    auto s = make_simulation<2, float>(start);
    while (s.time < 1.0) advance(s, stable_time_step(s));
    const RigidBody& body = s.rigid[0];
    CHECK(body.center_in_box(0.05)[2] == doctest::Approx(0.79).epsilon(0.005));
    CHECK(std::abs(body.velocity[2]) < 0.02);
    int inside = 0;
    const Eigen::Matrix3d back = body.rotation.toRotationMatrix().transpose();
    const ThreadLimit serial(1);  // the count is not made for several threads
    for_each_particle(s.grid, s.bodies[0], [&](std::size_t, const Index<2>& block, std::size_t p) {
        const auto x = global_position(s.grid.layout, block, s.bodies[0], p);
        const Eigen::Vector3d r = back * (Eigen::Vector3d(x[0], 0.0, x[1]) - body.center_in_box(0.05));
        inside += r.cwiseAbs().maxCoeff() < 0.245;
    });
    CHECK(inside == 0);
}

TEST_CASE("a block that was dropped floats at its draft when it has come to rest") {
    const ThreadLimit serial(1);
    // From 11 cm above its draft; it raises the level of the 4 m tank by 1.4 cm. 10 cells across.
    auto start = test::tank_start<2>(0.05, {80, 30}, 1.0, 62.0, 0.5, Vector<2, double>(1.75, 0.65));
    auto s = make_simulation<2, float>(start);
    double sum = 0.0;
    int samples = 0;
    while (s.time < 5.0) {
        advance(s, stable_time_step(s));
        if (s.time > 2.0) {
            sum += s.rigid[0].center_in_box(s.grid.layout.cell_size)[2];
            ++samples;
        }
    }
    CHECK(std::abs(sum / samples - (1.014 - 0.46 + 0.25)) < 0.5 * 0.05);  // half a cell; 0.42 too high
}

TEST_CASE_TEMPLATE("moving nodes as one keeps their momentum and makes them rigid", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    auto s = make_simulation<D, double>(lone_block<D>());
    const auto& particles = s.bodies[0];
    // Masses and velocities without order on all nodes.
    std::uint64_t n = 0;
    Eigen::Vector3d before = Eigen::Vector3d::Zero(), after = before;
    const auto total = [&] {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const auto& node : s.grid.nodes) {
            for (int axis = 0; axis < D; ++axis) sum[axis] += node[mass_lane] * node[axis];
        }
        return sum;
    };
    for (auto& node : s.grid.nodes) {
        for (int lane = 0; lane < 4; ++lane)
            node[lane] = random_uniform(3, static_cast<std::uint64_t>(lane), n);
        ++n;
    }
    before = total();
    move_nodes_as_one(particles, s.rigid[0], s.grid);
    after = total();
    CHECK((after - before).norm() < 1e-12 * before.norm());
    // Particles whose nodes are all the body's, a cell and a half inside, get the same antisymmetric
    // gradient.
    const ThreadLimit serial(1);
    Matrix<D, double> first = Matrix<D, double>::Zero();
    for_each_motion(s.grid, particles,
                    [&](std::size_t, const Index<D>&, std::size_t p, const Vector<D, double>&,
                        const Matrix<D, double>& gradient) {
                        if (particles.offset[p].cwiseAbs().maxCoeff() > 0.25) return;
                        if (first.isZero()) first = gradient;
                        CHECK((gradient - first).norm() < 1e-12);
                        CHECK((gradient + gradient.transpose()).norm() < 1e-12);
                    });
    CHECK(first.norm() > 1e-6);
}
