// Linear potential flow in a 2D tank with a box that heaves in it: what a floating or submerged block should
// do. On square cells, pressures at their middles, accelerations on their faces (MAC).
//
//     a = −∇q,   ∇²q = 0          q = p/ρ m²/s² beyond hydrostatic pressure, a the water's acceleration
//     ∂q/∂n = 0                   on the walls and the bed
//     −∂q/∂z = A                  on the box's lower and upper face, A its acceleration upward; sides: 0
//     q = g η,   η̈ = −∂q/∂z       at the still level z = depth, where η is the surface's elevation
//
// With q = q⁰ + A q¹, q⁰ of the surface alone and q¹ of A = 1 under q = 0 at the still level, the water
// pushes the box by F⁰ − M_a A, and M_a is its added mass for motions that are quick beside the waves. A box
// that pierces the surface and floats at rest as given has
//
//     (M + M_a) A = F⁰ − ρ g b ζ         b its width, ζ how far it is lifted
//
// Per metre of width. The box stays where it was given, as linear theory wants it. Faces must lie on those of
// cells. Error O(h^(4/3)) by the box's corners. Test: tests/validation/floating_test.cpp.
#pragma once

#include <Eigen/SparseCholesky>
#include <cmath>
#include <vector>

namespace tidewater::test {

struct FlowBox {
    double left = 0.0, right = 0.0, bottom = 0.0, top = 0.0;  // m in the tank
};

// The surface of each column of cells; those in the box stay 0.
struct Surface {
    Eigen::VectorXd elevation, speed;  // η, m; its rate, m/s
};

class PotentialFlow {
public:
    static constexpr double density = 1000.0, gravity = 9.81;

    // Lengths in m, whole numbers of cells.
    PotentialFlow(double length, double depth, double cell, FlowBox box)
        : columns_(static_cast<int>(std::lround(length / cell))),
          rows_(static_cast<int>(std::lround(depth / cell))),
          cell_(cell) {
        int count = 0;
        for (int i = 0; i < columns_; ++i) {
            for (int k = 0; k < rows_; ++k) {
                const double x = (i + 0.5) * cell, z = (k + 0.5) * cell;
                const bool solid = x > box.left && x < box.right && z > box.bottom && z < box.top;
                unknown_.push_back(solid ? -1 : count++);
            }
        }
        std::vector<Eigen::Triplet<double>> entries;
        above_ = Eigen::VectorXd::Zero(count);
        for (int i = 0; i < columns_; ++i) {
            for (int k = 0; k < rows_; ++k) {
                const int here = at(i, k);
                if (here < 0) continue;
                double own = k == rows_ - 1 ? 2.0 : 0.0;  // the still level is half a cell away
                for (const auto& [to_i, to_k] : {std::pair{i - 1, k}, {i + 1, k}, {i, k - 1}, {i, k + 1}}) {
                    if (to_i < 0 || to_i == columns_ || to_k < 0 || to_k == rows_) continue;
                    const int there = at(to_i, to_k);
                    if (there >= 0) {
                        entries.emplace_back(here, there, -1.0);
                        own += 1.0;
                    } else if (to_i == i) {
                        above_[here] += k - to_k;
                    }
                }
                entries.emplace_back(here, here, own);
            }
        }
        Eigen::SparseMatrix<double> laplacian(count, count);
        laplacian.setFromTriplets(entries.begin(), entries.end());
        laplacian_.compute(laplacian);
        unit_ = laplacian_.solve(cell_ * above_);
    }

    // M_a, kg/m. On the box's faces, half a cell from the cells' middles, q¹ is h/2 more than there.
    double added_mass() const { return -force(unit_) + 0.5 * density * cell_ * cell_ * above_.squaredNorm(); }

    Surface still() const { return {Eigen::VectorXd::Zero(columns_), Eigen::VectorXd::Zero(columns_)}; }

    // F⁰, N/m; writes q⁰.
    double surface_force(const Surface& surface, Eigen::VectorXd& pressure) const {
        Eigen::VectorXd right = Eigen::VectorXd::Zero(above_.size());
        for (int i = 0; i < columns_; ++i) {
            const int top = at(i, rows_ - 1);
            if (top >= 0) right[top] = 2.0 * gravity * surface.elevation[i];
        }
        pressure = laplacian_.solve(right);
        return force(pressure);
    }

    // One step (symplectic Euler) under q⁰ and the box's acceleration.
    void advance(double dt, const Eigen::VectorXd& pressure, double acceleration, Surface& surface) const {
        for (int i = 0; i < columns_; ++i) {
            const int top = at(i, rows_ - 1);
            if (top < 0) continue;
            const double q = pressure[top] + acceleration * unit_[top];
            surface.speed[i] += dt * (q - gravity * surface.elevation[i]) / (0.5 * cell_);
            surface.elevation[i] += dt * surface.speed[i];
        }
    }

private:
    int at(int i, int k) const { return unknown_[static_cast<std::size_t>(i * rows_ + k)]; }
    double force(const Eigen::VectorXd& pressure) const { return -density * cell_ * above_.dot(pressure); }

    int columns_, rows_;
    double cell_;
    std::vector<int> unknown_;  // [column][row], −1 in the box
    Eigen::VectorXd above_;     // of each unknown: 1 right above the box, −1 right below it
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> laplacian_;
    Eigen::VectorXd unit_;  // q¹
};

struct Heave {
    double lift = 0.0, speed = 0.0;  // ζ, m, and its rate, m/s
};

// A floating box of this mass and width (kg/m, m) is let go at rest from `lift` over still water: its motion
// at every multiple of dt up to `until`.
inline std::vector<Heave> free_heave(const PotentialFlow& flow, double mass, double width, double lift,
                                     double dt, double until) {
    const double inertia = mass + flow.added_mass();
    Surface surface = flow.still();
    Eigen::VectorXd pressure;
    std::vector<Heave> motion{{.lift = lift}};
    for (double time = 0.0; time < until; time += dt) {
        Heave now = motion.back();
        const double weight = flow.density * flow.gravity * width * now.lift;
        const double acceleration = (flow.surface_force(surface, pressure) - weight) / inertia;
        now.speed += dt * acceleration;
        now.lift += dt * now.speed;
        flow.advance(dt, pressure, acceleration, surface);
        motion.push_back(now);
    }
    return motion;
}

}  // namespace tidewater::test
