#include "mpm/bodies/collide.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include <algorithm>
#include <cmath>

#include "mpm/state/ledger.h"
#include "mpm/step/start.h"
#include "mpm/step/step.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

// Bodies alone in a dry box of 3 m.
template <int D>
Start<D> dry(std::initializer_list<RigidStart<D>> bodies, double gravity = 9.81) {
    Start<D> start;
    start.cell_size = 0.1;
    start.cells.fill(30);
    start.parameters.gravity = gravity;
    start.rigid = bodies;
    return start;
}

// The least height of a body's corners above the bottom, m.
double lowest(const RigidBody& body, double cell_size) {
    double least = 1e9;
    for (const Eigen::Vector3d& point : body.surface) {
        least = std::min(least, (body.center_in_box(cell_size) + body.rotation * point)[2]);
    }
    return least;
}

}  // namespace

TEST_CASE_TEMPLATE(
    "a body dropped on the bottom comes to rest on it at once and stays, for steps of any size", Dimension,
    std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    const Vector<D, double> size = Vector<D, double>::Constant(0.8);
    Vector<D, double> center = Vector<D, double>::Constant(1.5);
    center[D - 1] = 1.0;
    for (const double dt : {1e-4, 5e-3}) {
        auto s = make_simulation<D, float>(dry<D>({{.size = size, .center = center}}));
        while (s.time < 1.0) advance(s, dt);
        CHECK(std::abs(lowest(s.rigid[0], 0.1)) < 1e-9);
        CHECK(s.rigid[0].velocity.norm() < 1e-9);
        CHECK(max_speed(s.rigid[0]) < 1e-9);
        const double impulse = 9.81 * s.rigid[0].mass * s.motion_time();
        CHECK(s.accounts.wall_impulse[D - 1] == doctest::Approx(impulse).epsilon(1e-9));
    }
}

TEST_CASE("a tilted bar dropped on the bottom falls flat and lies still") {
    for (const double degrees : {2.0, 15.0, 45.0, 80.0}) {
        CAPTURE(degrees);
        auto s = make_simulation<2, float>(
            dry<2>({{.size = {1.2, 0.2}, .center = {1.5, 1.5}, .angle = degrees * M_PI / 180.0}}));
        double highest = -1e9;
        while (s.time < 4.0) {
            advance(s, std::min(stable_time_step(s), 5e-4));
            CHECK(lowest(s.rigid[0], 0.1) > -1e-3);
            const auto ledger = take_ledger(s);
            highest = std::max(highest, ledger.kinetic + ledger.gravitational);
        }
        CHECK(highest < 1.001 * 9.81 * s.rigid[0].mass * 1.5);
        CHECK(max_speed(s.rigid[0]) < 1e-3);
        const bool flat = std::abs(s.rigid[0].center_in_box(0.1)[2] - 0.1) < 1e-3;
        const bool upright = std::abs(s.rigid[0].center_in_box(0.1)[2] - 0.6) < 1e-3;
        CHECK((flat || (upright && degrees == 80.0)));
    }
}

TEST_CASE_TEMPLATE("two bodies that meet keep their momenta, do not overlap and go on together", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    RigidStart<D> fast, slow;
    fast.size = Vector<D, double>::Constant(0.4);
    slow.size = Vector<D, double>::Constant(0.6);
    fast.center = Vector<D, double>::Constant(1.5);
    slow.center = fast.center;
    fast.center[0] = 0.8, slow.center[0] = 1.8;
    fast.velocity[0] = 1.0;
    fast.friction = 0.0;
    auto s = make_simulation<D, double>(dry<D>({fast, slow}, 0.0));
    const double momentum = s.rigid[0].mass;
    while (s.time < 1.5) advance(s, 1e-2);
    const double sum = s.rigid[0].mass + s.rigid[1].mass;
    for (const RigidBody& body : s.rigid) {
        CHECK(body.velocity[0] == doctest::Approx(momentum / sum));
        CHECK(body.angular_velocity.norm() < 1e-9);
    }
    const double between = s.rigid[1].center_in_box(0.1)[0] - s.rigid[0].center_in_box(0.1)[0];
    CHECK(between == doctest::Approx(0.5).epsilon(1e-6));
    CHECK(s.rigid[0].contact_impulse.isApprox(-s.rigid[1].contact_impulse));
    CHECK(s.accounts.wall_impulse.isZero());
}

TEST_CASE("a body that hits another off its middle turns both, and angular momentum is kept") {
    RigidStart<2> a, b;
    a.size = b.size = Vector<2, double>(0.4, 0.4);
    a.center = {0.8, 1.5};
    b.center = {1.6, 1.75};
    a.velocity = {1.0, 0.0};
    b.angle = 0.2;
    auto s = make_simulation<2, double>(dry<2>({a, b}, 0.0));
    const auto angular = [&] {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const RigidBody& body : s.rigid) {
            sum += body.angular_momentum + body.center_in_box(0.1).cross(body.mass * body.velocity);
        }
        return sum;
    };
    const Eigen::Vector3d before = angular();
    while (s.time < 1.0) advance(s, 5e-3);
    CHECK(s.rigid[1].angular_velocity.norm() > 0.1);
    CHECK((angular() - before).norm() < 1e-4 * before.norm());  // pushing back moves bodies
    CHECK((s.rigid[0].mass * s.rigid[0].velocity + s.rigid[1].mass * s.rigid[1].velocity)
              .isApprox(s.rigid[0].mass * Eigen::Vector3d(1.0, 0.0, 0.0), 1e-9));
}

TEST_CASE("bodies stand on each other") {
    RigidStart<2> low, high;
    low.size = high.size = Vector<2, double>(0.6, 0.4);
    low.center = {1.5, 0.25};
    high.center = {1.6, 0.75};
    auto s = make_simulation<2, double>(dry<2>({low, high}));
    while (s.time < 1.0) advance(s, 2e-3);
    CHECK(s.rigid[0].center_in_box(0.1)[2] == doctest::Approx(0.2).epsilon(1e-3));
    CHECK(s.rigid[1].center_in_box(0.1)[2] == doctest::Approx(0.6).epsilon(1e-3));
    CHECK(max_speed(s.rigid[1]) < 1e-6);
}

TEST_CASE("a body slides down a bed by g sin alpha") {
    for (const double degrees : {10.0, 30.0}) {
        const double slope = std::tan(degrees * M_PI / 180.0), cosine = std::cos(degrees * M_PI / 180.0);
        RigidStart<2> body;
        body.size = {0.4, 0.2};
        body.angle = degrees * M_PI / 180.0;
        // Its lower face on the bed.
        body.center = Vector<2, double>(2.0, 2.0 * slope) +
                      0.1 * Vector<2, double>(-std::sin(body.angle), std::cos(body.angle));
        auto start = dry<2>({body});
        Bed<2>& bed = start.parameters.boundaries.bed;
        bed.spacing = 0.1;
        bed.points = {31};
        for (int n = 0; n <= 30; ++n) bed.heights.push_back(slope * 0.1 * n);
        auto s = make_simulation<2, double>(start);
        const Eigen::Vector3d from = s.rigid[0].center;
        while (s.time < 0.5) advance(s, 1e-3);
        const double way = 0.5 * 9.81 * std::sin(body.angle) * s.time * s.time;
        CHECK((s.rigid[0].center - from).norm() == doctest::Approx(way).epsilon(0.01));
        CHECK((s.rigid[0].center - from)[0] == doctest::Approx(-way * cosine).epsilon(0.01));
        CHECK(s.rigid[0].angular_velocity.norm() < 1e-3);
    }
}
