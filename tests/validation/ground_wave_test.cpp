// A long wave over ground with drag (mpm/boundaries/drag.h), against the decay that its energy allows.
//
// Drag takes ρ C_d ∫ |u_b|³ dx from a solitary wave of the energy E(a), so that over the way x
//
//     da/dx = −ρ C_d ∫ |u_b|³ dx/(c dE/da) + (a/a') da'/dx
//
// with a' the height without drag, of which the scheme itself takes some. E, c and u_b are Grimshaw's; to
// first order a = a_0/(1 + (8/15) C_d a_0 x/D²).
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/wave_theory.h"
#include "support/rough_ground.h"
#include "support/wave_tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

constexpr double cell = 5.0, ground = 10.0, depth = 50.0, height = 5.0, length = 3400.0, way = 2000.0;

constexpr int stations = 20;  // along the way

// The wave's height at each station, m: the mean over 40 m, above the level that it has left behind.
std::vector<double> heights(const DragLaw& drag) {
    const analysis::InitialWave wave{.kind = analysis::WaveKind::solitary,
                                     .height = height,
                                     .length = 0.0,
                                     .center = 600.0,
                                     .depth = depth};
    Start<2> start;
    start.cell_size = cell;
    start.cells = {static_cast<int>(length / cell), 15};
    start.parameters.water.sound_speed = 220.0;
    start.parameters.boundaries.drag.bed = drag;
    test::lay_bed<2>([](double) { return ground; }, {}, start);
    auto& water = start.bodies.emplace_back();
    water.surface = ground + depth;
    for (double x = 0.25 * cell; x < 1.1 * length; x += 0.5 * cell) {
        for (double z = 0.25 * cell; z < depth; z += 0.5 * cell) {
            const auto [at, up] = analysis::displace(wave, x, z);
            if (at >= length) continue;
            const auto flow = analysis::wave_flow(wave, at, up);
            water.points.emplace_back(at, ground + up);
            water.velocity.emplace_back(flow.u, flow.w);
            water.head.push_back(flow.head);
        }
    }
    water.volume = 0.25 * cell * cell * static_cast<double>(water.points.size());
    water.mass = start.parameters.water.density * water.volume;
    auto s = make_simulation<2, float>(start);
    const double step = way / stations;
    std::vector<double> crests;
    for (int station = 0; station <= stations; ++station) {
        const double at = wave.center + station * step;
        while (s.time < station * step / analysis::solitary_celerity(wave)) advance(s, stable_time_step(s));
        double crest = 0.0;
        for (double x = at - 300.0; x < at + 100.0; x += 5.0)
            crest = std::max(crest, test::level_at(s, x, 20.0));
        crests.push_back(crest - depth);
    }
    return crests;
}

analysis::InitialWave solitary(double a) {
    return {.kind = analysis::WaveKind::solitary, .height = a, .length = 0.0, .center = 0.0, .depth = depth};
}

// The energy, J/m, and ∫ |u_b|³ dx of a solitary wave of this height.
struct Budget {
    double energy = 0.0, cubes = 0.0;
};
Budget budget(double a) {
    const analysis::InitialWave wave = solitary(a);
    constexpr double step = 2.0;
    constexpr int layers = 10;
    Budget sum;
    for (double x = -1000.0; x < 1000.0; x += step) {
        const double eta = analysis::elevation(wave, x), layer = (depth + eta) / layers;
        sum.energy += 0.5 * 1000.0 * 9.81 * eta * eta * step;
        for (int n = 0; n < layers; ++n) {
            const auto flow = analysis::wave_flow(wave, x, (n + 0.5) * layer);
            sum.energy += 0.5 * 1000.0 * (flow.u * flow.u + flow.w * flow.w) * layer * step;
        }
        sum.cubes += std::pow(std::abs(analysis::wave_flow(wave, x, 0.0).u), 3.0) * step;
    }
    return sum;
}

// −da/dx by drag.
double decay_rate(double a, double coefficient) {
    const double rise = (budget(1.02 * a).energy - budget(0.98 * a).energy) / (0.04 * a);
    return 1000.0 * coefficient * budget(a).cubes / (analysis::solitary_celerity(solitary(a)) * rise);
}

}  // namespace

TEST_CASE("a wave over 2 km of ground with drag decays as its energy says") {
    DragLaw drag;
    drag.coefficient = 0.1;
    const auto free = heights({}), dragged = heights(drag);
    double expected = dragged.front();
    for (std::size_t n = 1; n < free.size(); ++n)
        expected *= free[n] / free[n - 1] *
                    (1.0 - decay_rate(expected, drag.coefficient) / expected * way / stations);
    const double decay = 1.0 - dragged.back() / free.back(), by_theory = 1.0 - expected / free.back();
    MESSAGE("decay by drag " << decay << ", by theory " << by_theory << "; the scheme's own "
                             << 1.0 - free.back() / free.front());
    CHECK(std::abs(decay - by_theory) < 0.05 * by_theory);
}
