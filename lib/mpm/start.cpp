#include "mpm/start.h"

#include <algorithm>

#include "mpm/binning.h"

namespace tidewater::mpm {

template <int D, class Real>
Simulation<D, Real> make_simulation(const Start<D>& start) {
    Simulation<D, Real> s;
    s.parameters = start.parameters;
    s.grid.layout = Layout<D>(start.cell_size, start.cells);
    std::vector<std::vector<int>> block_of;
    std::uint32_t next_id = 0;
    double least_j = 0.0;
    for (const auto& body : start.bodies) {
        if (body.points.empty()) continue;
        Particles<D, Real>& particles = s.bodies.emplace_back();
        const auto count = static_cast<double>(body.points.size());
        particles.material = body.material;
        particles.mass = body.mass / count;
        particles.volume = body.volume / count;
        block_of.push_back(place(s.grid.layout, body.points, next_id, particles));
        next_id += static_cast<std::uint32_t>(body.points.size());
        if (body.material == Material::rigid) {
            s.rigid.push_back(make_rigid_body(body.points, start.cell_size, particles));
        } else {
            for (const auto& point : body.points) {
                const double j =
                    hydrostatic_j(body.surface - point[D - 1], s.parameters.gravity, s.parameters.water);
                particles.j.push_back(static_cast<Real>(j));
                least_j = std::min(least_j, j);
            }
            s.speeds.sound = s.parameters.water.sound_speed *
                             water_sound_speed_ratio(least_j, s.parameters.water.exponent);
        }
    }
    sort_into_blocks<D, Real>(s.grid, s.bodies, block_of);
    return s;
}

#define TIDEWATER_INSTANTIATE(D, Real) template Simulation<D, Real> make_simulation(const Start<D>&);
TIDEWATER_INSTANTIATE(2, float)
TIDEWATER_INSTANTIATE(2, double)
TIDEWATER_INSTANTIATE(3, float)
TIDEWATER_INSTANTIATE(3, double)

}  // namespace tidewater::mpm
