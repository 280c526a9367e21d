// A wave maker: the left wall as a piston, a plane at X(t) that moves at U(t) and starts at rest from x = 0.
//
// solitary   A wave of height H on water of depth D (Goring 1979, "Tsunamis", Caltech KH-R-38, eq. 3.17).
//            The piston follows the mean flow under the wave, U = c η/(D + η), with η(X, t) =
//            H sech²(κ(ct − X)), κ = √(3H/4D³) and c = √(g(D + H)). Its integral is
//            X = (H/κD) tanh(κ(ct − X)), from mid-stroke. The tails are cut off where κ(ct − X) = ∓3.8;
//            the stroke is 1.998 H/κD.
//
// sine       X = a (1 − cos ωt) r(t), with r = (1 − cos(πt/ramp))/2 until t = ramp and r = 1 afterwards.
//            Small waves have the height 2a · 2(cosh 2kD − 1)/(sinh 2kD + 2kD), with ω² = gk tanh kD
//            (Dean & Dalrymple 1991, eq. 6.25).
//
// Nodes behind the plane and up to wall_reach cells in front of it get v_x = U. This is of first order in
// space; since water next to the plane moves with it, a node changes little when the plane passes it. At 24
// cells of depth a wave of 0.2 D still has 0.968 of that height after 10 D.
//
// Test: tests/unit/mpm/flume_test.cpp.
#pragma once

#include "mpm/boundaries/wall.h"

namespace tidewater::mpm {

enum class PistonMotion { solitary, sine };

struct Piston {
    PistonMotion motion = PistonMotion::solitary;
    double height = 0.0;     // m, H
    double depth = 0.0;      // m, D
    double gravity = 9.81;   // m/s²
    double amplitude = 0.0;  // m, a: half of the stroke of a sine
    double period = 0.0;     // s, 2π/ω of a sine
    double ramp = 0.0;       // s, until a sine has its full stroke

    bool exists() const { return height > 0.0 || amplitude > 0.0; }
    double position(double time) const;  // X, m; 0 before time 0
    double velocity(double time) const;  // U, m/s

    template <int D>
    struct Acting {
        const Layout<D>& layout;
        bool exists;
        int last = 0;           // nodes up to this number along x move with the plane
        double velocity = 0.0;  // m/s

        const Acting* on(const Index<D>& block) const {
            return exists && layout.first_node(block[0]) <= last ? this : nullptr;
        }
        template <class Real>
        void act(const NodeAt<D>& at, Node<Real>& at_node, WallAction<D>&) const {
            if (at.node[0] <= last) at_node[0] = static_cast<Real>(velocity);
        }
        // The plane's work is its impulse times its speed.
        void account(WallAction<D>& action) const { action.work = action.impulse[0] * velocity; }
    };
    template <int D>
    Acting<D> acting(const Layout<D>& layout, const BoundaryStep& step) const {
        if (!exists()) return {layout, false};
        const double time = step.time.value_or(0.0);
        const double reach = position(time) / layout.cell_size + wall_reach;
        return {layout, true, static_cast<int>(std::floor(reach)), velocity(time)};
    }

    bool replaces_left_wall() const { return exists(); }
    template <int D>
    bool hides_fill(const Layout<D>&) const {
        return exists();
    }
    template <int D>
    bool hides_fill_at(const Layout<D>& layout, double time, const Index<D>& node) const {
        return exists() && behind(node[0], position(time), 2.0, layout.cell_size);
    }
};

}  // namespace tidewater::mpm
