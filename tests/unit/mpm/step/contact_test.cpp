#include "mpm/step/contact.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "mpm/bodies/lift.h"
#include "mpm/state/ledger.h"
#include "mpm/step/settle.h"
#include "support/tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

// Two bodies next to each other in water without weight, turned; their room overlaps at some nodes.
template <int D>
Start<D> two_bodies(BodyContact contact, double friction) {
    Index<D> cells;
    cells.fill(D == 2 ? 30 : 16);
    auto start = test::tank_start<D>(0.05, cells, D == 2 ? 1.5 : 0.8, 20.0);
    start.parameters.gravity = 0.0;
    Vector<D, double> center = Vector<D, double>::Constant(D == 2 ? 0.7 : 0.4);
    for (const double right : {-0.14, 0.14}) {
        RigidStart<D> body;
        body.size = Vector<D, double>::Constant(0.2);
        body.center = center;
        body.center[0] += right;
        body.angle = 3.0 * right;
        body.contact = contact;
        body.friction = friction;
        body.spin = 0.4;
        start.rigid.push_back(body);
    }
    return start;
}

// Of nodes and bodies together, about the box's corner.
template <int D>
std::array<Eigen::Vector3d, 2> momenta(const Simulation<D, double>& s) {
    std::array<Eigen::Vector3d, 2> sum{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    const double dx = s.grid.layout.cell_size;
    for (std::size_t slot = 0; slot < s.grid.node_blocks.size(); ++slot) {
        const auto block = block_at<D>(s.grid.node_blocks[slot]);
        for (int n = 0; n < Block<D>::nodes; ++n) {
            const auto& node = s.grid.block_nodes(slot)[n];
            const Index<D> at = node_at(s.grid.layout, block, n);
            Vector<D, double> x;
            for (std::size_t axis = 0; axis < D; ++axis) x[static_cast<int>(axis)] = dx * at[axis];
            const Eigen::Vector3d impulse =
                node[mass_lane] * lift<D>(node.template head<D>().matrix().eval());
            sum[0] += impulse;
            sum[1] += lift<D>(x).cross(impulse);
        }
    }
    for (const RigidBody& body : s.rigid) {
        sum[0] += body.mass * body.velocity;
        sum[1] += body.center_in_box(dx).cross(body.mass * body.velocity) + body.angular_momentum;
    }
    return sum;
}

template <int D>
void shake(Simulation<D, double>& s) {
    std::uint64_t n = 0;
    for (auto& node : s.grid.nodes) {
        for (int lane = 0; lane < D; ++lane)
            node[lane] = random_uniform(3, static_cast<std::uint64_t>(lane), n) - 0.5;
        ++n;
    }
}

}  // namespace

TEST_CASE_TEMPLATE("bodies and nodes keep both momenta and lose energy, whatever the contact", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    for (const auto& [contact, friction] :
         {std::pair{BodyContact::stick, 0.0}, std::pair{BodyContact::slip, 0.0},
          std::pair{BodyContact::slip, 0.4}}) {
        CAPTURE(static_cast<int>(contact));
        CAPTURE(friction);
        auto s = make_simulation<D, double>(two_bodies<D>(contact, friction));
        shake(s);
        const auto before = momenta(s);
        const auto nodes = s.grid.nodes;
        const auto energy = [&] {
            double sum = 0.0;
            for (const auto& node : s.grid.nodes) {
                sum += 0.5 * node[mass_lane] * node.template head<D>().square().sum();
            }
            for (const RigidBody& body : s.rigid) sum += kinetic_energy(body);
            return sum;
        };
        const double start_energy = energy();
        resolve_contacts({.dt = 1e-3}, s.parameters.boundaries, s.grid, s.rigid, s.accounts);
        const auto after = momenta(s);
        CHECK((after[0] - before[0]).norm() < 1e-11 * before[0].norm());
        CHECK((after[1] - before[1]).norm() < 1e-11 * before[1].norm());
        CHECK(energy() < start_energy);
        CHECK(s.accounts.wall_impulse.isZero());
        for (const RigidBody& body : s.rigid) {  // what they got is what is booked
            const Eigen::Vector3d booked = body.water_impulse + body.contact_impulse;
            CHECK((body.mass * body.velocity - booked).norm() < 1e-11 * booked.norm());
        }
    }
}

