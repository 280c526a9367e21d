// Particles of one kind, column by column, sorted by block.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/parallel.h"
#include "mpm/grid.h"

namespace tidewater::mpm {

// All particles of one body: equal mass and equal volume at rest. Columns that the material does not need
// stay empty.
template <int D, class Real>
struct Particles {
    Material material = Material::water;
    double mass = 0.0;    // of each, kg (in 2D per metre of width)
    double volume = 0.0;  // V0 of each, m³ (m² in 2D)

    std::vector<Vector<D, Real>> position;  // cells, relative to the first node of the particle's block
    std::vector<Vector<D, Real>> velocity;  // m/s
    std::vector<Matrix<D, Real>> gradient;  // velocity per cell of distance, Δx C, m/s
    std::vector<Real> j;                    // J − 1; water
    std::vector<Vector<D, Real>> offset;    // from the body's centre of mass in its own axes, m; rigid
    std::vector<std::uint32_t> id;          // kept from the start, whatever the order

    std::vector<std::uint32_t> begin;  // [particle block] the first particle; one entry more at the end

    std::size_t size() const { return position.size(); }
};

// Position in the box, m, of a particle in `block`.
template <int D, class Real>
Vector<D, double> global_position(const Layout<D>& layout, const Index<D>& block,
                                  const Vector<D, Real>& position) {
    Vector<D, double> point;
    for (int axis = 0; axis < D; ++axis) {
        const int first = layout.first_node(block[static_cast<std::size_t>(axis)]);
        point[axis] = layout.cell_size * (first + static_cast<double>(position[axis]));
    }
    return point;
}

// The inverse: the position in `block`, cells, of a point of the box, m.
template <int D, class Real>
Vector<D, Real> local_position(const Layout<D>& layout, const Index<D>& block,
                               const Vector<D, double>& point) {
    Vector<D, Real> position;
    for (int axis = 0; axis < D; ++axis) {
        const int first = layout.first_node(block[static_cast<std::size_t>(axis)]);
        position[axis] = static_cast<Real>(point[axis] / layout.cell_size - first);
    }
    return position;
}

// Calls visit(block slot, particle) for all particles, blocks in parallel, each block's particles in order.
template <int D, class Real, class Visit>
void for_each_particle(const Particles<D, Real>& particles, const Visit& visit) {
    if (particles.begin.empty()) return;
    parallel_for(particles.begin.size() - 1, [&](std::size_t slot) {
        for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) visit(slot, p);
    });
}

}  // namespace tidewater::mpm
