#include "mpm/particles/binning.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "core/error.h"
#include "mpm/base/instantiate.h"

namespace tidewater::mpm {
namespace {

template <int D>
std::string place_text(const Vector<D, double>& point) {
    std::string text;
    for (int axis = 0; axis < D; ++axis) {
        char number[32];
        std::snprintf(number, sizeof number, "%s%.6g", axis > 0 ? ", " : "", point[axis]);
        text += number;
    }
    return "(" + text + ") m";
}

template <int D>
[[noreturn]] void fail_escaped(std::uint32_t id, const Vector<D, double>& point) {
    throw NumericsError("particle " + std::to_string(id) + " left the tank at " + place_text<D>(point) +
                        ", found while sorting particles; use a smaller simulate.cfl or a higher tank");
}

template <class Values>
void reorder(Values& column, const std::vector<std::uint32_t>& to) {
    if (column.empty()) return;
    Values sorted(column.size());
    parallel_for(
        to.size(), [&](std::size_t p) { sorted[to[p]] = column[p]; }, 8192);
    column.swap(sorted);
}

template <int D, class Real>
void reorder_columns(Particles<D, Real>& particles, const std::vector<std::uint32_t>& to) {
    for_each_column(particles, [&](const std::string&, auto& column) { reorder(column, to); });
}

// ---- place

template <int D>
BlockKey key_at(const Layout<D>& layout, const Vector<D, double>& point, std::uint32_t id) {
    Index<D> block;
    for (std::size_t axis = 0; axis < D; ++axis) {
        const double x = point[static_cast<int>(axis)] / layout.cell_size;
        if (!(x >= -1.0 && x < layout.cells[axis] + 1.0)) {
            throw NumericsError("particle " + std::to_string(id) + " starts outside of the tank, at " +
                                place_text<D>(point));
        }
        block[axis] = static_cast<int>(std::floor(x / Block<D>::width)) + 2;
    }
    return block_key<D>(block);
}

// The new place of each particle in a stable sort by key.
std::vector<std::uint32_t> order_by_key(const std::vector<BlockKey>& keys) {
    std::vector<std::uint32_t> from(keys.size()), to(keys.size());
    std::iota(from.begin(), from.end(), 0u);
    tbb::parallel_sort(from.begin(), from.end(), [&](std::uint32_t a, std::uint32_t b) {
        return keys[a] != keys[b] ? keys[a] < keys[b] : a < b;
    });
    for (std::size_t p = 0; p < from.size(); ++p) to[from[p]] = static_cast<std::uint32_t>(p);
    return to;
}

// begin[slot] is the number of keys below that of block `slot`.
std::vector<std::uint32_t> begins(const std::vector<BlockKey>& sorted_keys,
                                  const std::vector<BlockKey>& blocks) {
    std::vector<std::uint32_t> begin(blocks.size() + 1, static_cast<std::uint32_t>(sorted_keys.size()));
    auto from = sorted_keys.begin();
    for (std::size_t slot = 0; slot < blocks.size(); ++slot) {
        from = std::lower_bound(from, sorted_keys.end(), blocks[slot]);
        begin[slot] = static_cast<std::uint32_t>(from - sorted_keys.begin());
    }
    return begin;
}

// ---- sort_into_blocks

// The particles of one body that move from an old block to one of its neighbours (or stay in it).
struct Move {
    BlockKey to;
    std::uint32_t from;       // old slot
    std::uint32_t neighbour;  // 0 … 3^D − 1
    bool operator<(const Move& other) const {
        // Not by slot, because the order within a block must not depend on where in space the scene lies.
        return to != other.to ? to < other.to : neighbour < other.neighbour;
    }
};

template <int D>
using Counts = std::array<std::uint32_t, static_cast<std::size_t>(Block<D>::neighbours)>;

// Makes positions relative to the blocks that the particles are in now.
//     neighbour   [particle] the neighbour of its old block that it is in now, 0 … 3^D − 1
//     counts      [old slot][neighbour] number of particles
template <int D, class Real>
void follow(const Grid<D, Real>& grid, Particles<D, Real>& particles, std::vector<std::uint8_t>& neighbour,
            std::vector<Counts<D>>& counts) {
    const auto limit = stored<Real>(Block<D>::width);
    neighbour.resize(particles.size());
    counts.assign(grid.particle_blocks.size(), Counts<D>{});
    parallel_for(grid.particle_blocks.size(), [&](std::size_t slot) {
        const Index<D> block = block_at<D>(grid.particle_blocks[slot]);
        for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
            int k = 0;
            for (std::size_t axis = 0; axis < D; ++axis) {
                auto& x = particles.position[axis][p];
                const int first = grid.layout.first_node(block[axis]);
                const double at = first + cells_of(x);
                if (!(at >= -1.0 && at < grid.layout.cells[axis] + 1.0)) {
                    fail_escaped<D>(particles.id[p],
                                    global_position<D, Real>(grid.layout, block, particles, p));
                }
                const int step = x < Stored<Real>(0) ? -1 : x >= limit ? 1 : 0;
                x -= static_cast<Stored<Real>>(step) * limit;
                k = 3 * k + step + 1;
            }
            neighbour[p] = static_cast<std::uint8_t>(k);
            ++counts[slot][static_cast<std::size_t>(k)];
        }
    });
}

template <int D>
std::vector<Move> moves_of(const std::vector<BlockKey>& blocks, const std::vector<Counts<D>>& counts) {
    std::vector<Move> moves;
    for (std::size_t slot = 0; slot < blocks.size(); ++slot) {
        const Index<D> block = block_at<D>(blocks[slot]);
        for (int k = 0; k < Block<D>::neighbours; ++k) {
            if (counts[slot][static_cast<std::size_t>(k)] == 0) continue;
            Index<D> other = block;
            for (int axis = 0; axis < D; ++axis) {
                other[static_cast<std::size_t>(axis)] += neighbour_offset<D>(k, axis);
            }
            moves.push_back(
                {block_key<D>(other), static_cast<std::uint32_t>(slot), static_cast<std::uint32_t>(k)});
        }
    }
    std::sort(moves.begin(), moves.end());
    return moves;
}

// Replaces each count by the new place of its move's first particle, going through the sorted moves, and
// fills begin.
template <int D>
void find_places(const std::vector<Move>& moves, const std::vector<BlockKey>& blocks,
                 std::vector<Counts<D>>& counts, std::vector<std::uint32_t>& begin) {
    begin.resize(blocks.size() + 1);
    std::uint32_t sum = 0;
    auto move = moves.begin();
    for (std::size_t slot = 0; slot < blocks.size(); ++slot) {
        begin[slot] = sum;
        for (; move != moves.end() && move->to == blocks[slot]; ++move) {
            sum += std::exchange(counts[move->from][move->neighbour], sum);
        }
    }
    begin[blocks.size()] = sum;
}

}  // namespace

