#include "mpm/step/outflow.h"

#include <algorithm>
#include <span>

#include "mpm/state/ledger.h"
#include "mpm/particles/motion.h"

namespace tidewater::mpm {
namespace {

// The particles `gone` are of block `slot`.
template <int D, class Real>
void account(Simulation<D, Real>& s, const Particles<D, Real>& particles, std::size_t slot,
             std::span<const std::size_t> gone) {
    const Index<D> block = block_at<D>(s.grid.particle_blocks[slot]);
    Tile<D, Real> tile;
    load_velocities(s.grid, slot, tile.data());
    for (const std::size_t p : gone) {
        const Ledger<D> part = particle_ledger(s, particles, block, p, tile);
        s.outflow.mass += part.mass;
        s.outflow.momentum += part.momentum;
        s.outflow.energy += part.kinetic + part.gravitational + part.elastic;
    }
}

// Keeps the rest of every column; `gone` is rising.
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
void let_out(const std::vector<std::size_t>& gone, Particles<D, Real>& body, Simulation<D, Real>& s) {
    if (gone.empty()) return;
    auto first = gone.begin();
    for (std::size_t slot = 0; slot < s.grid.particle_blocks.size(); ++slot) {
        const auto last = std::lower_bound(first, gone.end(), std::size_t{body.begin[slot + 1]});
        if (first != last) account(s, body, slot, std::span(first, last));
        first = last;
    }
    remove_particles(gone, body);
}

#define TIDEWATER_INSTANTIATE(D, Real) \
    template void let_out(const std::vector<std::size_t>&, Particles<D, Real>&, Simulation<D, Real>&);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
