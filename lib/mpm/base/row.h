// Short vectors that compilers keep in registers. A quad is one node (momentum and mass); a row is four nodes
// side by side, of which a particle touches three.
//
// They are vector types of GCC and clang: a + b, a * b and s * a work element by element on any machine. With
// AVX-512 a row of float is one register.
#pragma once

#include <cstring>

namespace tidewater::mpm {

template <class Real>
struct VectorTypes;
template <>
struct VectorTypes<float> {
    typedef float Quad __attribute__((vector_size(16)));
    typedef float Row __attribute__((vector_size(64)));
};
template <>
struct VectorTypes<double> {
    typedef double Quad __attribute__((vector_size(32)));
    typedef double Row __attribute__((vector_size(128)));
};
template <class Real>
using Quad = typename VectorTypes<Real>::Quad;
template <class Real>
using Row = typename VectorTypes<Real>::Row;

template <class Real>
inline Row<Real> load_row(const Real* from) {
    Row<Real> row;
    std::memcpy(&row, from, sizeof row);
    return row;
}
template <class Real>
inline Quad<Real> load_quad(const Real* from) {
    Quad<Real> quad;
    std::memcpy(&quad, from, sizeof quad);
    return quad;
}
template <class Vector, class Real>
inline void store(const Vector& vector, Real* to) {
    std::memcpy(to, &vector, sizeof vector);
}

// (a b c d) → (a b c d  a b c d  a b c d  a b c d)
template <class Real>
inline Row<Real> repeat(const Quad<Real>& q) {
    return __builtin_shufflevector(q, q, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3);
}

// (a b c d) → (a a a a  b b b b  c c c c  d d d d)
template <class Real>
inline Row<Real> spread(const Quad<Real>& q) {
    return __builtin_shufflevector(q, q, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3);
}

// Quad n of a row.
template <int n, class Real>
inline Quad<Real> quad_of(const Row<Real>& row) {
    return __builtin_shufflevector(row, row, 4 * n, 4 * n + 1, 4 * n + 2, 4 * n + 3);
}

}  // namespace tidewater::mpm
