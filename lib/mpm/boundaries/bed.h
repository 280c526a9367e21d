// The ground as a height field: z_b over x in 2D, over (x, y) in 3D.
//
// Grid nodes in the ground, and those up to wall_reach cells above it, meet it by its rule
// (mpm/boundaries/ground.h). With the bed's own normal n = (−∇z_b, 1)/√(1 + |∇z_b|²) and a node's distance
// d = (z − z_b) n_z from it, these are the nodes with d < wall_reach Δx.
//
// n is smooth wherever the bed crosses the cells, so that a sliding body feels no steps: on a plane bed all
// forces are along one n, and the body's centre of mass accelerates by g sin α to rounding. At nodes of the
// box's side walls n has no component into the wall, so that the corner between the two holds.
//
// wall_reach is ¾ because a free node nearer to the ground finds too little water below it, sinks, and drives
// currents of decimetres a second. With ¾, pools on beds of any slope and offset stay where they were seeded
// to 0.03 cells, and on average the last node that the bed holds lies where a wall's would. The bed is of
// first order in space.
//
// Test: tests/unit/mpm/boundaries/bed_test.cpp.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/spline.h"
#include "mpm/boundaries/columns.h"
#include "mpm/boundaries/ground.h"

namespace tidewater::mpm {

template <int D>
struct Bed {
    static constexpr int across = D - 1;  // horizontal axes

    GroundRule rule;
    double spacing = 0.0;  // m, of the lattice, which begins at the origin
    std::array<int, static_cast<std::size_t>(across)> points{};  // of the lattice per axis, ≥ 1
    std::vector<double> heights;  // m, z_b at the points, y fastest; empty: no bed

    bool exists() const { return !heights.empty(); }

    // z_b, m: linear between the points, bilinear in 3D, constant beyond them.
    double height(const Vector<across, double>& at) const;
    // ∇z_b by central differences over `reach` (m) to each side.
    Vector<across, double> slope(const Vector<across, double>& at, double reach) const;

    // The ground as a column of nodes along the last axis sees it.
    struct Ground {
        Vector<D, double> normal;  // n, of length 1
        double height = 0.0;       // m, z_b
        double top = 0.0;          // m; the bed acts on nodes below this height
        // m² (m in 2D), of the column, over the sum of the spline's values at the nodes on which it acts.
        double area = 0.0;
        double room = 0.0;  // m³ (m²), of a node above the ground
    };
    Ground ground(const Layout<D>& layout, const Index<across>& column) const;
    // Finds the grounds of all columns in the box once, so that steps need not; the bed must not change
    // after.
    void keep_grounds(const Layout<D>& layout);
    std::vector<Ground> grounds;  // [column], by Columns<D>; empty: found when asked for

    // The ground under one block of nodes.
    struct UnderBlock {
        const Layout<D>& layout;
        const GroundRule& rule;
        double dt;
        Index<D> block;
        std::array<Ground, static_cast<std::size_t>(power(Block<D>::width, across))> columns;
        double top = 0.0;  // m, the highest of the columns

        void narrow(const Index<D>&, NodeBox<D>& box) const {
            box.narrow(block, D - 1, -1e9, std::ceil(top / layout.cell_size));
        }

        template <class Real>
        void act(const NodeAt<D>& at, Node<Real>& velocity, WallAction<D>& action) const {
            Index<across> column;
            for (std::size_t axis = 0; axis < across; ++axis)
                column[axis] = at.node[axis] - layout.first_node(block[axis]);
            const Ground& ground =
                columns[static_cast<std::size_t>(place_of<across>(column, Block<D>::width))];
            const double z = layout.cell_size * at.node[D - 1];
            if (!(z < ground.top)) return;
            Footing<D> footing;
            footing.normal = ground.normal;
            footing.height = ground.height;
            if (rule.ice.needs_area()) {
                const double above = (z - ground.height) / layout.cell_size;
                footing.area = ground.area * quadratic_spline(above);
                footing.room = ground.room * quadratic_spline_integral(above);
            }
            meet_ground(rule, footing, dt, at, velocity, action);
        }
    };
    struct Acting {
        const Layout<D>& layout;
        const Bed& bed;
        double dt;

        // Empty where the ground lies below the block.
        std::optional<UnderBlock> on(const Index<D>& block) const;
        bool tells_matter(const Index<D>& block) const {
            return bed.rule.tells_matter() && on(block).has_value();
        }
    };
    Acting acting(const Layout<D>& layout, const BoundaryStep& step) const {
        return {layout, *this, step.dt};
    }

    bool tells_matter() const { return exists() && rule.tells_matter(); }
    bool hides_fill(const Layout<D>&) const { return exists(); }
    // True where the ground reaches into the support of the node's spline.
    bool hides_fill_at(const Layout<D>& layout, double time, const Index<D>& node) const;
};

}  // namespace tidewater::mpm
