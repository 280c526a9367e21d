// Between the x–z plane of a 2D scene and the plane y = 0 of space, in which rigid bodies turn.
#pragma once

#include "core/types.h"

namespace tidewater::mpm {

// (x, z) → (x, 0, z); in 3D the vector itself.
template <int D>
inline Eigen::Vector3d lift(const Vector<D, double>& v) {
    if constexpr (D == 3)
        return v;
    else
        return {v[0], 0.0, v[1]};
}

// The inverse of lift: leaves out y in 2D.
template <int D>
inline Vector<D, double> drop(const Eigen::Vector3d& v) {
    if constexpr (D == 3)
        return v;
    else
        return {v[0], v[2]};
}

}  // namespace tidewater::mpm
