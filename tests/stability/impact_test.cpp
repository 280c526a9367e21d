// Ice that hits walls, floors and other ice, whole or one particle thick.
#include <doctest/doctest.h>

#include "support/box.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

template <int D>
Vector<D, double> at(double x, double across, double z) {
    Vector<D, double> point = Vector<D, double>::Constant(across);
    point[0] = x;
    point[D - 1] = z;
    return point;
}

template <int D>
void throw_body(const Vector<D, double>& velocity, typename Start<D>::Body& body) {
    body.velocity.assign(body.points.size(), velocity);
}

// A sheet half a cell thick, one particle, that stands across x; with `block`, on the side of one.
template <int D>
Start<D> thrown_sheet(bool block, WallRule rule) {
    auto start = test::long_ice_box<D>(20, 16);
    for (auto& axis : start.parameters.boundaries.walls) axis = {rule, rule};
    const auto sheet = test::box_shape<D>(at<D>(9.0, 4.0, 3.0), at<D>(9.5, 12.0, 13.0));
    const auto cube = test::box_shape<D>(at<D>(5.0, 6.0, 6.0), at<D>(9.0, 10.0, 10.0));
    auto& body = test::add_ice<D>([&](const auto& x) { return sheet(x) || (block && cube(x)); }, start);
    throw_body<D>(at<D>(30.0, 0.0, -15.0), body);
    return start;
}

// A block just above the floor, that has fallen by 4 m.
template <int D>
Start<D> fallen_block(const IceModel& ice) {
    auto start = test::long_ice_box<D>(20, 12, 9.81);
    start.parameters.ice = ice;
    auto& body = test::add_ice<D>(test::box_shape<D>(at<D>(6.0, 3.0, 0.5), at<D>(12.0, 9.0, 6.5)), start);
    throw_body<D>(at<D>(0.0, 0.0, -std::sqrt(2 * 9.81 * 4.0)), body);
    return start;
}

// Single particles: a falling one, two that meet, one that follows a wall, one in a corner.
template <int D>
Start<D> single_particles() {
    auto start = test::long_ice_box<D>(20, 12, 9.81);
    auto& body = start.bodies.emplace_back();
    body.material = Material::ice;
    body.points = {at<D>(3.3, 5.1, 4.0), at<D>(8.0, 6.0, 6.0), at<D>(12.0, 6.0, 6.2), at<D>(0.01, 6.2, 6.7),
                   at<D>(19.99, 0.01, 0.01)};
    body.velocity = {at<D>(0.0, 0.0, 0.0), at<D>(20.0, 0.0, 1.0), at<D>(-20.0, 0.0, 1.0),
                     at<D>(0.0, 1.0, -5.0), at<D>(50.0, -30.0, -30.0)};
    body.volume = std::pow(0.5, D) * static_cast<double>(body.points.size());
    body.mass = start.parameters.ice.density * body.volume;
    return start;
}

}  // namespace

TEST_CASE_TEMPLATE("sheets one particle thick hit walls", Engine, TIDEWATER_ENGINES) {
    for (const WallRule rule : {WallRule::slip, WallRule::stick, WallRule::separate}) {
        for (const bool block : {false, true}) {
            CAPTURE(block);
            auto s = make_simulation<Engine::D, typename Engine::Real>(thrown_sheet<Engine::D>(block, rule));
            test::check_run(0.5, s);
        }
    }
}

TEST_CASE_TEMPLATE("single particles fall, meet and lie in corners", Engine, TIDEWATER_ENGINES) {
    for (const bool fracture : {true, false}) {
        auto start = single_particles<Engine::D>();
        start.parameters.ice.fracture = fracture;
        auto s = make_simulation<Engine::D, typename Engine::Real>(start);
        test::check_run(1.5, s);
    }
}

TEST_CASE_TEMPLATE("a block that hits a wall at 100 m/s breaks and stays in the box", Engine,
                   TIDEWATER_ENGINES) {
    for (const bool cap : {true, false}) {
        IceModel ice;
        ice.cap_hardening = cap;
        auto start = fallen_block<Engine::D>(ice);
        throw_body<Engine::D>(at<Engine::D>(100.0, 0.0, 0.0), start.bodies[0]);
        auto s = make_simulation<Engine::D, typename Engine::Real>(start);
        test::check_run(0.4, s);
        CHECK(test::failed_share(s.bodies[0]) > 0.05);
    }
}

TEST_CASE_TEMPLATE("ice from soft to stiff falls onto a floor", Dimension, std::integral_constant<int, 2>,
                   std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    for (const double modulus : {1e7, 1e8, 1e9, 1e10, 5e10}) {
        for (const bool fracture : {true, false}) {
            CAPTURE(modulus);
            CAPTURE(fracture);
            IceModel ice;
            ice.youngs_modulus = modulus;
            ice.fracture = fracture;
            auto s = make_simulation<D, float>(fallen_block<D>(ice));
            test::check_run(0.15, s);
        }
    }
}
