#include "mpm/step/skim.h"

#include <algorithm>
#include <cmath>

#include "mpm/base/instantiate.h"
#include "mpm/step/take_out.h"

namespace tidewater::mpm {
namespace {

// A particle that may leave.
struct Candidate {
    double height;               // m
    std::size_t body, particle;  // indices
};

// What one column holds.
struct Content {
    double volume = 0.0;         // of water at rest, m³
    std::vector<Candidate> top;  // particles high enough to leave
};

// The volume at rest, per area (m), of still water of this depth (m).
double still_depth(double depth, double gravity, const WaterModel& water) {
    return water.scheme == WaterScheme::density ? weighed_depth(depth, gravity, water) : depth;
}

// V_still of each column, m³. Over a bed it is the mean over vertical lines, at most a cell apart, of the
// water above the bed.
template <int D>
std::vector<double> still_volumes(const Parameters<D>& parameters, double dx, const SkimColumns<D>& columns) {
    const double level = parameters.boundaries.sponge.level;
    const Bed<D>& bed = parameters.boundaries.bed;
    const auto still = [&](double depth) { return still_depth(depth, parameters.gravity, parameters.water); };
    std::vector<double> volumes(static_cast<std::size_t>(columns.total()), columns.area() * still(level));
    if (!bed.exists()) return volumes;
    constexpr int across = D - 1;
    const Vector<across, double> size =
        (columns.high - columns.low)
            .cwiseQuotient(
                Eigen::Map<const Vector<across, int>>(columns.counts.data()).template cast<double>());
    const int lines = std::max(static_cast<int>(std::ceil(size.maxCoeff() / dx)), 1);
    for (int column = 0; column < columns.total(); ++column) {
        double depth = 0.0;
        for (int line = 0; line < power(lines, across); ++line) {
            Vector<across, double> at = columns.middle(column);
            for (int axis = 0, rest = line; axis < across; ++axis, rest /= lines)
                at[axis] += size[axis] * ((rest % lines + 0.5) / lines - 0.5);
            depth += still(std::max(level - bed.height(at), 0.0));
        }
        volumes[static_cast<std::size_t>(column)] = columns.area() * depth / power(lines, across);
    }
    return volumes;
}

// Collects the water in each column.
template <int D, class Real>
std::vector<Content> contents(double level, const Grid<D, Real>& grid,
                              const std::vector<Particles<D, Real>>& bodies, const SkimColumns<D>& columns) {
    const Layout<D>& layout = grid.layout;
    const double min_height = level - layout.cell_size;
    std::vector<Content> contents(static_cast<std::size_t>(columns.total()));
    for (std::size_t slot = 0; slot < grid.particle_blocks.size(); ++slot) {
        const Index<D> block = block_at<D>(grid.particle_blocks[slot]);
        // A particle may have drifted half a cell out of its block.
        if (layout.cell_size * (layout.first_node(block[0]) + Block<D>::width + 1) < columns.low[0]) continue;
        for (std::size_t body = 0; body < bodies.size(); ++body) {
            const auto& particles = bodies[body];
            if (particles.material != Material::water) continue;
            for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
                const Vector<D, double> point = global_position(layout, block, particles, p);
                const std::optional<int> column = columns.at(point);
                if (!column) continue;
                Content& content = contents[static_cast<std::size_t>(*column)];
                content.volume += particles.volume;
                if (point[D - 1] > min_height) content.top.push_back({point[D - 1], body, p});
            }
        }
    }
    return contents;
}

}  // namespace

template <int D>
int SkimColumns<D>::total() const {
    int product = 1;
    for (const int count : counts) product *= count;
    return product;
}

template <int D>
double SkimColumns<D>::area() const {
    return (high - low).prod() / total();
}

template <int D>
std::optional<int> SkimColumns<D>::at(const Vector<D, double>& point) const {
    if (point[0] < low[0]) return std::nullopt;
    int column = 0;
    for (int axis = 0; axis < across; ++axis) {
        const int count = counts[static_cast<std::size_t>(axis)];
        const double share = (point[axis] - low[axis]) / (high[axis] - low[axis]);
        column = column * count + std::clamp(static_cast<int>(std::floor(share * count)), 0, count - 1);
    }
    return column;
}

template <int D>
Vector<SkimColumns<D>::across, double> SkimColumns<D>::middle(int column) const {
    Vector<across, double> place;
    for (int axis = across - 1; axis >= 0; --axis) {
        const int count = counts[static_cast<std::size_t>(axis)];
        place[axis] = low[axis] + (high[axis] - low[axis]) * (column % count + 0.5) / count;
        column /= count;
    }
    return place;
}

template <int D>
SkimColumns<D> skim_columns(const Layout<D>& layout, const Sponge& sponge) {
    SkimColumns<D> columns;
    columns.low.setZero();
    columns.low[0] = sponge.from;
    for (int axis = 0; axis < D - 1; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        columns.high[axis] = layout.cell_size * layout.cells[a];
        const double depths = (columns.high[axis] - columns.low[axis]) / sponge.level;
        columns.counts[a] = std::max(static_cast<int>(std::lround(depths)), 1);
    }
    return columns;
}

template <int D, class Real>
void skim(const Parameters<D>& parameters, double time, const Grid<D, Real>& grid,
          std::vector<Particles<D, Real>>& bodies, Skimming& skimming, Outflow<D>& outflow) {
    const Sponge& sponge = parameters.boundaries.sponge;
    if (!sponge.exists() || !(sponge.level > 0.0)) return;
    const double dx = grid.layout.cell_size;
    const SkimColumns<D> columns = skim_columns(grid.layout, sponge);
    if (skimming.still.empty()) skimming.still = still_volumes(parameters, dx, columns);
    skimming.due.resize(skimming.still.size(), 0.0);
    auto all = contents(sponge.level, grid, bodies, columns);
    const double elapsed = time - skimming.time, min_due = -0.5 * dx * columns.area();
    skimming.time = time;
    std::vector<std::vector<std::size_t>> gone(bodies.size());
    for (std::size_t column = 0; column < all.size(); ++column) {
        const double sigma = sponge.damping(columns.middle(static_cast<int>(column))[0]);
        const double excess = all[column].volume - skimming.still[column];
        double& due = skimming.due[column];
        due = std::max(due - std::expm1(-sigma * elapsed) * excess, min_due);
        auto& top = all[column].top;
        std::ranges::stable_sort(top, std::ranges::greater{}, &Candidate::height);
        for (const Candidate& next : top) {
            if (due < bodies[next.body].volume) break;
            due -= bodies[next.body].volume;
            gone[next.body].push_back(next.particle);
        }
    }
    for (std::size_t body = 0; body < gone.size(); ++body) {
        std::ranges::sort(gone[body]);
        take_out(gone[body], parameters, grid, bodies[body], outflow);
    }
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                       \
    template void skim(const Parameters<D>&, double, const Grid<D, Real>&, std::vector<Particles<D, Real>>&, \
                       Skimming&, Outflow<D>&);
template struct SkimColumns<2>;
template struct SkimColumns<3>;
template SkimColumns<2> skim_columns(const Layout<2>&, const Sponge&);
template SkimColumns<3> skim_columns(const Layout<3>&, const Sponge&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
