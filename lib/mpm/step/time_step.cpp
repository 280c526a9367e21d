#include "mpm/step/time_step.h"

#include <algorithm>
#include <cmath>

#include "mpm/base/instantiate.h"
#include "mpm/materials/materials.h"

namespace tidewater::mpm {

template <int D, class Real>
Signal fastest_sound(const Parameters<D>& parameters, const std::vector<Particles<D, Real>>& bodies,
                     const Findings& findings) {
    Signal fastest;
    for (const auto& particles : bodies) {
        with_material<D, Real>(particles.material, [&]<class M>(std::type_identity<M>) {
            const double sound = M::sound_speed(M::model(parameters), findings);
            if (sound > fastest.sound) fastest = {.sound = sound, .motion = 0.0, .material = M::material};
        });
    }
    return fastest;
}

template <int D, class Real>
Signal find_signal(const Grid<D, Real>& grid, const std::vector<double>& node_speed,
                   const std::vector<Signal>& of_block, const std::vector<RigidBody>& rigid,
                   std::vector<double>& near_speed) {
    near_speed.resize(grid.particle_blocks.size());
    Signal fastest, fastest_sound;
    for (std::size_t slot = 0; slot < near_speed.size(); ++slot) {
        double v = 0.0;
        for (const int nodes : grid.nodes_of_tile[slot])
            v = std::max(v, node_speed[static_cast<std::size_t>(nodes)]);
        near_speed[slot] = v;
        Signal here = of_block[slot];
        if (here.sound > fastest_sound.sound) fastest_sound = here;
        here.motion = v;
        if (here.speed() > fastest.speed()) fastest = here;
    }
    for (const RigidBody& body : rigid) {
        Signal here = fastest_sound;
        here.motion = max_speed(body);
        if (here.speed() > fastest.speed()) fastest = here;
    }
    return fastest;
}

template <int D, class Real>
double stable_time_step(const Simulation<D, Real>& s) {
    const double dx = s.grid.layout.cell_size, v = s.speeds.particle;
    const double g = s.parameters.gravity;
    // The root of v Δt + g Δt² = reach, without cancellation; reach lies well within the sorting margin.
    const double reach = 0.4 * dx;
    const double falling = 2.0 * reach / (v + std::sqrt(v * v + 4.0 * g * reach));
    return std::min(s.parameters.cfl * dx / s.speeds.signal.speed(), falling);
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                          \
    template double stable_time_step(const Simulation<D, Real>&);                               \
    template Signal find_signal(const Grid<D, Real>&, const std::vector<double>&,               \
                                const std::vector<Signal>&, const std::vector<RigidBody>&,      \
                                std::vector<double>&);                                          \
    template Signal fastest_sound(const Parameters<D>&, const std::vector<Particles<D, Real>>&, \
                                  const Findings&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
