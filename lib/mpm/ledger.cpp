#include "mpm/ledger.h"

#include "mpm/lift.h"
#include "mpm/motion.h"

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

// The strain of a particle, in double.
template <int D, class Real>
std::array<double, static_cast<std::size_t>(symmetric_size<D>)> strain_of(const Particles<D, Real>& particles,
                                                                          std::size_t p) {
    std::array<double, static_cast<std::size_t>(symmetric_size<D>)> strain;
    for (std::size_t c = 0; c < strain.size(); ++c) strain[c] = static_cast<double>(particles.strain[c][p]);
    return strain;
}

template <int D, class Real>
double elastic_energy(const Parameters<D>& parameters, const Particles<D, Real>& particles, std::size_t p) {
    const WaterModel& water = parameters.water;
    switch (particles.material) {
        case Material::water:
            return particles.volume *
                   water_energy(static_cast<double>(particles.j[p]), water.bulk_modulus(), water.exponent);
        case Material::ice:
            return particles.volume * ice_energy<D>(parameters.ice, strain_of(particles, p));
        case Material::rigid:
            return 0.0;
    }
    return 0.0;
}

}  // namespace

template <int D, class Real>
Ledger<D> take_ledger(const Simulation<D, Real>& s) {
    std::vector<Ledger<D>> of_block(s.grid.particle_blocks.size());
    for (const auto& particles : s.bodies) {
        const bool rigid = particles.material == Material::rigid;
        for_each_motion(s.grid, particles,
                        [&](std::size_t slot, const Index<D>& block, std::size_t p, const Vector<D, Real>& v,
                            const Matrix<D, Real>& g) {
                            const Vector<D, double> point =
                                global_position(s.grid.layout, block, particles, p);
                            Ledger<D>& sum = of_block[slot];
                            sum.mass += particles.mass;
                            sum.gravitational += particles.mass * s.parameters.gravity * point[D - 1];
                            sum.elastic += elastic_energy(s.parameters, particles, p);
                            if (rigid) return;
                            const Vector<D, double> velocity = v.template cast<double>();
                            const double affine = g.template cast<double>().squaredNorm();  // |Δx C|²
                            sum.momentum += particles.mass * velocity;
                            sum.kinetic += 0.5 * particles.mass * (velocity.squaredNorm() + 0.25 * affine);
                        });
    }
    Ledger<D> total;
    for (const auto& ledger : of_block) add(total, ledger);
    // A body's own motion and not what its particles read from the grid: that knows nothing yet of the walls'
    // last push.
    for (const RigidBody& body : s.rigid) {
        total.momentum += body.mass * drop<D>(body.velocity);
        total.kinetic += kinetic_energy(body);
    }
    return total;
}

template Ledger<2> take_ledger(const Simulation<2, float>&);
template Ledger<2> take_ledger(const Simulation<2, double>&);
template Ledger<3> take_ledger(const Simulation<3, float>&);
template Ledger<3> take_ledger(const Simulation<3, double>&);

}  // namespace tidewater::mpm
