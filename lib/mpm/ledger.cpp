#include "mpm/ledger.h"

namespace tidewater::mpm {
namespace {

template <int D, class Real>
Ledger<D> block_ledger(const Simulation<D, Real>& s, const Particles<D, Real>& particles, std::size_t slot) {
    const WaterModel& water = s.parameters.water;
    const Index<D> block = s.grid.layout.block_at(s.grid.particle_blocks[slot]);
    Ledger<D> sum;
    for (std::size_t p = particles.begin[slot]; p < particles.begin[slot + 1]; ++p) {
        const Vector<D, double> velocity = particles.velocity[p].template cast<double>();
        const double affine = particles.gradient[p].template cast<double>().squaredNorm();  // |Δx C|²
        const Vector<D, double> point = global_position<D, Real>(s.grid.layout, block, particles.position[p]);
        sum.mass += particles.mass;
        sum.momentum += particles.mass * velocity;
        sum.kinetic += 0.5 * particles.mass * (velocity.squaredNorm() + 0.25 * affine);
        sum.gravitational += particles.mass * s.parameters.gravity * point[D - 1];
        if (particles.material == Material::water) {
            sum.elastic += particles.volume * water_energy(static_cast<double>(particles.j[p]),
                                                           water.bulk_modulus(), water.exponent);
        }
    }
    return sum;
}

template <int D>
void add(Ledger<D>& to, const Ledger<D>& from) {
    to.mass += from.mass;
    to.momentum += from.momentum;
    to.kinetic += from.kinetic;
    to.gravitational += from.gravitational;
    to.elastic += from.elastic;
}

}  // namespace

template <int D, class Real>
Ledger<D> take_ledger(const Simulation<D, Real>& s) {
    std::vector<Ledger<D>> of_block(s.grid.particle_blocks.size());
    parallel_for(of_block.size(), [&](std::size_t slot) {
        for (const auto& particles : s.bodies) add(of_block[slot], block_ledger(s, particles, slot));
    });
    Ledger<D> total;
    for (const auto& ledger : of_block) add(total, ledger);
    return total;
}

template Ledger<2> take_ledger(const Simulation<2, float>&);
template Ledger<2> take_ledger(const Simulation<2, double>&);
template Ledger<3> take_ledger(const Simulation<3, float>&);
template Ledger<3> take_ledger(const Simulation<3, double>&);

}  // namespace tidewater::mpm
