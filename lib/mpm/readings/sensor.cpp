#include "mpm/readings/sensor.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/spline.h"
#include "mpm/base/instantiate.h"

namespace tidewater::mpm {
namespace {

constexpr int rim = 3;               // nodes on each side of the nearest one
constexpr double width = 2.0;        // cells, of the spline W
constexpr double reach = rim + 2.0;  // cells, max. distance along any axis of water that counts
constexpr double min_fill = 0.5;     // filled share of the nodes' volume for an unscaled reading
constexpr double min_spread = 0.1;   // cells², min. variance of the water's position for fitting a plane

// Sums over the water that one node reaches; positions are in cells, relative to the sensor.
template <int D>
struct NodeWater {
    double volume = 0.0, pressure = 0.0;  // Σ w V, Σ w V p
    Vector<D, double> place = Vector<D, double>::Zero();
};

// The offset from the middle of node n in a stencil of `side` nodes per axis.
template <int D>
Vector<D, double> offset(int n, int side) {
    Vector<D, double> from;
    for (int axis = 0; axis < D; ++axis) from[axis] = index_along<D>(n, side, axis) - side / 2;
    return from;
}

template <int D>
double spline(const Vector<D, double>& u) {
    double product = 1.0;
    for (int axis = 0; axis < D; ++axis) product *= quadratic_spline(u[axis]);
    return product;
}

template <int D>
struct Sensor {
    static constexpr int side = 2 * rim + 1, nodes = power(side, D);
    Vector<D, double> at;       // cells
    Vector<D, double> nearest;  // node
    std::vector<NodeWater<D>> water;

    explicit Sensor(const Vector<D, double>& cells)
        : at(cells), nearest((cells.array() + 0.5).floor()), water(static_cast<std::size_t>(nodes)) {}

    double weight(int n) const { return spline<D>((nearest + offset<D>(n, side) - at) / width); }

    void add(const Vector<D, double>& place, double volume, double pressure) {
        const Vector<D, double> middle = (place.array() + 0.5).floor();
        for (int n = 0; n < power(3, D); ++n) {
            const Vector<D, double> node = middle + offset<D>(n, 3);
            const Vector<D, double> own = node - nearest;
            if (own.cwiseAbs().maxCoeff() > rim) continue;
            int index = 0;
            for (int axis = 0; axis < D; ++axis) index = index * side + static_cast<int>(own[axis]) + rim;
            const double share = spline<D>(place - node) * volume;
            auto& sums = water[static_cast<std::size_t>(index)];
            sums.volume += share;
            sums.pressure += share * pressure;
            sums.place += share * (place - at);
        }
    }
};

// Estimates the share within the box of the space around a point: half of it on a wall, all of it far away.
template <int D>
double share_inside(const Layout<D>& layout, const Vector<D, double>& at) {
    double share = 1.0;
    for (int axis = 0; axis < D; ++axis) {
        const double size = layout.cells[static_cast<std::size_t>(axis)];
        share *= std::clamp(0.5 + 0.5 * std::min(at[axis], size - at[axis]) / width, 0.5, 1.0);
    }
    return share;
}

template <int D>
double reading(const Sensor<D>& sensor, const Layout<D>& layout) {
    using Plane = Eigen::Matrix<double, D + 1, 1>;
    double total = 0.0;
    Plane right = Plane::Zero();
    Eigen::Matrix<double, D + 1, D + 1> normal = Eigen::Matrix<double, D + 1, D + 1>::Zero();
    for (int n = 0; n < Sensor<D>::nodes; ++n) {
        const auto& water = sensor.water[static_cast<std::size_t>(n)];
        if (!(water.volume > 0.0)) continue;
        const double weight = sensor.weight(n) * water.volume;
        Plane row;
        row << 1.0, water.place / water.volume;
        normal += weight * row * row.transpose();
        right += weight * row * (water.pressure / water.volume);
        total += weight;
    }
    if (!(total > 0.0)) return 0.0;
    const double filled = total / std::pow(width * layout.cell_size, D) / share_inside(layout, sensor.at);
    const double mean = right[0] / total;
    if (filled < min_fill) return mean * filled / min_fill;
    const Vector<D, double> center = normal.template block<D, 1>(1, 0) / total;
    const Matrix<D, double> spread = normal.template block<D, D>(1, 1) / total - center * center.transpose();
    const Eigen::SelfAdjointEigenSolver<Matrix<D, double>> axes(spread, Eigen::EigenvaluesOnly);
    if (axes.eigenvalues()[0] < min_spread) return mean;
    return normal.ldlt().solve(right)[0];
}

template <int D>
bool sees(const Sensor<D>& sensor, const Vector<D, double>& first_node) {
    const double margin = reach + sorting_margin;
    const Eigen::Array<double, D, 1> from = (sensor.at - first_node).array();
    return (from >= -margin).all() && (from <= Block<D>::width + margin).all();
}

// Adds the water of one block.
template <int D, class Real>
void collect(const Simulation<D, Real>& s, std::size_t slot, const Vector<D, double>& first_node,
             Sensor<D>& sensor) {
    for (const auto& particles : s.bodies) {
        if (particles.material != Material::water) continue;
        for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
            const Vector<D, double> place = first_node + local_position(particles, p);
            if ((place - sensor.at).cwiseAbs().maxCoeff() > reach) continue;
            const double volume = particles.volume * (1.0 + static_cast<double>(particles.j[p]));
            const Real pressure = water_pressure(particles.j[p], s.parameters.water);
            sensor.add(place, volume, static_cast<double>(pressure));
        }
    }
}

}  // namespace

template <int D, class Real>
std::vector<double> pressure_at(const Simulation<D, Real>& s, std::span<const Vector<D, double>> points) {
    const auto& layout = s.grid.layout;
    std::vector<Sensor<D>> sensors;
    for (const auto& point : points) sensors.emplace_back(point / layout.cell_size);
    for (std::size_t slot = 0; slot < s.grid.particle_blocks.size(); ++slot) {
        const Index<D> block = block_at<D>(s.grid.particle_blocks[slot]);
        Vector<D, double> first_node;
        for (int axis = 0; axis < D; ++axis)
            first_node[axis] = layout.first_node(block[static_cast<std::size_t>(axis)]);
        for (Sensor<D>& sensor : sensors) {
            if (sees(sensor, first_node)) collect(s, slot, first_node, sensor);
        }
    }
    std::vector<double> readings;
    for (const Sensor<D>& sensor : sensors) readings.push_back(reading(sensor, layout));
    return readings;
}

#define TIDEWATER_INSTANTIATE(D, Real) \
    template std::vector<double> pressure_at(const Simulation<D, Real>&, std::span<const Vector<D, double>>);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
