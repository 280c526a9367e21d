// Wolper et al. (2021), eqs. 5 and 6; ice_yield.h gives the formulas. Here p, q and p0 are in units of κ.
#include "mpm/materials/ice_yield.h"

#include <cassert>
#include <limits>

#include "mpm/base/instantiate.h"
#include "mpm/materials/ice_lane.h"

namespace tidewater::mpm {
namespace {

using namespace ice_lane;

// What find_yielding hands to return_yielding.
template <class Real>
struct Trial {
    Column<Real> shape;    // J^(−2/d)
    Column<Real> p0;       // in units of κ
    Column<Real> outside;  // −1 beyond a tip, 1 beyond the surface between the tips, 0 elastic
};

// M² (p + βp0)(p0 − p), the value of q² (1+2β) on the surface.
template <int D, class Real>
inline Real room(const IceConstants<D, Real>& ice, Real pressure, Real p0) {
    return ice.friction2 * std::max((pressure + ice.beta * p0) * (p0 - pressure), Real(0));
}
// q² of the trial state.
template <int D, class Real>
inline Real q_squared(const IceConstants<D, Real>& ice, Real shape, Real dev2) {
    return ice.q2_factor * (shape * shape) * dev2;
}

// Computes the elastic stress of all particles and finds those outside of the yield surface.
template <int D, class Real>
unsigned find_yielding(const IceConstants<D, Real>& constants, int count,
                       const Column<Real>* __restrict strain, const Column<Real>& __restrict alpha,
                       Trial<Real>& __restrict trial, Column<Real>* __restrict kirchhoff) {
    const IceConstants<D, Real> ice = constants;
    constexpr Real tolerance = 64 * std::numeric_limits<Real>::epsilon();
    const Real slack = tolerance * ice.friction2 * (Real(1) + ice.beta) * (Real(1) + ice.beta);
    unsigned yielded = 0, unusable = 0;
    for (int p = 0; p < count; ++p) {
        const Split<D, Real> b = split<D>(strain, p);
        const Real volume = clamp_volume(b.volume), pressure = Real(-0.5) * volume;
        const Real shape = inverse_stretch2<D>(volume);
        store_stress(b, ice.mu * shape, ice.half_kappa * b.volume, kirchhoff, p);

        const Real p0 = small_sinh(std::min(ice.xi * std::max(-alpha[p], Real(0)), ice.max_angle));
        const Real reach = p0 + tolerance * p0;
        const bool tip = (pressure > reach) | (pressure < -ice.beta * reach);
        const bool shear =
            ice.one_plus_two_beta * q_squared(ice, shape, b.dev2) > room(ice, pressure, p0) + slack * p0 * p0;
        trial.shape[p] = shape;
        trial.p0[p] = p0;
        trial.outside[p] = tip ? Real(-1) : (shear ? Real(1) : Real(0));
        yielded |= static_cast<unsigned>(tip | shear);
        unusable |= static_cast<unsigned>(!(b.volume - b.volume == Real(0)));
    }
    return (yielded != 0 ? ice_yielded : 0u) | (unusable != 0 ? ice_unusable : 0u);
}

// Computes the return of all particles and keeps it for those outside of the yield surface.
template <int D, bool keep_trace, class Real>
void return_yielding(const IceConstants<D, Real>& constants, int count, const Trial<Real>& __restrict trial,
                     Column<Real>* __restrict strain, Column<Real>& __restrict alpha,
                     Column<Real>* __restrict kirchhoff) {
    const IceConstants<D, Real> ice = constants;
    for (int p = 0; p < count; ++p) {
        const Split<D, Real> b = split<D>(strain, p);
        const Real volume = clamp_volume(b.volume), pressure = Real(-0.5) * volume;
        const Real shape = trial.shape[p], p0 = trial.p0[p], tensile = ice.beta * p0;
        const bool tip = trial.outside[p] < Real(0), elastic = trial.outside[p] == Real(0);

        const Real q2 = q_squared(ice, shape, b.dev2);
        const Real ratio = lane_sqrt(room(ice, pressure, p0) / (ice.one_plus_two_beta * q2));  // r
        const Real norm = lane_sqrt(b.dev2);

        // The new b is t (I + shrink dev), because b / (1 + mean) = I + dev/(1 + mean). Its scale t makes
        // det b right: t^d (1 + rest) = J².
        const Real shrink = tip ? Real(0) : ratio / (Real(1) + b.mean);
        const Real rest = distortion<D>(b.dev, b.dev2, shrink);
        const Real at_tip = pressure > Real(0) ? Real(-2) * p0 : Real(2) * tensile;
        Real new_volume = tip ? at_tip : volume, new_shape = shape;
        Real new_mean = stretch2_minus_1<D>((new_volume - rest) / (Real(1) + rest));  // t − 1
        if constexpr (keep_trace) {
            const Real t = Real(1) + b.mean;
            const Real cube = D == 2 ? b.mean * (Real(2) + b.mean)
                                     : b.mean * (Real(3) + b.mean * (Real(3) + b.mean));  // t^d − 1
            const Real moved = clamp_volume(cube + (Real(1) + cube) * rest);
            new_volume = tip ? new_volume : moved;
            new_mean = tip ? new_mean : t - Real(1);
            new_shape = tip ? shape : inverse_stretch2<D>(moved);
        }
        const Real keep = (Real(1) + new_mean) * shrink;

        // The rules of α for tips and shear share one logarithm.
        const Real gain =
            tip ? (volume - at_tip) / (Real(1) + at_tip) : (norm - ratio * norm) / (Real(1) + ratio * norm);
        const Real half_log = Real(0.5) * lane_log1p(gain);
        const bool hardens = !tip & (pressure > Real(0.5) * (p0 - tensile));
        const Real old_alpha = alpha[p];
        const Real new_alpha = std::max(old_alpha + (hardens ? -half_log : half_log), ice.min_alpha);
        alpha[p] = elastic ? old_alpha : new_alpha;

        const Real shear = ice.mu * new_shape * keep;  // 0 at a tip
        const Real pull = ice.half_kappa * new_volume;
        for (int c = 0; c < symmetric_size<D>; ++c) {
            const Real on_diagonal = is_diagonal<D>(c) ? Real(1) : Real(0);
            const Real old_strain = strain[c][p], new_strain = keep * b.dev[c] + on_diagonal * new_mean;
            const Real old_stress = kirchhoff[c][p], new_stress = shear * b.dev[c] + on_diagonal * pull;
            strain[c][p] = elastic ? old_strain : new_strain;
            kirchhoff[c][p] = elastic ? old_stress : new_stress;
        }
    }
}

}  // namespace

template <int D, class Real>
unsigned return_to_yield(const IceConstants<D, Real>& ice, int count, Column<Real>* strain,
                         Column<Real>* alpha, Column<Real>* kirchhoff) {
    assert(is_batch(count));
    Trial<Real> trial;
    const unsigned state = find_yielding(ice, count, strain, *alpha, trial, kirchhoff);
    if (!(state & ice_yielded)) return state;
    if (ice.keep_trace)
        return_yielding<D, true>(ice, count, trial, strain, *alpha, kirchhoff);
    else
        return_yielding<D, false>(ice, count, trial, strain, *alpha, kirchhoff);
    return state;
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                           \
    template unsigned return_to_yield<D, Real>(const IceConstants<D, Real>&, int, Column<Real>*, \
                                               Column<Real>*, Column<Real>*);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
