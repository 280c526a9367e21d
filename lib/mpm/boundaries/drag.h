// Drag of the ground on water.
//
//     τ = ρw C |u| u       Pa, against the flow; u: velocity of the water along the ground
//     C = C_d              the coefficient, 0.002 to 0.005 over sand and mud (Soulsby 1997)
//     C = g n²/h^(1/3)     by Manning's n, s/m^(1/3): 0.02 to 0.035 for natural beds (Chow 1959); h: depth, m
//
// u is the part along the ground of the water's mean velocity, by mass, two to four cells above it: within
// two cells the scheme itself slows water that should glide by up to a sixth (lib/mpm/README.md, Known
// errors). Where there is less than a cell of water so high, it is that of all water below. τ acts on the
// whole column, which slows by the same Δu everywhere,
//
//     Δu = u K/(1 + K),      K = C |u| Δt/(h n_z)
//
// (n_z: of the ground's normal; implicit, so that the flow never turns round). Real turbulence carries the
// drag upward; water here has no mixing of its own, so that drag on the lowest nodes alone would only stop
// a layer of a few cells, over which the rest would run ever faster. u near the ground, not the mean over the
// column, is what slows short waves, which hardly reach the ground.
//
// h is the mass of the column, ice included, over ρw and the column's plan area. Columns on the box's side
// walls take the h of the next one inside. The front of a shelf has no drag.
//
// Source: Soulsby (1997), Dynamics of marine sands; Chow (1959), Open-channel hydraulics.
// Tests: tests/unit/mpm/step/slow_columns_test.cpp, tests/validation/ground_test.cpp,
// tests/validation/ground_wave_test.cpp.
#pragma once

#include "mpm/boundaries/columns.h"
#include "mpm/boundaries/wall.h"

namespace tidewater::mpm {

// One of the two is given, or none.
struct DragLaw {
    double coefficient = 0.0;  // C_d ≥ 0
    double manning = 0.0;      // n ≥ 0, s/m^(1/3)

    bool exists() const { return coefficient > 0.0 || manning > 0.0; }
    double at_depth(double depth, double gravity) const {  // C
        return manning > 0.0 ? gravity * manning * manning / std::cbrt(depth) : coefficient;
    }
};

struct Drag {
    DragLaw bed, shelf;

    bool exists() const { return bed.exists() || shelf.exists(); }

    template <int D>
    struct Acting {
        Columns<D> columns;
        bool exists;
        std::span<const double> slowing;  // [column][axis] Δu, m/s (mpm/step/slow_columns.h)

        const Acting* on(const Index<D>&) const { return slowing.empty() ? nullptr : this; }
        bool tells_matter(const Index<D>&) const { return exists; }
        template <class Real>
        void act(const NodeAt<D>& at, Node<Real>& velocity, WallAction<D>& action) const {
            if (at.matter != Material::water) return;
            const auto column = columns.place(at.node);
            if (!column) return;
            const Eigen::Map<const Vector<D, double>> slower(&slowing[*column * D]);
            if (slower.isZero(0.0)) return;
            const double before = kinetic_energy_of<D>(velocity);
            velocity.template head<D>() -= slower.template cast<Real>().array();
            action.drag_work += kinetic_energy_of<D>(velocity) - before;
        }
    };
    template <int D>
    Acting<D> acting(const Layout<D>& layout, const BoundaryStep& step) const {
        return {Columns<D>(layout), exists(), step.slowing};
    }

    bool tells_matter() const { return exists(); }
};

}  // namespace tidewater::mpm
