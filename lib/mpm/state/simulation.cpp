#include "mpm/state/simulation.h"

#include <span>

#include "core/hash.h"
#include "mpm/base/instantiate.h"

namespace tidewater::mpm {

template <int D, class Real>
std::size_t Simulation<D, Real>::particle_count() const {
    std::size_t count = 0;
    for (const auto& particles : bodies) count += particles.size();
    return count;
}

template <int D, class Real>
std::uint64_t state_hash(const Simulation<D, Real>& s) {
    std::uint64_t hash = hash_start;
    const auto add = [&](const auto& column) { hash = hash_bytes(std::as_bytes(std::span(column)), hash); };
    for (const auto& particles : s.bodies) {
        for_each_column(particles, [&](const std::string&, const auto& column) { add(column); });
        add(particles.begin);
    }
    add(s.grid.nodes);
    return hash;
}

#define TIDEWATER_INSTANTIATE(D, Real)   \
    template struct Simulation<D, Real>; \
    template std::uint64_t state_hash(const Simulation<D, Real>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
