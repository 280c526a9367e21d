// A cantilever of elastic ice in the engine, clamped by the stick wall at x = 0.
#pragma once

#include "support/ice_body.h"
#include "support/plane_elasticity.h"
#include "support/state.h"
#include "support/zero_crossings.h"

namespace tidewater::test {

template <class Real>
class Beam {
public:
    Beam(const Cantilever& beam, int cells_across) : tip_(beam.length) {
        mpm::Start<2> start;
        start.cell_size = beam.height / cells_across;
        const int margin = 4 + cells_across / 5;
        const double dx = start.cell_size;
        const Vector<2, double> low(0.0, margin * dx);
        const Vector<2, double> high = low + Vector<2, double>(beam.length, beam.height);
        start.cells = {static_cast<int>(std::lround(high[0] / dx)) + margin, cells_across + 2 * margin};
        start.parameters.gravity = beam.gravity;
        start.parameters.ice = beam.ice;
        start.parameters.ice.fracture = false;
        start.parameters.boundaries.walls[0][0] = mpm::WallRule::stick;
        rest_ = add_ice<2>(box_shape<2>(low, high), start).points;
        simulation_ = mpm::make_simulation<2, Real>(start);
    }

    // Damps the motion until little of it is left and measures both answers: where it rests, and how often it
    // swings around its unloaded shape once gravity is gone.
    CantileverAnswer measure(double expected_frequency) {
        const double omega = 2 * std::acos(-1.0) * expected_frequency;
        while (simulation_.time < 2.5 / expected_frequency) step(2 * omega);
        const Field at_rest = displacement();
        CantileverAnswer answer;
        answer.sag = sag(at_rest);
        simulation_.parameters.gravity = 0.0;
        ZeroCrossings crossings;
        while (crossings.count() < 4) {
            step(0.0);
            if (simulation_.step % 8 == 0) crossings.add(simulation_.time, product(displacement(), at_rest));
        }
        answer.frequency = 1.0 / crossings.period();
        return answer;
    }

private:
    using Field = std::vector<Vector<2, double>>;

    // damping: of velocities, 1/s
    void step(double damping) {
        const double dt = mpm::stable_time_step(simulation_);
        mpm::advance(simulation_, dt);
        if (damping == 0.0) return;
        for (auto& node : simulation_.grid.nodes)
            node.template head<2>() *= static_cast<Real>(1 - damping * dt);
    }

    Field displacement() const {
        Field field = read_state(simulation_).x;
        for (std::size_t p = 0; p < field.size(); ++p) field[p] -= rest_[p];
        return field;
    }

    // With the shape of rest, this tells the first mode alone: of the others that shape has little, and they
    // are orthogonal.
    static double product(const Field& a, const Field& b) {
        double sum = 0.0;
        for (std::size_t p = 0; p < a.size(); ++p) sum += a[p].dot(b[p]);
        return sum;
    }

    // The mean of the section at the tip, by the line through the outermost two columns of particles.
    double sag(const Field& field) const {
        double last = 0.0, before = 0.0;
        long count = 0;
        for (std::size_t p = 0; p < rest_.size(); ++p) {
            const double columns = (tip_ - rest_[p][0]) / (0.5 * simulation_.grid.layout.cell_size);
            if (columns > 2.0) continue;
            (columns < 1.0 ? last : before) -= field[p][1];
            ++count;
        }
        return (1.5 * last - 0.5 * before) / (0.5 * static_cast<double>(count));
    }

    double tip_;  // where the beam ends, m
    Field rest_;
    mpm::Simulation<2, Real> simulation_;
};

}  // namespace tidewater::test
