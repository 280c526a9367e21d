// The failure of ice: the return to the yield surface of non-associative Cohesive Cam Clay (NACC).
//
//     y  = q² (1+2β) + M² (p + βp0)(p − p0) ≤ 0            yield surface                       eq. 5
//     p0 = κ sinh(ξ max(−α, 0)),  α0 = −asinh(p0/κ)/ξ      hardening; failed where α ≥ 0       eq. 6
//
// A trial state outside of the surface is returned by one of these rules (symbols as in ice.h):
//
//     p > p0       tip: J² ← 1 − 2p0/κ,   b ← J^(2/d) I,  α += ln(J_trial/J)
//     p < −βp0     tip: J² ← 1 + 2βp0/κ,  b ← J^(2/d) I,  α += ln(J_trial/J)
//     else, y > 0  dev b ← r dev b,  then b is scaled so that det b stays J²
//                  r = q_new/q,  q_new = M √((p+βp0)(p0−p)/(1+2β))
//                  α ± ½ ln((1+|dev b|)/(1+r|dev b|)):  + softens, if p ≤ p0(1−β)/2;  − hardens, if above
//
// The surface is the one before α changes, as in the paper. The last rule is the paper's q-based one, with
// z(q)² = 1 + |dev b|. Scaling b keeps p, which keeping tr b would not, and leaves q below q_new by a factor
// 1 − O(strain²). With ShearReturn::trace, tr b is kept instead, as in the authors' code; p then changes, and
// the result need not lie on the surface.
//
// Sources: Wolper et al. (2021), eqs. 5 and 6; lib/mpm/README.md, Ice.
// Tests: tests/unit/mpm/materials/ice_yield_test.cpp and single_point_test.cpp.
#pragma once

#include "mpm/materials/ice.h"

namespace tidewater::mpm {

// Returns a batch of trial states to the yield surface and computes the stress of the result. Where nothing
// yields it costs little more than ice_stress.
// - b stays positive definite: it becomes a convex combination of itself and a multiple of I, scaled.
// - A particle that is elastic, or on its surface within 64 roundings of p0, keeps the bits of ε and α.
// - Failed ice (p0 = 0) returns to b = I, and α grows or shrinks by ln J. With capped hardening α stays ≥ α0.
// - p0 is limited to 0.45 κ, because there is no tip above κ/2. So J² ≥ 0.1 after any return, and a trial
//   J² ≤ 0, which rounding may give for a crushed b, is compression beyond the tip.
// - The trial J² is limited to [1e-4, 1e4]. One step changes α by at most 15, and that only at |ε| = 1e12.
// Returns IceState bits, with ice_unusable if a trial ε is not finite.
//     count            a multiple of `lanes`, up to batch_size
//     strain, alpha    trial state, symmetric_size<D> columns and one; replaced by the returned state
//     kirchhoff        τ, Pa, symmetric_size<D> columns, written
// No two columns may overlap.
template <int D, class Real>
unsigned return_to_yield(const IceConstants<D, Real>& ice, int count, Column<Real>* strain,
                         Column<Real>* alpha, Column<Real>* kirchhoff);

}  // namespace tidewater::mpm