TEST_CASE("nodes that slip keep what goes along the face, those that leave it all that they have") {
    auto start = test::tank_start<2>(0.05, {40, 30}, 1.5, 20.0, 0.5, {0.75, 0.5});
    start.parameters.gravity = 0.0;
    start.rigid[0].contact = BodyContact::slip;
    start.rigid[0].density = 1e9;  // does not yield
    auto s = make_simulation<2, double>(start);
    for (auto& node : s.grid.nodes) node.head<2>() = Eigen::Array2d(1.0, 0.3);  // to the right and up
    resolve_contacts({.dt = 1e-3}, s.parameters.boundaries, s.grid, s.rigid, s.accounts);
    const auto velocity_at = [&](int x, int z) {
        const Index<2> block{x / Block<2>::width + 2, z / Block<2>::width + 2};
        const auto found = std::ranges::find(s.grid.node_blocks, block_key<2>(block));
        const auto slot = static_cast<std::size_t>(found - s.grid.node_blocks.begin());
        return s.grid.block_nodes(slot)[x % Block<2>::width * Block<2>::width + z % Block<2>::width];
    };
    const auto left = velocity_at(15, 15), right = velocity_at(25, 15), far = velocity_at(13, 15);
    CHECK(std::abs(left[0]) < 1e-6);
    CHECK(left[1] == doctest::Approx(0.3));
    CHECK(right[0] == 1.0);  // parts
    CHECK(right[1] == 0.3);
    CHECK(far[0] == 1.0);
    // Friction holds what slips back by at most its coefficient times what pressed.
    s.rigid[0].friction = 0.1;
    for (auto& node : s.grid.nodes) node.head<2>() = Eigen::Array2d(1.0, 0.3);
    resolve_contacts({.dt = 1e-3}, s.parameters.boundaries, s.grid, s.rigid, s.accounts);
    CHECK(velocity_at(15, 15)[1] == doctest::Approx(0.2));
    s.rigid[0].friction = 0.5;
    for (auto& node : s.grid.nodes) node.head<2>() = Eigen::Array2d(1.0, 0.3);
    resolve_contacts({.dt = 1e-3}, s.parameters.boundaries, s.grid, s.rigid, s.accounts);
    CHECK(std::abs(velocity_at(15, 15)[1]) < 1e-6);
}

// The block stands in a stream; what drags it is ρ C_d u² on the two faces along the stream.
TEST_CASE("drag along a block's faces is that of its area, and is booked") {
    auto start = test::tank_start<2>(0.05, {60, 50}, 2.5, 20.0, 1.0, {1.0, 0.7});
    start.parameters.gravity = 0.0;
    start.rigid[0].contact = BodyContact::slip;
    start.rigid[0].density = 1e9;  // does not yield
    start.rigid[0].drag = 0.004;
    double mean = 0.0;
    constexpr int places = 8;
    for (int n = 0; n < places; ++n) {  // of the faces between nodes
        auto moved = start;
        moved.rigid[0].center[1] += 0.05 * n / places;
        auto s = make_simulation<2, double>(moved);
        for (auto& node : s.grid.nodes) {
            if (node[mass_lane] > 0.0) node[mass_lane] = 2.5;
            // Presses gently on both faces, so that their nodes are in contact.
            node.head<2>() = Eigen::Array2d(2.0, 0.0);
        }
        for (std::size_t slot = 0; slot < s.grid.node_blocks.size(); ++slot) {
            for (int k = 0; k < Block<2>::nodes; ++k) {
                const auto at = node_at(s.grid.layout, block_at<2>(s.grid.node_blocks[slot]), k);
                s.grid.block_nodes(slot)[k][1] = 0.05 * at[1] > moved.rigid[0].center[1] ? -1e-9 : 1e-9;
            }
        }
        auto free = s;
        free.rigid[0].drag = 0.0;
        const ContactStep step{
            .dt = 1e-3, .force_dt = 1e-3, .gravity = 0.0, .water_density = 1000.0, .held = false};
        resolve_contacts(step, s.parameters.boundaries, s.grid, s.rigid, s.accounts);
        resolve_contacts(step, free.parameters.boundaries, free.grid, free.rigid, free.accounts);
        mean += (s.rigid[0].water_impulse[0] - free.rigid[0].water_impulse[0]) / places;
        CHECK(s.accounts.drag_work ==
              doctest::Approx(-2.0 * (s.rigid[0].water_impulse[0] - free.rigid[0].water_impulse[0]))
                  .epsilon(0.02));
    }
    CHECK(mean == doctest::Approx(1000.0 * 0.004 * 4.0 * 2.0 * 1.0 * 1e-3).epsilon(0.05));
}

TEST_CASE("a wall holds what presses on the other side of a body") {
    // At the left wall, pushed against it by the water: with the body's yielding counted alone the water
    // would follow it into the wall.
    auto start = test::tank_start<2>(0.05, {40, 30}, 1.0, 31.0, 0.5, {0.0, 0.3});
    start.rigid[0].contact = BodyContact::slip;
    auto s = make_simulation<2, double>(start);
    begin_settling(s);
    while (!settle_step(s, 200.0)) {
    }
    const double from = s.rigid[0].center[0];
    for (int n = 0; n < 500; ++n) advance(s, stable_time_step(s));
    CHECK(s.rigid[0].center[0] == doctest::Approx(from).epsilon(1e-9));
    const double pressure = 9810.0 * 0.45 * 0.5;  // N: at the face's mean depth
    CHECK(s.rigid[0].contact_impulse[0] / s.time == doctest::Approx(pressure).epsilon(0.05));
}

TEST_CASE("bodies are held while the water settles, and let go with their start's velocity") {
    auto start = test::tank_start<2>(0.05, {40, 30}, 1.0, 31.0, 0.3, {0.8, 0.5});
    start.rigid[0].velocity = {0.2, 0.1};
    auto s = make_simulation<2, float>(start);
    const Eigen::Vector3d from = s.rigid[0].center;
    begin_settling(s);
    while (!settle_step(s, 500.0)) {
    }
    CHECK(s.rigid[0].center == from);
    CHECK(s.rigid[0].velocity == Eigen::Vector3d(0.2, 0.0, 0.1));
    CHECK(s.rigid[0].water_impulse.isZero(0.0));
    advance(s, stable_time_step(s));
    advance(s, stable_time_step(s));
    CHECK(s.rigid[0].center != from);
}
