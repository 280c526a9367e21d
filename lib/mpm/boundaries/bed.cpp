#include "mpm/boundaries/bed.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tidewater::mpm {
namespace {

template <int D>
constexpr int columns = power(Block<D>::width, D - 1);  // of nodes in a block, along the last axis

// The nodes of one column that the bed acts on: those below `top`.
template <int D>
struct Ground {
    Vector<D, double> normal;  // without components into the side walls
    double top;                // m
};

// Where a column of nodes stands; y fastest.
template <int D>
Index<D> column_at(const Layout<D>& layout, const Index<D>& block, int column) {
    Index<D> at{};
    for (int axis = D - 2, rest = column; axis >= 0; --axis, rest /= Block<D>::width) {
        const auto a = static_cast<std::size_t>(axis);
        at[a] = layout.first_node(block[a]) + rest % Block<D>::width;
    }
    return at;
}

template <int D>
Ground<D> ground_of(const Layout<D>& layout, const Bed<D>& bed, const Index<D>& column) {
    Vector<D - 1, double> place;
    for (int axis = 0; axis < D - 1; ++axis) {
        place[axis] = layout.cell_size * column[static_cast<std::size_t>(axis)];
    }
    const Vector<D - 1, double> slope = bed.slope(place, layout.cell_size);
    const double steepness = std::sqrt(1.0 + slope.squaredNorm());
    Ground<D> ground;
    ground.normal << -slope, 1.0;
    ground.top = bed.height(place) + wall_reach * layout.cell_size * steepness;
    for (std::size_t axis = 0; axis < D - 1; ++axis) {
        const bool inside = column[axis] > 0 && column[axis] < layout.cells[axis];
        if (!inside) ground.normal[static_cast<int>(axis)] = 0.0;
    }
    ground.normal.normalize();
    return ground;
}

template <int D, class Real>
void apply_rule(WallRule rule, const Vector<D, double>& normal, Node<Real>& velocity) {
    if (rule == WallRule::stick) {
        velocity.template head<D>().setZero();
        return;
    }
    const Vector<D, Real> n = normal.template cast<Real>();
    const Real outward = n.dot(velocity.template head<D>().matrix());
    if (rule == WallRule::separate && outward >= Real(0)) return;
    velocity.template head<D>() -= outward * n.array();
}

}  // namespace

template <int D>
double Bed<D>::height(const Vector<across, double>& at) const {
    assert(exists());
    std::size_t first[across];
    double share[across];  // of the next point
    for (int axis = 0; axis < across; ++axis) {
        const auto last = static_cast<double>(points[static_cast<std::size_t>(axis)] - 1);
        const double place = std::clamp(at[axis] / spacing, 0.0, last);
        const double cell = std::min(std::floor(place), std::max(last - 1.0, 0.0));
        first[axis] = static_cast<std::size_t>(cell);
        share[axis] = place - cell;
    }
    double sum = 0.0;
    for (int corner = 0; corner < power(2, across); ++corner) {
        std::size_t point = 0;
        double weight = 1.0;
        for (int axis = 0; axis < across; ++axis) {
            const int next = corner >> axis & 1;
            weight *= next ? share[axis] : 1.0 - share[axis];
            const auto a = static_cast<std::size_t>(axis);
            point =
                point * static_cast<std::size_t>(points[a]) + first[axis] + static_cast<std::size_t>(next);
        }
        if (weight > 0.0) sum += weight * heights[point];
    }
    return sum;
}

template <int D>
Vector<Bed<D>::across, double> Bed<D>::slope(const Vector<across, double>& at, double reach) const {
    Vector<across, double> slope;
    for (int axis = 0; axis < across; ++axis) {
        const Vector<across, double> step = reach * Vector<across, double>::Unit(axis);
        slope[axis] = (height(at + step) - height(at - step)) / (2.0 * reach);
    }
    return slope;
}

template <int D, class Real>
WallAction<D> apply_bed(const Layout<D>& layout, const Bed<D>& bed, const Index<D>& block,
                        Node<Real>* nodes) {
    WallAction<D> action;
    if (!bed.exists()) return action;
    std::array<Ground<D>, static_cast<std::size_t>(columns<D>)> ground;
    double highest = 0.0;
    for (int column = 0; column < columns<D>; ++column) {
        auto& here = ground[static_cast<std::size_t>(column)];
        here = ground_of(layout, bed, column_at(layout, block, column));
        highest = column == 0 ? here.top : std::max(highest, here.top);
    }
    if (layout.cell_size * layout.first_node(block[D - 1]) >= highest) return action;
    action.impulse = change_nodes<D, Real>(layout, block, nodes, [&](const Index<D>& at, Node<Real>& node) {
        std::size_t column = 0;
        for (std::size_t axis = 0; axis < D - 1; ++axis) {
            column = column * static_cast<std::size_t>(Block<D>::width) +
                     static_cast<std::size_t>(at[axis] - layout.first_node(block[axis]));
        }
        const Ground<D>& here = ground[column];
        if (layout.cell_size * at[D - 1] < here.top) apply_rule<D>(bed.rule, here.normal, node);
    });
    return action;
}

#define TIDEWATER_INSTANTIATE(D, Real) \
    template WallAction<D> apply_bed<D, Real>(const Layout<D>&, const Bed<D>&, const Index<D>&, Node<Real>*);
template struct Bed<2>;
template struct Bed<3>;
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
