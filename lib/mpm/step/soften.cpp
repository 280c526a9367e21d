#include "mpm/step/soften.h"

#include <algorithm>
#include <cmath>

#include "mpm/base/instantiate.h"
#include "mpm/materials/materials.h"
#include "mpm/particles/particles.h"

namespace tidewater::mpm {
namespace {

constexpr double at_rest = 1.1;    // of c0: no water at rest is faster
constexpr double worth_it = 1.02;  // gain in the step below which nothing is asked
constexpr std::size_t blocks_per_look = 32;

// Sums over particles at the nodes of one tile.
template <int D>
struct Sums {
    std::array<double, static_cast<std::size_t>(Block<D>::tile_nodes)> mass{},
        stiffness{};  // Σ w m, Σ w m c²
};

// Calls visit(tile index, weight) for the nodes of a particle that lie in the tile, to which its position
// (cells) is relative; it may be beyond the tile.
template <int D, class Visit>
void for_each_node_within(const Vector<D, double>& position, const Visit& visit) {
    constexpr int width = Block<D>::tile_width;
    int first[D];
    double weight[D][3];
    for (int axis = 0; axis < D; ++axis) {
        const double nearest = std::floor(position[axis] + 0.5);
        first[axis] = static_cast<int>(nearest);  // the node before the nearest, counted in the tile
        if (first[axis] <= -3 || first[axis] >= width) return;
        const SplineWeights<double> w = spline_weights(position[axis] - nearest);
        weight[axis][0] = w.below;
        weight[axis][1] = w.at;
        weight[axis][2] = w.above;
    }
    for (int n = 0; n < power(3, D); ++n) {
        int node = 0;
        double w = 1.0;
        bool within = true;
        for (int axis = 0; axis < D; ++axis) {
            const int offset = index_along<D>(n, 3, axis), at = first[axis] + offset;
            within = within && at >= 0 && at < width;
            node = node * width + at;
            w *= weight[axis][offset];
        }
        if (within) visit(node, w);
    }
}

// c² of a particle, m²/s².
template <int D, class Real>
double sound_speed2(const Parameters<D>& parameters, const Particles<D, Real>& particles, std::size_t p) {
    double c = 0.0;
    with_material<D, Real>(particles.material, [&]<class M>(std::type_identity<M>) {
        Findings findings;
        if (!particles.j.empty()) findings.min_j = static_cast<double>(particles.j[p]);
        c = M::sound_speed(M::model(parameters), findings);
    });
    return c * c;
}

template <int D, class Real>
Sums<D> sums_around(const Parameters<D>& parameters, const Grid<D, Real>& grid,
                    const std::vector<Particles<D, Real>>& bodies, std::size_t slot) {
    Sums<D> sums;
    const auto own = static_cast<std::size_t>(grid.nodes_of_tile[slot][Block<D>::neighbours / 2]);
    for (int k = 0; k < Block<D>::neighbours; ++k) {
        const int neighbour = grid.tiles_of_node[own][static_cast<std::size_t>(k)];
        if (neighbour < 0) continue;
        Vector<D, double> shift;
        for (int axis = 0; axis < D; ++axis) shift[axis] = Block<D>::width * neighbour_offset<D>(k, axis);
        for (const auto& particles : bodies) {
            const auto at = static_cast<std::size_t>(neighbour);
            for (std::size_t p = particles.begin[at]; p < particles.begin[at + 1]; ++p) {
                const double stiffness = particles.mass * sound_speed2(parameters, particles, p);
                for_each_node_within<D>(local_position(particles, p) + shift, [&](int node, double w) {
                    sums.mass[static_cast<std::size_t>(node)] += w * particles.mass;
                    sums.stiffness[static_cast<std::size_t>(node)] += w * stiffness;
                });
            }
        }
    }
    return sums;
}

// The largest c̄ of a block's particles, m/s.
template <int D, class Real>
double mean_sound(const Parameters<D>& parameters, const Grid<D, Real>& grid,
                  const std::vector<Particles<D, Real>>& bodies, std::size_t slot) {
    const Sums<D> sums = sums_around(parameters, grid, bodies, slot);
    double largest = 0.0;
    for (const auto& particles : bodies) {
        for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
            double mean = 0.0;
            for_each_node_within<D>(local_position(particles, p), [&](int node, double w) {
                const auto n = static_cast<std::size_t>(node);
                mean += w * sums.stiffness[n] / sums.mass[n];
            });
            largest = std::max(largest, mean);
        }
    }
    return std::sqrt(largest);
}

}  // namespace

template <int D, class Real>
std::size_t soften_signals(const Parameters<D>& parameters, const Grid<D, Real>& grid,
                           const std::vector<Particles<D, Real>>& bodies, std::vector<Signal>& of_block) {
    double usual = 0.0;
    for (const auto& particles : bodies) {
        if (particles.size() == 0) continue;
        usual = std::max(usual, particles.material == Material::ice ? parameters.ice.wave_speed(D)
                                                                    : at_rest * parameters.water.sound_speed);
    }
    std::vector<std::size_t> stiff;
    for (std::size_t slot = 0; slot < of_block.size(); ++slot) {
        if (of_block[slot].sound > worth_it * usual) stiff.push_back(slot);
    }
    if (stiff.empty() || stiff.size() > 1 + of_block.size() / blocks_per_look) return 0;
    parallel_for(stiff.size(), [&](std::size_t n) {
        Signal& signal = of_block[stiff[n]];
        signal.sound = std::min(signal.sound, mean_sound(parameters, grid, bodies, stiff[n]));
    });
    return stiff.size();
}

#define TIDEWATER_INSTANTIATE(D, Real)                                              \
    template std::size_t soften_signals(const Parameters<D>&, const Grid<D, Real>&, \
                                        const std::vector<Particles<D, Real>>&, std::vector<Signal>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
