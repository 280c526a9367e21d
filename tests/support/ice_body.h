// Bodies of ice for tests: any shape on the lattice, any affine motion.
#pragma once

#include "support/tank.h"

namespace tidewater::test {

template <int D>
using Shape = std::function<bool(const Vector<D, double>&)>;

// All points between two corners.
template <int D>
Shape<D> box_shape(const Vector<D, double>& low, const Vector<D, double>& high) {
    return [low, high](const Vector<D, double>& x) {
        return (x - low).minCoeff() > 0.0 && (high - x).minCoeff() > 0.0;
    };
}

template <int D>
Shape<D> ball_shape(const Vector<D, double>& middle, double radius) {
    return [middle, radius](const Vector<D, double>& x) { return (x - middle).norm() < radius; };
}

// Adds the lattice points inside of a shape, a body of the start's ice.
template <int D>
typename mpm::Start<D>::Body& add_ice(const Shape<D>& shape, mpm::Start<D>& start, int per_axis = 2) {
    auto& body = start.bodies.emplace_back();
    body.material = Material::ice;
    body.points = lattice<D>(start.cell_size, start.cells, per_axis, 0.0, shape);
    body.volume = static_cast<double>(body.points.size()) * std::pow(start.cell_size / per_axis, D);
    body.mass = start.parameters.ice.density * body.volume;
    return body;
}

// v = velocity + gradient (x − middle).
template <int D>
void set_motion(const Vector<D, double>& middle, const Vector<D, double>& velocity,
                const Matrix<D, double>& gradient, typename mpm::Start<D>::Body& body) {
    body.velocity.clear();
    for (const auto& x : body.points) body.velocity.push_back(velocity + gradient * (x - middle));
    body.gradient.assign(body.points.size(), gradient);
}

// The gradient of a rotation in the x–z plane, 1/s.
template <int D>
Matrix<D, double> spin(double rate) {
    Matrix<D, double> gradient = Matrix<D, double>::Zero();
    gradient(0, D - 1) = rate;
    gradient(D - 1, 0) = -rate;
    return gradient;
}

// The box's middle, m.
template <int D>
Vector<D, double> middle_of(const mpm::Start<D>& start) {
    Vector<D, double> middle;
    for (int axis = 0; axis < D; ++axis)
        middle[axis] = 0.5 * start.cell_size * start.cells[static_cast<std::size_t>(axis)];
    return middle;
}

}  // namespace tidewater::test
