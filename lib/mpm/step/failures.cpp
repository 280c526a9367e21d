#include "mpm/step/failures.h"

#include <cmath>

#include "core/error.h"
#include "mpm/base/instantiate.h"
#include "mpm/materials/materials.h"

namespace tidewater::mpm {
namespace {

// Says what is wrong with a particle; null if nothing is.
template <int D, class Real>
const char* complaint(const Particles<D, Real>& particles, std::size_t p, bool may_fail) {
    bool finite = particles.j.empty() || std::isfinite(particles.j[p]);
    for (const auto& column : particles.strain)
        finite = finite && (column.empty() || std::isfinite(column[p]));
    if (!finite) return " has a strain that is not a number; use a smaller simulate.cfl";
    const char* what = nullptr;
    with_material<D, Real>(particles.material, [&]<class M>(std::type_identity<M>) {
        what = M::complaint(particles, p, may_fail);
    });
    return what;
}

// Names the first particle whose state cannot be used; empty if there is none.
template <int D, class Real>
std::string bad_particle(const Interval& interval, const Parameters<D>& parameters,
                         const std::vector<Particles<D, Real>>& bodies) {
    const bool may_fail = parameters.ice.fracture && !interval.settling;
    for (const auto& particles : bodies) {
        for (std::size_t p = 0; p < particles.size(); ++p) {
            const char* what = complaint(particles, p, may_fail);
            if (what == nullptr) continue;
            return std::string(material_name(particles.material)) + " particle " +
                   std::to_string(particles.id[p]) + what;
        }
    }
    return {};
}

}  // namespace

std::string where(const Interval& interval, const char* phase) {
    return "step " + std::to_string(interval.step) + ", t = " + std::to_string(interval.begin) +
           " s, phase " + phase + ": ";
}

template <int D, class Real>
void fail_at_bad_particle(const Interval& interval, const Parameters<D>& parameters,
                          const std::vector<Particles<D, Real>>& bodies) {
    throw NumericsError(where(interval, "pass") + bad_particle(interval, parameters, bodies));
}

template <int D, class Real>
void fail_at_bad_node(const Interval& interval, const Parameters<D>& parameters, const Grid<D, Real>& grid,
                      const std::vector<Particles<D, Real>>& bodies, std::size_t slot) {
    if (const std::string what = bad_particle(interval, parameters, bodies); !what.empty()) {
        throw NumericsError(where(interval, "pass") + what);
    }
    const Index<D> block = block_at<D>(grid.node_blocks[slot]);
    std::string place;
    for (std::size_t axis = 0; axis < D; ++axis) {
        const double middle = grid.layout.first_node(block[axis]) + 0.5 * Block<D>::width;
        place += (axis > 0 ? ", " : "") + std::to_string(grid.layout.cell_size * middle);
    }
    throw NumericsError(where(interval, "grid") + "a velocity near (" + place +
                        ") m is not a number; use a smaller simulate.cfl");
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                          \
    template void fail_at_bad_particle(const Interval&, const Parameters<D>&,                   \
                                       const std::vector<Particles<D, Real>>&);                 \
    template void fail_at_bad_node(const Interval&, const Parameters<D>&, const Grid<D, Real>&, \
                                   const std::vector<Particles<D, Real>>&, std::size_t);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
