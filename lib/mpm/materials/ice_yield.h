// Failure of ice: the return to the yield surface of non-associative Cohesive Cam Clay (NACC).
//
//     y  = q² (1+2β) + M² (p + βp0)(p − p0) ≤ 0            yield surface                       eq. 5
//     p0 = κ sinh(ξ max(−α, 0)),  α0 = −asinh(p0/κ)/ξ      hardening; failed where α ≥ 0       eq. 6
//
// A trial state, symbols as in ice.h, is mapped by one of
//
//     p > p0       tip: J² ← 1 − 2p0/κ,   b ← J^(2/d) I,  α += ln(J_trial/J)
//     p < −βp0     tip: J² ← 1 + 2βp0/κ,  b ← J^(2/d) I,  α += ln(J_trial/J)
//     else, y > 0  dev b ← r dev b,  then b is scaled so that det b stays J²
//                  r = q_new/q,  q_new = M √((p+βp0)(p0−p)/(1+2β))
//                  α ± ½ ln((1+|dev b|)/(1+r|dev b|)):  + softens, if p ≤ p0(1−β)/2;  − hardens
//
// The last is the paper's q-based rule, whose z(q)² is 1 + |dev b|. The scaling keeps p, which keeping tr b
// would not, and leaves q below q_new by a factor 1 − O(strain²). The surface is that before α moves, as in
// the paper. With ShearReturn::trace tr b is kept instead, as in the authors' code: p moves, and the result need
// not lie on the surface.
//
// Sources: Wolper et al. (2021), eqs. 5 and 6; lib/mpm/README.md, Ice.
// Tests: tests/unit/mpm/materials/ice_yield_test.cpp and single_point_test.cpp.
#pragma once

#include "mpm/materials/ice.h"

namespace tidewater::mpm {

// Maps a batch and gives the stress of the result; costs little more than ice_stress where nothing yields.
// - b stays positive definite: it becomes a convex combination of itself and a multiple of I, scaled.
// - A particle that is elastic, or on its surface to 64 roundings of p0, keeps the bits of ε and α.
// - Failed ice (p0 = 0) goes to b = I, and α opens or closes by ln J. With capped hardening α stays ≥ α0.
// - p0 is held below 0.45 κ: there is no tip above κ/2. So J² ≥ 0.1 after the mapping, and any trial J² ≤ 0,
//   a rounding of a crushed b, is compression beyond the tip.
// - The trial J² counts as within [1e-4, 1e4]; one step moves α by 15 at most, and only at |ε| = 1e12.
// Returns IceState bits; ice_unusable if a trial ε is not finite.
//     count            a multiple of `lanes`, at most batch_size; all columns apart from each other
//     strain, alpha    trial state, replaced by the mapped one; symmetric_size<D> columns and one
//     kirchhoff        τ, Pa, symmetric_size<D> columns, written
template <int D, class Real>
unsigned return_to_yield(const IceConstants<D, Real>& ice, int count, Column<Real>* strain,
                         Column<Real>* alpha, Column<Real>* kirchhoff);

}  // namespace tidewater::mpm