template <int D, class Real>
void place(const std::vector<std::span<const Vector<D, double>>>& points, Grid<D, Real>& grid,
           std::span<Particles<D, Real>> bodies) {
    std::vector<std::vector<BlockKey>> keys(bodies.size());
    std::vector<BlockKey> blocks;
    std::uint32_t next_id = 0;
    for (std::size_t body = 0; body < bodies.size(); ++body) {
        Particles<D, Real>& particles = bodies[body];
        const std::size_t count = points[body].size();
        if (count > std::numeric_limits<std::uint32_t>::max() - next_id) {
            throw NumericsError("more than 4.29e9 particles; use larger cells");
        }
        particles.id.resize(count);
        std::iota(particles.id.begin(), particles.id.end(), next_id);
        next_id += static_cast<std::uint32_t>(count);
        for (auto& column : particles.position) column.resize(count);
        keys[body].resize(count);
        for (std::size_t p = 0; p < count; ++p) {
            const Vector<D, double>& point = points[body][p];
            keys[body][p] = key_at<D>(grid.layout, point, particles.id[p]);
            const Index<D> block = block_at<D>(keys[body][p]);
            for (std::size_t axis = 0; axis < D; ++axis) {
                const double x = point[static_cast<int>(axis)] / grid.layout.cell_size;
                particles.position[axis][p] = stored<Real>(x - grid.layout.first_node(block[axis]));
            }
        }
        reorder_columns(particles, order_by_key(keys[body]));
        tbb::parallel_sort(keys[body].begin(), keys[body].end());
        std::unique_copy(keys[body].begin(), keys[body].end(), std::back_inserter(blocks));
    }
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    activate(grid, std::move(blocks));
    for (std::size_t body = 0; body < bodies.size(); ++body) {
        bodies[body].begin = begins(keys[body], grid.particle_blocks);
    }
}

template <int D, class Real>
void sort_into_blocks(Grid<D, Real>& grid, std::span<Particles<D, Real>> bodies) {
    std::vector<std::vector<std::uint8_t>> neighbour(bodies.size());
    std::vector<std::vector<Counts<D>>> counts(bodies.size());
    std::vector<std::vector<Move>> moves(bodies.size());
    std::vector<BlockKey> blocks;
    for (std::size_t body = 0; body < bodies.size(); ++body) {
        follow(grid, bodies[body], neighbour[body], counts[body]);
        moves[body] = moves_of<D>(grid.particle_blocks, counts[body]);
        for (const Move& move : moves[body]) blocks.push_back(move.to);
    }
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    for (std::size_t body = 0; body < bodies.size(); ++body) {
        Particles<D, Real>& particles = bodies[body];
        const std::vector<std::uint32_t> old_begin = particles.begin;
        find_places<D>(moves[body], blocks, counts[body], particles.begin);
        std::vector<std::uint32_t> to(particles.size());
        parallel_for(counts[body].size(), [&](std::size_t slot) {
            Counts<D>& next = counts[body][slot];
            for (std::size_t p = old_begin[slot]; p < old_begin[slot + 1]; ++p)
                to[p] = next[neighbour[body][p]]++;
        });
        reorder_columns(particles, to);
    }
    activate(grid, std::move(blocks));
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                          \
    template void place(const std::vector<std::span<const Vector<D, double>>>&, Grid<D, Real>&, \
                        std::span<Particles<D, Real>>);                                         \
    template void sort_into_blocks(Grid<D, Real>&, std::span<Particles<D, Real>>);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
