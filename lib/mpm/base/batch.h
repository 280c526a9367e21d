// The working set of the fast kernels: up to batch_size particles, stored column by column, so that all their
// temporaries fit into the first-level cache.
#pragma once

#include <cstddef>
#include <cstring>

namespace tidewater::mpm {

inline constexpr int batch_size = 64;  // particles
inline constexpr int lanes = 16;       // max. numbers in one wide register

// One number of each particle of a batch.
template <class Real>
struct alignas(64) Column {
    Real value[batch_size];
    Real& operator[](int i) { return value[i]; }
    const Real& operator[](int i) const { return value[i]; }
};

// Number of independent components of a symmetric matrix: xx, xz, zz in 2D; xx, xy, xz, yy, yz, zz in 3D.
template <int D>
inline constexpr int symmetric_size = D*(D + 1) / 2;

// `count` rounded up to whole lanes.
constexpr int padded(int count) { return (count + lanes - 1) / lanes * lanes; }

// Copies `count` values (1 … batch_size) into a column and fills the rest with the last one, so that kernels
// may work on the whole column.
template <class T>
inline void load_column(const T* from, int count, Column<T>& column) {
    if (count == batch_size) {  // compilers inline a copy of constant size
        std::memcpy(column.value, from, sizeof column.value);
        return;
    }
    std::memcpy(column.value, from, static_cast<std::size_t>(count) * sizeof(T));
    for (int p = count; p < batch_size; ++p) column[p] = from[count - 1];
}

// Copies the first `count` values of a column to `to`.
template <class T>
inline void store_column(const Column<T>& column, int count, T* to) {
    if (count == batch_size)
        std::memcpy(to, column.value, sizeof column.value);
    else
        std::memcpy(to, column.value, static_cast<std::size_t>(count) * sizeof(T));
}

}  // namespace tidewater::mpm
