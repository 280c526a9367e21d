#include "mpm/step/matter.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/spline.h"
#include "support/mixed_tank.h"
#include "support/rough_ground.h"
#include "support/state.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

// The masses of ice and of all particles at a node, from every particle and, beyond the walls, its images.
template <int D>
std::pair<double, double> masses_at(const Simulation<D, double>& s, const Index<D>& node) {
    const double dx = s.grid.layout.cell_size;
    double ice = 0.0, all = 0.0;
    for (const auto& particles : s.bodies) {
        for_each_particle(s.grid, particles, [&](std::size_t, const Index<D>& block, std::size_t p) {
            const auto x = global_position(s.grid.layout, block, particles, p);
            double weight = particles.mass;
            for (int axis = 0; axis < D; ++axis) {
                const auto a = static_cast<std::size_t>(axis);
                const double at = x[axis] / dx, last = s.grid.layout.cells[a];
                // A node just inside has what the node beyond the wall would have.
                double along = quadratic_spline(at - node[a]);
                if (node[a] == 1) along += quadratic_spline(at + 1.0);
                if (node[a] == s.grid.layout.cells[a] - 1) along += quadratic_spline(at - (last + 1.0));
                weight *= along;
            }
            all += weight;
            if (particles.material == Material::ice) ice += weight;
        });
    }
    return {ice, all};
}

template <int D>
NodeMatter<double> matter_of(const Simulation<D, double>& s) {
    return find_matter<D, double>(s.parameters.boundaries, BoundaryStep{},
                                  Slots::all(s.grid.node_blocks.size()), s.bodies, s.grid);
}

}  // namespace

TEST_CASE_TEMPLATE("a node is ice where more than half of its mass is", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    const ThreadLimit one(1);  // masses_at sums over blocks
    auto s = make_simulation<D, double>(test::on_rough_ground(test::mixed_tank<D>()));
    for (int n = 0; n < 50; ++n) advance(s, stable_time_step(s));
    // As after a pass: the masses of the nodes are those of the particles where they are now.
    advance(s, stable_time_step(s));
    const auto matter = matter_of(s);
    long ice_nodes = 0, checked = 0;
    for (std::size_t slot = 0; slot < s.grid.node_blocks.size(); ++slot) {
        const auto of_block = matter.of(slot);
        for (int n = 0; n < Block<D>::nodes; ++n) {
            const auto& node = s.grid.block_nodes(slot)[n];
            const Index<D> at = node_at(s.grid.layout, block_at<D>(s.grid.node_blocks[slot]), n);
            if (!(node[mass_lane] > 0.0) || (n + static_cast<int>(slot)) % 3 != 0) continue;
            const auto [ice, all] = masses_at(s, at);
            REQUIRE(node[mass_lane] == doctest::Approx(all).epsilon(1e-9));
            if (std::abs(ice / all - 0.5) < 1e-9) continue;
            const bool is_ice = of_block.of(n, node) == Material::ice;
            CHECK(is_ice == (ice > 0.5 * all));
            ice_nodes += is_ice;
            ++checked;
        }
    }
    CHECK(ice_nodes > 0);
    CHECK(ice_nodes < checked);
}

TEST_CASE("where nothing tells ice and water apart, no mass of ice is summed") {
    auto plain = make_simulation<2, double>(test::mixed_tank<2>());
    CHECK(matter_of(plain).of_block.empty());
    auto only_water =
        make_simulation<2, double>(test::on_rough_ground(test::tank_start<2>(0.1, {20, 10}, 0.5, 30.0)));
    const auto matter = matter_of(only_water);
    CHECK(matter.of_block.empty());
    CHECK(matter.everywhere == Material::water);
}
