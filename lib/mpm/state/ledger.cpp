#include "mpm/state/ledger.h"

#include "mpm/base/instantiate.h"
#include "mpm/bodies/lift.h"
#include "mpm/materials/materials.h"
#include "mpm/particles/motion.h"

namespace tidewater::mpm {
namespace {

template <int D>
void add(Ledger<D>& to, const Ledger<D>& from) {
    to.mass += from.mass;
    to.momentum += from.momentum;
    to.kinetic += from.kinetic;
    to.gravitational += from.gravitational;
    to.elastic += from.elastic;
}

template <int D, class Real>
double stored_energy(const Parameters<D>& parameters, const Particles<D, Real>& particles, std::size_t p) {
    double energy = 0.0;
    with_material<D, Real>(particles.material, [&]<class M>(std::type_identity<M>) {
        energy = M::stored_energy(M::model(parameters), particles, p);
    });
    return energy;
}

}  // namespace

template <int D, class Real>
Ledger<D> particle_ledger(const Parameters<D>& parameters, const Layout<D>& layout,
                          const Particles<D, Real>& particles, const Index<D>& block, std::size_t p,
                          const Tile<D, Real>& tile) {
    const Vector<D, double> point = global_position(layout, block, particles, p);
    Ledger<D> part;
    part.mass = particles.mass;
    part.gravitational = particles.mass * parameters.gravity * point[D - 1];
    part.elastic = stored_energy(parameters, particles, p);
    Vector<D, Real> v;
    Matrix<D, Real> g;
    gather<D, Real>(local_position<D, Real>(particles, p), tile.data(), v, g);
    const Vector<D, double> velocity = v.template cast<double>();
    const double affine = g.template cast<double>().squaredNorm();  // |Δx C|²
    part.momentum = particles.mass * velocity;
    part.kinetic = 0.5 * particles.mass * (velocity.squaredNorm() + 0.25 * affine);
    return part;
}

template <int D, class Real>
Ledger<D> take_ledger(const Simulation<D, Real>& s) {
    std::vector<Ledger<D>> of_block(s.grid.particle_blocks.size());
    for (const auto& particles : s.bodies) {
        parallel_for(of_block.size(), [&](std::size_t slot) {
            if (particles.begin[slot] == particles.begin[slot + 1]) return;
            const Index<D> block = block_at<D>(s.grid.particle_blocks[slot]);
            Tile<D, Real> tile;
            load_velocities(s.grid, slot, tile.data());
            for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
                add(of_block[slot], particle_ledger(s.parameters, s.grid.layout, particles, block, p, tile));
            }
        });
    }
    Ledger<D> total;
    for (const auto& ledger : of_block) add(total, ledger);
    for (const RigidBody& body : s.rigid) {
        total.mass += body.mass;
        total.gravitational +=
            body.mass * s.parameters.gravity * body.center_in_box(s.grid.layout.cell_size)[2];
        total.momentum += body.mass * drop<D>(body.velocity);
        total.kinetic += kinetic_energy(body);
    }
    return total;
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                    \
    template Ledger<D> particle_ledger(const Parameters<D>&, const Layout<D>&, const Particles<D, Real>&, \
                                       const Index<D>&, std::size_t, const Tile<D, Real>&);               \
    template Ledger<D> take_ledger(const Simulation<D, Real>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
