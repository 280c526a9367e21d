#include "mpm/step/take_out.h"

#include <algorithm>
#include <span>

#include "mpm/base/instantiate.h"
#include "mpm/particles/motion.h"
#include "mpm/state/ledger.h"

namespace tidewater::mpm {
namespace {

// Adds the particles `gone` (ascending), all of block `slot`, to the outflow.
template <int D, class Real>
void account(const Parameters<D>& parameters, const Grid<D, Real>& grid, const Particles<D, Real>& particles,
             std::size_t slot, std::span<const std::size_t> gone, Outflow<D>& outflow) {
    const Index<D> block = block_at<D>(grid.particle_blocks[slot]);
    alignas(64) Tile<D, Real> tile;
    load_velocities(grid, slot, tile.data());
    for (std::size_t n = 0; n < gone.size();) {
        const std::size_t first = gone[n];
        std::size_t end = first;  // of a run without gaps
        while (n < gone.size() && gone[n] == end) ++n, ++end;
        const Ledger<D> part = ledger_of(parameters, grid.layout, particles, block, first, end, tile);
        outflow.mass += part.mass;
        outflow.momentum += part.momentum;
        outflow.kinetic += part.kinetic;
        outflow.potential += part.gravitational + part.elastic;
    }
}

// Removes the particles `gone` (ascending) from every column.
template <int D, class Real>
void remove_particles(const std::vector<std::size_t>& gone, Particles<D, Real>& particles) {
    const std::size_t count = particles.size();
    for_each_column(particles, [&](const std::string&, auto& column) {
        if (column.empty()) return;
        std::size_t to = gone.front();
        for (std::size_t next = 0, p = to; p < count; ++p) {
            if (next < gone.size() && p == gone[next])
                ++next;
            else
                column[to++] = column[p];
        }
        column.resize(to);
    });
    for (auto& begin : particles.begin) {
        const auto before = std::lower_bound(gone.begin(), gone.end(), begin) - gone.begin();
        begin -= static_cast<std::uint32_t>(before);
    }
}

}  // namespace

template <int D, class Real>
void take_out(const std::vector<std::size_t>& gone, const Parameters<D>& parameters,
              const Grid<D, Real>& grid, Particles<D, Real>& body, Outflow<D>& outflow) {
    if (gone.empty()) return;
    auto first = gone.begin();
    for (std::size_t slot = 0; slot < grid.particle_blocks.size(); ++slot) {
        const auto last = std::lower_bound(first, gone.end(), std::size_t{body.begin[slot + 1]});
        if (first != last) account(parameters, grid, body, slot, std::span(first, last), outflow);
        first = last;
    }
    remove_particles(gone, body);
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                  \
    template void take_out(const std::vector<std::size_t>&, const Parameters<D>&, const Grid<D, Real>&, \
                           Particles<D, Real>&, Outflow<D>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
