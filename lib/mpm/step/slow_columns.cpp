#include "mpm/step/slow_columns.h"

#include <algorithm>

#include "mpm/base/instantiate.h"

namespace tidewater::mpm {
namespace {

// The flow near the ground is that between these heights, cells.
constexpr double near_from = 2.0, near_to = 4.0;

// The ground at the foot of a column, and its drag.
template <int D>
struct Foot {
    Vector<D, double> normal = Vector<D, double>::Unit(D - 1);
    double height = 0.0;  // m
    DragLaw law;
};

// What the nodes of a column sum up to.
template <int D>
struct ColumnSum {
    double mass = 0.0;                                  // kg
    double low_mass = 0.0;                              // kg, of water less than near_from above the ground
    double near_mass = 0.0;                             // kg, of water from there to near_to above it
    Vector<D, double> low = Vector<D, double>::Zero();  // kg m/s, their momenta
    Vector<D, double> near = Vector<D, double>::Zero();

    void add(const ColumnSum& other) {
        mass += other.mass;
        low_mass += other.low_mass;
        near_mass += other.near_mass;
        low += other.low;
        near += other.near;
    }
};

template <int D>
Foot<D> foot_of(const Boundaries<D>& boundaries, const Layout<D>& layout, double shelf_end,
                const Index<D - 1>& column) {
    const double cell = layout.cell_size;
    Foot<D> foot;
    if (boundaries.shelf.exists() && column[0] <= node_at_or_before(shelf_end, cell)) {
        foot.height = boundaries.shelf.top;
        foot.law = boundaries.drag.shelf;
    } else if (boundaries.bed.exists() && boundaries.drag.bed.exists()) {
        const auto ground = boundaries.bed.ground(layout, column);
        foot.normal = ground.normal;
        foot.height = ground.height;
        foot.law = boundaries.drag.bed;
    }
    return foot;
}

// The width of a column's plan area along an axis, over a cell's.
template <int D>
double width_of(const Layout<D>& layout, const Index<D - 1>& column) {
    double width = 1.0;
    for (std::size_t axis = 0; axis + 1 < D; ++axis) {
        if (column[axis] <= 0 || column[axis] >= layout.cells[axis]) width *= 0.5;
    }
    return width;
}

}  // namespace

template <int D, class Real>
std::vector<double> slow_columns(const Parameters<D>& parameters, const BoundaryStep& step,
                                 const Slots& slots, const NodeMatter<Real>& matter,
                                 const Grid<D, Real>& grid) {
    const Layout<D>& layout = grid.layout;
    const Boundaries<D>& boundaries = parameters.boundaries;
    const Columns<D> columns(layout);
    const double shelf_end = boundaries.shelf.end_at(step.time.value_or(0.0));
    std::vector<Foot<D>> feet(columns.size());
    parallel_for(feet.size(),
                 [&](std::size_t n) { feet[n] = foot_of(boundaries, layout, shelf_end, columns.at(n)); });

    constexpr int in_block = power(Block<D>::width, D - 1);
    std::vector<std::array<ColumnSum<D>, static_cast<std::size_t>(in_block)>> parts(slots.size());
    parallel_for(slots.size(), [&](std::size_t m) {
        const std::size_t slot = slots[m];
        const Index<D> block = block_at<D>(grid.node_blocks[slot]);
        const BlockMatter<Real> made_of = matter.of(slot);
        const Node<Real>* nodes = grid.block_nodes(slot);
        for (int n = 0; n < Block<D>::nodes; ++n) {
            const auto mass = static_cast<double>(nodes[n][mass_lane]);
            if (!(mass > 0.0)) continue;
            const Index<D> at = node_at(layout, block, n);
            const auto place = columns.place(at);
            if (!place) continue;
            ColumnSum<D>& column = parts[m][static_cast<std::size_t>(n / Block<D>::width)];
            column.mass += mass;
            const double above = at[D - 1] - feet[*place].height / layout.cell_size;
            if (above >= near_to || made_of.of(n, nodes[n]) != Material::water) continue;
            const bool low = above < near_from;
            (low ? column.low_mass : column.near_mass) += mass;
            (low ? column.low : column.near) +=
                mass * nodes[n].template head<D>().template cast<double>().matrix();
        }
    });
    std::vector<ColumnSum<D>> sums(columns.size());
    for (std::size_t m = 0; m < parts.size(); ++m) {
        const Index<D> block = block_at<D>(grid.node_blocks[slots[m]]);
        for (int c = 0; c < in_block; ++c) {
            const auto place = columns.place(node_at(layout, block, c * Block<D>::width));
            if (place) sums[*place].add(parts[m][static_cast<std::size_t>(c)]);
        }
    }

    std::vector<double> slowing(columns.size() * D, 0.0);
    const double weight = parameters.water.density * std::pow(layout.cell_size, D - 1);
    parallel_for(sums.size(), [&](std::size_t n) {
        const Foot<D>& foot = feet[n];
        const ColumnSum<D>& sum = sums[n];
        if (!foot.law.exists() || !(sum.low_mass + sum.near_mass > 0.0)) return;
        const Index<D - 1> column = columns.at(n);
        Index<D - 1> inside = column;
        for (std::size_t axis = 0; axis + 1 < D; ++axis)
            inside[axis] = std::clamp(inside[axis], 1, std::max(layout.cells[axis] - 1, 1));
        const std::size_t next = *columns.place(inside);
        const double depth =
            std::max(sums[next].mass / (weight * width_of(layout, inside)), 1e-6 * layout.cell_size);
        const double of_cell = weight * layout.cell_size * width_of(layout, column);
        Vector<D, double> along =
            sum.near_mass >= of_cell
                ? Vector<D, double>(sum.near / sum.near_mass)
                : Vector<D, double>((sum.low + sum.near) / (sum.low_mass + sum.near_mass));
        along -= along.dot(foot.normal) * foot.normal;
        const double share = foot.law.at_depth(depth, parameters.gravity) * along.norm() * step.dt /
                             (depth * foot.normal[D - 1]);
        Eigen::Map<Vector<D, double>> of_column(slowing.data() + n * D);
        of_column = share / (1.0 + share) * along;
    });
    return slowing;
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                 \
    template std::vector<double> slow_columns(const Parameters<D>&, const BoundaryStep&, const Slots&, \
                                              const NodeMatter<Real>&, const Grid<D, Real>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
