#include "mpm/boundaries/ground.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Sliding coulomb(double friction) {
    Sliding law;
    law.friction = friction;
    return law;
}

// A node of mass 2 of level ground and 3 m², over which a step of 0.1 s is made.
struct Met {
    Vector<2, double> velocity;
    double friction_work = 0.0;
};
Met meet(const GroundRule& rule, Material matter, double along, double up, float* grip = nullptr) {
    const Footing<2> footing{.normal = {0.0, 1.0}, .height = 5.0, .area = 3.0, .room = 1e-6};
    Node<double> node(along, up, 0.0, 2.0);
    WallAction<2> action;
    meet_ground<2, double>(rule, footing, 0.1, {.node = {}, .matter = matter, .grip = grip}, node, action);
    return {node.head<2>().matrix(), action.friction_work};
}

}  // namespace

TEST_CASE("Coulomb's friction takes what it can, and all that there is if that is less") {
    CHECK(sliding_speed(coulomb(0.3), 2.0, 0.5, 0.0) == 1.5);
    CHECK(sliding_speed(coulomb(0.3), 0.4, 0.5, 0.0) == 0.0);
    CHECK(sliding_speed(coulomb(infinity), 9.0, infinity, 0.0) == 0.0);
    CHECK(sliding_speed(coulomb(0.3), 0.0, 0.5, 0.0) == 0.0);
}

TEST_CASE("Weertman's law and the regularised one are solved to rounding, from creep to any speed") {
    for (const double exponent : {1.0, 3.0, 5.0}) {
        for (const double speed : {1e-9, 1e-3, 1.0, 30.0}) {
            for (const double taken : {1e-6, 0.1, 40.0}) {
                CAPTURE(exponent);
                CAPTURE(speed);
                CAPTURE(taken);
                Sliding law;
                law.weertman = 1.0;
                law.exponent = exponent;
                const double weertman = sliding_speed(law, speed, 0.0, taken);
                CHECK(weertman + taken * std::pow(weertman, 1.0 / exponent) ==
                      doctest::Approx(speed).epsilon(1e-11));
                law = coulomb(0.5);
                law.exponent = exponent;
                law.regular_speed = 1e-5;
                const double left = sliding_speed(law, speed, taken, 0.0);
                CHECK(left > 0.0);
                CHECK(left + taken * std::pow(left / (left + law.regular_speed), 1.0 / exponent) ==
                      doctest::Approx(speed).epsilon(1e-8));
            }
        }
    }
}

TEST_CASE("of Coulomb's and Weertman's laws the smaller resists") {
    Sliding law = coulomb(0.5);
    law.weertman = 1.0;
    CHECK(sliding_speed(law, 8.0, 3.0, 0.1) == doctest::Approx(8.0).epsilon(0.03));  // 0.1 · 2 < 3
    CHECK(sliding_speed(law, 8.0, 3.0, 100.0) == 5.0);
}

TEST_CASE("ice rubs by its coefficient times what presses, water glides, and what lifts off is free") {
    GroundRule rule;
    rule.ice = coulomb(0.25);
    const Met ice = meet(rule, Material::ice, 3.0, -4.0);
    CHECK(ice.velocity.isApprox(Vector<2, double>(2.0, 0.0)));
    CHECK(ice.friction_work == doctest::Approx(-2.0 * 1.0 * 2.0));  // impulse times the speed left
    const Met held = meet(rule, Material::ice, -0.5, -4.0);
    CHECK(held.velocity.isZero());
    CHECK(held.friction_work == 0.0);  // what stands takes no work
    CHECK(meet(rule, Material::ice, 3.0, 0.5).velocity == Vector<2, double>(3.0, 0.5));
    const Met water = meet(rule, Material::water, 3.0, -4.0);
    CHECK(water.velocity == Vector<2, double>(3.0, 0.0));
    CHECK(water.friction_work == 0.0);
    rule.ice = coulomb(infinity);
    CHECK(meet(rule, Material::ice, 3.0, -1e-6).velocity.isZero());
    CHECK(meet(rule, Material::ice, 3.0, 1e-6).velocity == Vector<2, double>(3.0, 1e-6));
}

TEST_CASE("ground may hold the water, or hold down what lifts off") {
    GroundRule rule;
    rule.holds_water = true;
    CHECK(meet(rule, Material::water, 3.0, 0.5).velocity.isZero());
    CHECK(meet(rule, Material::ice, 3.0, -1.0).velocity == Vector<2, double>(3.0, 0.0));
    rule = {};
    rule.holds_down = true;
    for (const Material matter : {Material::water, Material::ice})
        CHECK(meet(rule, matter, 3.0, 0.5).velocity == Vector<2, double>(3.0, 0.0));
}

TEST_CASE("the sea's pressure at the ground carries its share of the ice") {
    GroundRule rule;
    rule.ice = coulomb(0.5);
    rule.sea_level = 7.0;  // 2 m above the ground
    rule.sea_weight = 10.0;
    for (const double share : {0.0, 0.5, 1.0}) {
        CAPTURE(share);
        rule.ice.pore_pressure = share;
        // The pressure's impulse on 3 m² in 0.1 s, by the mass of 2 kg: 20 Pa · 3 · 0.1/2 = 3 m/s.
        CHECK(meet(rule, Material::ice, 9.0, -4.0).velocity[0] ==
              doctest::Approx(9.0 - 0.5 * (4.0 - 3.0 * share)));
    }
    CHECK(meet(rule, Material::ice, 9.0, -2.5).velocity[0] == 9.0);  // it floats
    rule.sea_level = 4.0;
    CHECK(meet(rule, Material::ice, 9.0, -4.0).velocity[0] == 7.0);  // dry
}

TEST_CASE("a second meeting in the same step goes on with the grip that the first left") {
    GroundRule rule;
    rule.ice = coulomb(0.25);
    float grip = 0.0f;
    CHECK(meet(rule, Material::ice, 0.4, -4.0, &grip).velocity.isZero());
    CHECK(grip == doctest::Approx(0.6));
    CHECK(meet(rule, Material::ice, -0.2, 0.0, &grip).velocity.isZero());
    CHECK(grip == doctest::Approx(0.4));
    const Met lifted = meet(rule, Material::ice, 0.5, 0.4, &grip);  // 0.1 of the grip is gone
    CHECK(lifted.velocity[0] == doctest::Approx(0.2));
    CHECK(lifted.velocity[1] == doctest::Approx(0.4));
    CHECK(grip == doctest::Approx(0.0));
    CHECK(meet(rule, Material::ice, 0.5, 0.4, &grip).velocity == Vector<2, double>(0.5, 0.4));
}
