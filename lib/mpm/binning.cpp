#include "mpm/binning.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>

#include "core/error.h"

namespace tidewater::mpm {
namespace {

// Counting sort splits the particles into this many runs, whatever the number of threads.
constexpr std::size_t chunks = 16;

template <int D>
[[noreturn]] void fail_escaped(std::uint32_t id, const Vector<D, double>& point) {
    std::string text;
    for (int axis = 0; axis < D; ++axis) {
        char number[32];
        std::snprintf(number, sizeof number, "%s%.6g", axis > 0 ? ", " : "", point[axis]);
        text += number;
    }
    throw NumericsError("particle " + std::to_string(id) + " left the tank at (" + text +
                        ") m, found while sorting particles; use a smaller simulate.cfl or a higher tank");
}

// The block of a node coordinate X (cells) on an axis, −1 if it is more than a cell beyond a wall or NaN.
int block_on_axis(double x, int cells, int width) {
    if (!(x >= -1.0 && x <= cells + 1.0)) return -1;
    return static_cast<int>(std::floor(x / width)) + 2;
}

template <class Column>
void reorder(Column& column, const std::vector<std::uint32_t>& to) {
    if (column.empty()) return;
    Column sorted(column.size());
    parallel_for(
        to.size(), [&](std::size_t p) { sorted[to[p]] = column[p]; }, 8192);
    column.swap(sorted);
}

std::vector<int> occupied_blocks(const std::vector<std::vector<int>>& block_of, int block_count) {
    std::vector<char> occupied(static_cast<std::size_t>(block_count), 0);
    for (const auto& blocks : block_of) {
        for (const int block : blocks) occupied[static_cast<std::size_t>(block)] = 1;
    }
    std::vector<int> list;
    for (int block = 0; block < block_count; ++block) {
        if (occupied[static_cast<std::size_t>(block)]) list.push_back(block);
    }
    return list;
}

// Where each particle goes in a stable sort by slot, and where each slot begins.
std::vector<std::uint32_t> stable_order(const std::vector<std::uint32_t>& slot_of, std::size_t slots,
                                        std::vector<std::uint32_t>& begin) {
    const std::size_t count = slot_of.size();
    const auto chunk_begin = [&](std::size_t chunk) { return count * chunk / chunks; };
    std::vector<std::vector<std::uint32_t>> next(chunks, std::vector<std::uint32_t>(slots, 0));
    parallel_for(chunks, [&](std::size_t chunk) {
        for (std::size_t p = chunk_begin(chunk); p < chunk_begin(chunk + 1); ++p) ++next[chunk][slot_of[p]];
    });
    begin.resize(slots + 1);
    std::uint32_t sum = 0;
    for (std::size_t slot = 0; slot < slots; ++slot) {
        begin[slot] = sum;
        for (auto& counts : next) sum += std::exchange(counts[slot], sum);
    }
    begin[slots] = sum;
    std::vector<std::uint32_t> to(count);
    parallel_for(chunks, [&](std::size_t chunk) {
        for (std::size_t p = chunk_begin(chunk); p < chunk_begin(chunk + 1); ++p)
            to[p] = next[chunk][slot_of[p]]++;
    });
    return to;
}

}  // namespace

template <int D, class Real>
std::vector<int> place(const Layout<D>& layout, const std::vector<Vector<D, double>>& points,
                       std::uint32_t first_id, Particles<D, Real>& particles) {
    const std::size_t count = points.size();
    std::vector<int> block_of(count);
    particles.position.resize(count);
    particles.velocity.assign(count, Vector<D, Real>::Zero());
    particles.gradient.assign(count, Matrix<D, Real>::Zero());
    particles.id.resize(count);
    std::iota(particles.id.begin(), particles.id.end(), first_id);
    for (std::size_t p = 0; p < count; ++p) {
        Index<D> block;
        for (std::size_t axis = 0; axis < D; ++axis) {
            const double x = points[p][static_cast<int>(axis)] / layout.cell_size;
            block[axis] = block_on_axis(x, layout.cells[axis], Block<D>::width);
            if (block[axis] < 0) fail_escaped<D>(particles.id[p], points[p]);
        }
        block_of[p] = layout.block_index(block);
        particles.position[p] = local_position<D, Real>(layout, block, points[p]);
    }
    return block_of;
}

template <int D, class Real>
std::vector<int> follow(const Grid<D, Real>& grid, Particles<D, Real>& particles) {
    constexpr int width = Block<D>::width;
    const Layout<D>& layout = grid.layout;
    std::vector<int> block_of(particles.size());
    for_each_particle(particles, [&](std::size_t slot, std::size_t p) {
        Index<D> block = layout.block_at(grid.particle_blocks[slot]);
        Vector<D, Real>& position = particles.position[p];
        const Vector<D, Real> old = position;
        for (std::size_t axis = 0; axis < D; ++axis) {
            const int i = static_cast<int>(axis);
            const double x = layout.first_node(block[axis]) + static_cast<double>(position[i]);
            const int target = block_on_axis(x, layout.cells[axis], width);
            if (target < 0) {
                fail_escaped<D>(
                    particles.id[p],
                    global_position<D, Real>(layout, layout.block_at(grid.particle_blocks[slot]), old));
            }
            // Whole cells are subtracted, which is exact but for the last bit of a tiny negative position.
            position[i] -= static_cast<Real>((target - block[axis]) * width);
            block[axis] = target;
        }
        block_of[p] = layout.block_index(block);
    });
    return block_of;
}

template <int D, class Real>
void sort_into_blocks(Grid<D, Real>& grid, std::span<Particles<D, Real>> bodies,
                      const std::vector<std::vector<int>>& block_of) {
    activate(grid, occupied_blocks(block_of, grid.layout.block_count()));
    std::vector<std::uint32_t> slot_of_block(static_cast<std::size_t>(grid.layout.block_count()), 0);
    for (std::size_t slot = 0; slot < grid.particle_blocks.size(); ++slot) {
        slot_of_block[static_cast<std::size_t>(grid.particle_blocks[slot])] =
            static_cast<std::uint32_t>(slot);
    }
    for (std::size_t body = 0; body < bodies.size(); ++body) {
        Particles<D, Real>& particles = bodies[body];
        std::vector<std::uint32_t> slot_of(particles.size());
        parallel_for(
            slot_of.size(),
            [&](std::size_t p) { slot_of[p] = slot_of_block[static_cast<std::size_t>(block_of[body][p])]; },
            8192);
        const auto to = stable_order(slot_of, grid.particle_blocks.size(), particles.begin);
        reorder(particles.position, to);
        reorder(particles.velocity, to);
        reorder(particles.gradient, to);
        reorder(particles.j, to);
        reorder(particles.offset, to);
        reorder(particles.id, to);
    }
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                      \
    template std::vector<int> place(const Layout<D>&, const std::vector<Vector<D, double>>&, std::uint32_t, \
                                    Particles<D, Real>&);                                                   \
    template std::vector<int> follow(const Grid<D, Real>&, Particles<D, Real>&);                            \
    template void sort_into_blocks(Grid<D, Real>&, std::span<Particles<D, Real>>,                           \
                                   const std::vector<std::vector<int>>&);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
