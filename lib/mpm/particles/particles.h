// The particles of one body, stored column by column and sorted by block.
//
// Memory that a particle takes between steps, in bytes for `float` in 2D / 3D:
//     water    position 8 / 12, j 4, id 4                       16 / 20
//     ice      position 8 / 12, strain 12 / 24, id 4            24 / 40, elastic
//              + alpha 4, failure_time 4                        32 / 48, with fracture
// Between steps velocities and their gradients exist on the grid only; mpm/particles/motion.h reads them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/parallel.h"
#include "mpm/base/batch.h"
#include "mpm/grid/grid.h"
#include "mpm/particles/position.h"

namespace tidewater::mpm {

// All particles of one body have equal mass and equal volume at rest. Columns that the material does not need
// stay empty.
template <int D, class Real>
struct Particles {
    Material material = Material::water;
    double mass = 0.0;    // of each, kg (in 2D per metre of width)
    double volume = 0.0;  // V0 of each, m³ (m² in 2D)

    std::array<std::vector<Stored<Real>>, D> position;  // cells, relative to the first node of the block
    std::vector<Real> j;                                // J − 1; water
    std::array<std::vector<Real>, static_cast<std::size_t>(symmetric_size<D>)> strain;  // ε_b = b − I; ice
    std::vector<Real> alpha;         // α; ice with fracture
    std::vector<Real> failure_time;  // s, when α first was ≥ 0; infinite before; ice with fracture
    std::vector<std::uint32_t> id;   // given at the start; never changes

    std::vector<std::uint32_t> begin;  // [particle block] its first particle; the last entry is size()

    std::size_t size() const { return id.size(); }
};

// Calls visit(name, column) for every column that has one entry per particle, including empty columns.
template <class Particles, class Visit>
void for_each_column(Particles& particles, const Visit& visit) {
    static constexpr const char* axes[] = {"x", "y", "z"};
    const std::size_t dimension = particles.position.size();
    for (std::size_t axis = 0; axis < dimension; ++axis) {
        visit(std::string("position_") + axes[axis == dimension - 1 ? 2 : axis], particles.position[axis]);
    }
    visit(std::string("j"), particles.j);
    for (std::size_t c = 0; c < particles.strain.size(); ++c) {
        visit("strain_" + std::to_string(c), particles.strain[c]);
    }
    visit(std::string("alpha"), particles.alpha);
    visit(std::string("failure_time"), particles.failure_time);
    visit(std::string("id"), particles.id);
}

// A particle's position in its block, cells.
template <int D, class Real>
Vector<D, double> local_position(const Particles<D, Real>& particles, std::size_t p) {
    Vector<D, double> cells;
    for (std::size_t axis = 0; axis < D; ++axis) {
        cells[static_cast<int>(axis)] = cells_of(particles.position[axis][p]);
    }
    return cells;
}

// A particle's position relative to node `origin`, by default the corner of the box, m.
template <int D, class Real>
Vector<D, double> global_position(const Layout<D>& layout, const Index<D>& block,
                                  const Particles<D, Real>& particles, std::size_t p,
                                  const Index<D>& origin = {}) {
    Vector<D, double> point;
    for (std::size_t axis = 0; axis < D; ++axis) {
        const int first = layout.first_node(block[axis]) - origin[axis];
        point[static_cast<int>(axis)] = layout.cell_size * (first + cells_of(particles.position[axis][p]));
    }
    return point;
}

// Calls visit(first, count, position) for the particles begin … end − 1, batch by batch. A batch consists of
// the particles first … first + count − 1; `position` has one column per axis.
template <int D, class Real, class Visit>
void for_each_batch(const Particles<D, Real>& particles, std::size_t begin, std::size_t end,
                    const Visit& visit) {
    Column<Stored<Real>> position[D];
    for (std::size_t first = begin; first < end; first += batch_size) {
        const int count = static_cast<int>(std::min<std::size_t>(batch_size, end - first));
        for (std::size_t axis = 0; axis < D; ++axis) {
            load_column(particles.position[axis].data() + first, count, position[axis]);
        }
        visit(first, count, position);
    }
}

// The same for all particles of a block.
template <int D, class Real, class Visit>
void for_each_batch(const Particles<D, Real>& particles, std::size_t slot, const Visit& visit) {
    for_each_batch(particles, particles.begin[slot], particles.begin[slot + 1], visit);
}

// Calls visit(block slot, block, particle) for all particles. Blocks are visited in parallel, the particles
// of each block in order.
template <int D, class Real, class Visit>
void for_each_particle(const Grid<D, Real>& grid, const Particles<D, Real>& particles, const Visit& visit) {
    parallel_for(grid.particle_blocks.size(), [&](std::size_t slot) {
        const Index<D> block = block_at<D>(grid.particle_blocks[slot]);
        for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) visit(slot, block, p);
    });
}

}  // namespace tidewater::mpm
