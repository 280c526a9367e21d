#include "mpm/boundaries/bed.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "mpm/base/instantiate.h"

namespace tidewater::mpm {
namespace {

template <int D>
typename Bed<D>::Ground find_ground(const Bed<D>& bed, const Layout<D>& layout, const Index<D - 1>& column) {
    constexpr int across = D - 1;
    const double cell = layout.cell_size;
    Vector<across, double> place;
    for (int axis = 0; axis < across; ++axis) {
        place[axis] = cell * column[static_cast<std::size_t>(axis)];
    }
    const Vector<across, double> rise = bed.slope(place, cell);
    const double steepness = std::sqrt(1.0 + rise.squaredNorm());
    typename Bed<D>::Ground ground;
    ground.normal << -rise, 1.0;
    ground.height = bed.height(place);
    ground.top = ground.height + wall_reach * cell * steepness;
    ground.area = steepness;
    for (std::size_t axis = 0; axis < across; ++axis) {
        const bool inside = column[axis] > 0 && column[axis] < layout.cells[axis];
        if (!inside) ground.normal[static_cast<int>(axis)] = 0.0;
        ground.area *= inside ? cell : 0.5 * cell;
    }
    ground.normal.normalize();
    if (bed.rule.ice.needs_area()) {
        double held = 0.0;
        const int nearest = static_cast<int>(std::lround(ground.height / cell));
        for (int node = nearest - 2; cell * node < ground.top && node <= nearest + 2; ++node) {
            held += quadratic_spline(node - ground.height / cell);
        }
        ground.room = ground.area / steepness * cell;
        ground.area /= held;
    }
    return ground;
}

}  // namespace

template <int D>
typename Bed<D>::Ground Bed<D>::ground(const Layout<D>& layout, const Index<across>& column) const {
    if (!grounds.empty()) {
        if (const auto kept = Columns<D>(layout).place(column)) return grounds[*kept];
    }
    return find_ground(*this, layout, column);
}

template <int D>
void Bed<D>::keep_grounds(const Layout<D>& layout) {
    grounds.clear();
    if (!exists()) return;
    const Columns<D> columns(layout);
    std::vector<Ground> all(columns.size());
    columns.for_each(
        [&](std::size_t n, const Index<across>& column) { all[n] = find_ground(*this, layout, column); });
    grounds = std::move(all);
}

template <int D>
double Bed<D>::height(const Vector<across, double>& at) const {
    assert(exists());
    std::size_t first[across];
    double share[across];  // weight of the next point
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

template <int D>
std::optional<typename Bed<D>::UnderBlock> Bed<D>::Acting::on(const Index<D>& block) const {
    if (!bed.exists()) return {};
    UnderBlock under{layout, bed.rule, dt, block, {}};
    for (int n = 0; n < power(Block<D>::width, across); ++n) {
        Index<across> column = index_of<across>(n, Block<D>::width);
        for (std::size_t axis = 0; axis < across; ++axis) column[axis] += layout.first_node(block[axis]);
        Ground& ground = under.columns[static_cast<std::size_t>(n)];
        ground = bed.ground(layout, column);
        under.top = n == 0 ? ground.top : std::max(under.top, ground.top);
    }
    if (layout.cell_size * layout.first_node(block[D - 1]) >= under.top) return {};
    return under;
}

template <int D>
bool Bed<D>::hides_fill_at(const Layout<D>& layout, double, const Index<D>& node) const {
    if (!exists()) return false;
    Vector<across, double> at;
    for (int axis = 0; axis < across; ++axis) {
        at[axis] = layout.cell_size * node[static_cast<std::size_t>(axis)];
    }
    const double above = layout.cell_size * node[D - 1] - height(at);
    const double normal_z = 1.0 / std::sqrt(1.0 + slope(at, layout.cell_size).squaredNorm());
    return above * normal_z < 1.5 * layout.cell_size;
}

#define TIDEWATER_INSTANTIATE(D) template struct Bed<D>;
TIDEWATER_FOR_EACH_DIMENSION(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
