#include "mpm/bodies/rigid.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include <cmath>

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

constexpr double cell = 0.1;

template <int D>
RigidStart<D> turned_box(double degrees) {
    RigidStart<D> start;
    start.size = Vector<D, double>::LinSpaced(1.1, 0.65);
    start.center = Vector<D, double>::LinSpaced(1.0, 1.3);
    start.angle = degrees * M_PI / 180.0;
    return start;
}

template <int D>
Layout<D> layout_of(int cells, Mirror mirror = Mirror::none) {
    Layout<D> layout;
    layout.cell_size = cell;
    layout.cells.fill(cells);
    for (auto& axis : layout.mirrors) axis = {mirror, mirror};
    return layout;
}

// Calls visit(node) for the nodes in the body's reach.
template <int D, class Visit>
void for_each_node(const NodeRange<D>& range, const Visit& visit) {
    for (Index<D> node = range.first;;) {
        visit(node);
        std::size_t axis = D;
        while (axis-- > 0) {
            if (++node[axis] <= range.last[axis]) break;
            node[axis] = range.first[axis];
        }
        if (axis >= D) return;
    }
}

}  // namespace

TEST_CASE("a body's mass and inertia are those of a box") {
    RigidStart<3> start;
    start.size = {3.0, 2.0, 1.0};
    start.center = {5.0, 5.0, 5.0};
    start.angle = M_PI / 2.0;  // x and z change places
    start.velocity = {1.0, 2.0, 3.0};
    start.spin = 2.0;
    const RigidBody body = make_rigid_body(start, cell);
    CHECK(body.mass == doctest::Approx(6.0 * 920.0));
    CHECK(body.center_in_box(cell).isApprox(Eigen::Vector3d(5.0, 5.0, 5.0)));
    CHECK(body.inertia.isApprox(body.mass / 12.0 * Eigen::Vector3d(5.0, 10.0, 13.0)));
    CHECK(world_inertia(body).diagonal().isApprox(body.mass / 12.0 * Eigen::Vector3d(13.0, 10.0, 5.0)));
    CHECK(kinetic_energy(body) == doctest::Approx(0.5 * body.mass * 14.0 + 0.5 * body.inertia[1] * 4.0));
    // From x towards z: what points along x goes up.
    CHECK(body.velocity_at({1.0, 0.0, 0.0}).isApprox(Eigen::Vector3d(1.0, 2.0, 5.0)));
    // The corner that moves fastest: v + ω × r with r = (±½, ±1, ±3/2).
    CHECK(max_speed(body) == doctest::Approx(std::sqrt(16.0 + 4.0 + 16.0)));
}

TEST_CASE("a body in 2D is a box one metre wide") {
    RigidStart<2> start;
    start.size = {0.25, 0.8};
    start.center = {4.0, 1.0};
    const RigidBody body = make_rigid_body(start, cell);
    CHECK(body.mass == doctest::Approx(184.0));
    CHECK(body.inertia[1] == doctest::Approx(184.0 / 12.0 * (0.25 * 0.25 + 0.8 * 0.8)));
}

TEST_CASE("a free body keeps its velocity and its spin for a whole turn") {
    auto start = turned_box<3>(20.0);
    start.velocity = {0.05, 0.0, 0.0};
    start.spin = 2.0 * M_PI;
    RigidBody body = make_rigid_body(start, cell);
    const double energy = kinetic_energy(body);
    for (int n = 0; n < 1000; ++n) move_rigid_body(1e-3, body);
    CHECK(body.center_in_box(cell).isApprox(Eigen::Vector3d(1.05, 1.15, 1.3), 1e-9));
    CHECK(std::abs(body.rotation.dot(make_rigid_body(start, cell).rotation)) ==
          doctest::Approx(1.0).epsilon(1e-9));
    CHECK(kinetic_energy(body) == doctest::Approx(energy).epsilon(1e-12));
}

