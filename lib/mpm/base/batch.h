// The working set of the fast kernels: up to batch_size particles, column by column, in the first-level
// cache.
#pragma once

#include <cstddef>
#include <cstring>

namespace tidewater::mpm {

inline constexpr int batch_size = 64;  // particles whose temporaries stay in the first-level cache together
inline constexpr int lanes = 16;       // numbers in a wide register at most

template <class Real>
struct alignas(64) Column {
    Real value[batch_size];
    Real& operator[](int i) { return value[i]; }
    const Real& operator[](int i) const { return value[i]; }
};

// Components of a symmetric matrix: xx, xz, zz in 2D; xx, xy, xz, yy, yz, zz in 3D.
template <int D>
inline constexpr int symmetric_size = D*(D + 1) / 2;

// `count` rounded up to whole lanes.
constexpr int padded(int count) { return (count + lanes - 1) / lanes * lanes; }

// Copies count ≤ batch_size values into a column and fills the rest with the last one, so that kernels may
// work on all of it.
template <class T>
inline void load_column(const T* from, int count, Column<T>& column) {
    if (count == batch_size) {  // a constant size needs no call
        std::memcpy(column.value, from, sizeof column.value);
        return;
    }
    std::memcpy(column.value, from, static_cast<std::size_t>(count) * sizeof(T));
    for (int p = count; p < batch_size; ++p) column[p] = from[count - 1];
}

template <class T>
inline void store_column(const Column<T>& column, int count, T* to) {
    if (count == batch_size)
        std::memcpy(to, column.value, sizeof column.value);
    else
        std::memcpy(to, column.value, static_cast<std::size_t>(count) * sizeof(T));
}

}  // namespace tidewater::mpm