TEST_CASE("a body that spins about its middle axis tumbles and keeps angular momentum and energy") {
    auto start = turned_box<3>(0.0);
    start.size = {0.6, 0.9, 1.2};
    start.spin = 3.0;
    RigidBody body = make_rigid_body(start, cell);
    body.angular_momentum += Eigen::Vector3d(0.01, 0.0, 0.0) * body.mass;
    body.angular_velocity = world_inertia(body).ldlt().solve(body.angular_momentum);
    const Eigen::Vector3d momentum = body.angular_momentum;
    const double energy = kinetic_energy(body);
    double least = 1.0;
    for (int n = 0; n < 200000; ++n) {
        move_rigid_body(1e-4, body);
        least = std::min(least, (body.rotation * Eigen::Vector3d::UnitY())[1]);
    }
    CHECK(least < -0.9);  // it turned over
    CHECK(body.angular_momentum == momentum);
    CHECK(kinetic_energy(body) == doctest::Approx(energy).epsilon(0.01));
}

TEST_CASE_TEMPLATE("a body's shares of the nodes add up to its volume", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    for (const double degrees : {0.0, 10.0, 35.0, 45.0}) {
        CAPTURE(degrees);
        const auto start = turned_box<D>(degrees);
        const RigidBody body = make_rigid_body(start, cell);
        const auto layout = layout_of<D>(40);
        double sum = 0.0, most = 0.0;
        for_each_node<D>(reach_of(layout, body), [&](const Index<D>& node) {
            const double share = share_of_node(layout, body, node).value;
            sum += share * std::pow(cell, D);
            most = std::max(most, share);
        });
        CHECK(sum == doctest::Approx(start.size.prod()).epsilon(degrees == 0.0 ? 1e-12 : 2e-3));
        CHECK(most == doctest::Approx(1.0).epsilon(1e-12));
    }
}

TEST_CASE("a share's slope is its derivative and points inward") {
    const RigidBody body = make_rigid_body(turned_box<3>(25.0), cell);
    for (const Eigen::Vector3d& point : body.surface) {
        const Eigen::Vector3d arm = body.rotation * (1.05 * point);
        const NodeShare here = share_of<3>(body, cell, arm);
        CHECK(here.slope.dot(arm) < 0.0);
        for (int axis = 0; axis < 3; ++axis) {
            const Eigen::Vector3d step = 1e-6 * Eigen::Vector3d::Unit(axis);
            const double change =
                share_of<3>(body, cell, arm + step).value - share_of<3>(body, cell, arm - step).value;
            CHECK(here.slope[axis] == doctest::Approx(change / 2e-6).epsilon(1e-5));
        }
    }
}

TEST_CASE("at a mirror a body and its image are one: shares are 1 on the plane and even about it") {
    RigidStart<2> start;
    start.size = {0.5, 0.5};
    start.center = {0.25, 1.0};
    const RigidBody body = make_rigid_body(start, cell);
    const auto layout = layout_of<2>(20, Mirror::slip);
    CHECK(share_of_node<2>(layout, body, {0, 10}).value == doctest::Approx(1.0));
    CHECK(share_of_node<2>(layout, body, {0, 10}).slope.norm() < 1e-12);
    CHECK(share_of_node<2>(layout, body, {1, 10}).value == doctest::Approx(1.0));
    CHECK(share_of_node<2>(layout, body, {5, 10}).value == doctest::Approx(0.5));
    for (int n = 1; n <= 3; ++n) {
        CHECK(share_of_node<2>(layout, body, {n, 10}).value ==
              doctest::Approx(share_of_node<2>(layout, body, {-n, 10}).value));
    }
}

TEST_CASE("points within a body fill it evenly") {
    const RigidBody body = make_rigid_body(turned_box<2>(30.0), cell);
    const auto points = points_within<2>(body, cell, 0.05);
    CHECK(points.size() == 22 * 13);
    Vector<2, double> middle = Vector<2, double>::Zero();
    for (const auto& point : points) middle += point / static_cast<double>(points.size());
    CHECK(middle.isApprox(Vector<2, double>(1.0, 1.3)));
}
