// References for a cantilever under its own weight: Timoshenko's beam, and plane linear elasticity.
//
//     σ = κ tr(ε) I + 2μ dev(ε),   dev(ε) = ε − tr(ε)/2 I          small strains of mpm/materials/ice.h in 2D
//     E' = 4μκ/(κ+μ)                                               modulus of thin beams
#pragma once

#include <Eigen/SparseCholesky>
#include <cmath>
#include <vector>

#include "mpm/materials/ice.h"

namespace tidewater::test {

struct Cantilever {
    double length = 100.0, height = 40.0;  // m
    double gravity = 9.81;                 // m/s²
    mpm::IceModel ice;

    double beam_modulus() const {
        const double mu = ice.shear_modulus(), kappa = ice.bulk_modulus(2);
        return 4 * kappa * mu / (kappa + mu);
    }
};

struct CantileverAnswer {
    double sag = 0.0;        // of the tip, mean over the height, m
    double frequency = 0.0;  // the lowest, Hz
};

// Timoshenko's beam: w' = ψ + Q/(kGA), ψ' = M/(EI), Q' = −ω²ρA w, M' = −Q − ω²ρI ψ; w = ψ = 0 at the clamp,
// Q = M = 0 at the tip. shear_share k = 5/6 for a rectangle; infinite, it is Euler–Bernoulli's but for the
// rotatory inertia.
class TimoshenkoBeam {
public:
    explicit TimoshenkoBeam(const Cantilever& beam, double shear_share = 5.0 / 6.0)
        : length_(beam.length),
          bending_(beam.beam_modulus() * std::pow(beam.height, 3) / 12),
          shear_(shear_share * beam.ice.shear_modulus() * beam.height),
          mass_(beam.ice.density * beam.height),
          turning_(mass_ * beam.height * beam.height / 12),
          load_(mass_ * beam.gravity) {}

    CantileverAnswer answer() const {
        const double sag =
            load_ * std::pow(length_, 4) / (8 * bending_) + load_ * length_ * length_ / (2 * shear_);
        double low = 1e-3, high = low;
        while (misfit(high) * misfit(low) > 0) high *= 1.1;
        for (int n = 0; n < 60; ++n) {
            const double middle = 0.5 * (low + high);
            (misfit(middle) * misfit(low) > 0 ? low : high) = middle;
        }
        return {sag, low / (2 * std::acos(-1.0))};
    }

private:
    using State = Eigen::Vector4d;  // w, ψ, M, Q

    State slope(const State& y, double omega2) const {
        return {y[1] + y[3] / shear_, y[2] / bending_, -y[3] - omega2 * turning_ * y[1],
                -omega2 * mass_ * y[0]};
    }
    State tip(State y, double omega2) const {
        const double h = length_ / 500;
        for (int n = 0; n < 500; ++n) {
            const State a = slope(y, omega2), b = slope(y + h / 2 * a, omega2),
                        c = slope(y + h / 2 * b, omega2), d = slope(y + h * c, omega2);
            y += h / 6 * (a + 2 * b + 2 * c + d);
        }
        return y;
    }
    // Zero at a natural frequency.
    double misfit(double omega) const {
        const State m = tip(State::Unit(2) * length_, omega * omega), q = tip(State::Unit(3), omega * omega);
        return m[2] * q[3] - m[3] * q[2];
    }

    double length_, bending_, shear_, mass_, turning_, load_;
};

// Finite elements with nine nodes (biquadratic, 3 × 3 Gauss points, consistent mass), clamped along x = 0.
class PlaneElements {
public:
    PlaneElements(const Cantilever& beam, int along, int up)
        : beam_(beam), along_(along), up_(up), width_(beam.length / along), tall_(beam.height / up) {
        assemble();
    }

    CantileverAnswer answer() const {
        const Eigen::SimplicialLDLT<Sparse> solver(stiffness_);
        Eigen::VectorXd pull = Eigen::VectorXd::Zero(stiffness_.rows());
        for (Eigen::Index n = 1; n < pull.size(); n += 2) pull[n] = -beam_.gravity;
        Eigen::VectorXd mode = solver.solve(mass_ * pull);
        const double sag = -mean_of_tip(mode);
        double omega2 = 0;
        for (int n = 0; n < 30; ++n) {  // inverse iteration
            mode /= std::sqrt(mode.dot(mass_ * mode));
            omega2 = mode.dot(stiffness_ * mode);
            mode = solver.solve(mass_ * mode);
        }
        return {sag, std::sqrt(omega2) / (2 * std::acos(-1.0))};
    }

private:
    using Sparse = Eigen::SparseMatrix<double>;
    using Triplets = std::vector<Eigen::Triplet<double>>;
    using Shapes = Eigen::Matrix<double, 9, 1>;

    // The first unknown of a node; negative on the clamp.
    int unknown(int i, int k) const { return 2 * ((i - 1) * (2 * up_ + 1) + k); }

    void assemble() {
        const Eigen::Matrix<double, 18, 18> k = element(true), m = element(false);
        Triplets stiff, mass;
        for (int e = 0; e < along_ * up_; ++e) {
            for (int row = 0; row < 18; ++row) {
                for (int col = 0; col < 18; ++col) {
                    const int r = global(e, row), c = global(e, col);
                    if (r < 0 || c < 0) continue;
                    stiff.emplace_back(r, c, k(row, col));
                    mass.emplace_back(r, c, m(row, col));
                }
            }
        }
        const int size = unknown(2 * along_ + 1, 0);
        stiffness_.resize(size, size);
        mass_.resize(size, size);
        stiffness_.setFromTriplets(stiff.begin(), stiff.end());
        mass_.setFromTriplets(mass.begin(), mass.end());
    }
    int global(int element, int local) const {
        const int node = local / 2, i = 2 * (element / up_) + node / 3, k = 2 * (element % up_) + node % 3;
        return i == 0 ? -1 : unknown(i, k) + local % 2;
    }

    // Values of the nine shapes at (x, z) in [−1, 1]², their derivatives by the real x and z.
    void shapes(double x, double z, Shapes& value, Shapes& by_x, Shapes& by_z) const {
        const auto line = [](double r, double* f, double* df) {
            f[0] = r * (r - 1) / 2, f[1] = 1 - r * r, f[2] = r * (r + 1) / 2;
            df[0] = r - 0.5, df[1] = -2 * r, df[2] = r + 0.5;
        };
        double fx[3], dx[3], fz[3], dz[3];
        line(x, fx, dx), line(z, fz, dz);
        for (int n = 0; n < 9; ++n) {
            value[n] = fx[n / 3] * fz[n % 3];
            by_x[n] = dx[n / 3] * fz[n % 3] * 2 / width_;
            by_z[n] = fx[n / 3] * dz[n % 3] * 2 / tall_;
        }
    }

    Eigen::Matrix<double, 18, 18> element(bool stiffness) const {
        const double mu = beam_.ice.shear_modulus(), kappa = beam_.ice.bulk_modulus(2);
        Eigen::Matrix3d law;
        law << kappa + mu, kappa - mu, 0, kappa - mu, kappa + mu, 0, 0, 0, mu;
        const double at[] = {-std::sqrt(0.6), 0, std::sqrt(0.6)}, weight[] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
        Eigen::Matrix<double, 18, 18> sum = Eigen::Matrix<double, 18, 18>::Zero();
        for (int g = 0; g < 9; ++g) {
            Shapes n, x, z;
            shapes(at[g / 3], at[g % 3], n, x, z);
            Eigen::Matrix<double, 3, 18> strain = Eigen::Matrix<double, 3, 18>::Zero();
            Eigen::Matrix<double, 2, 18> value = Eigen::Matrix<double, 2, 18>::Zero();
            for (int a = 0; a < 9; ++a) {
                strain(0, 2 * a) = strain(2, 2 * a + 1) = x[a];
                strain(1, 2 * a + 1) = strain(2, 2 * a) = z[a];
                value(0, 2 * a) = value(1, 2 * a + 1) = n[a];
            }
            const double share = weight[g / 3] * weight[g % 3] * width_ * tall_ / 4;
            if (stiffness)
                sum += share * strain.transpose() * law * strain;
            else
                sum += share * beam_.ice.density * value.transpose() * value;
        }
        return sum;
    }

    // Of the vertical component, by Simpson's rule.
    double mean_of_tip(const Eigen::VectorXd& field) const {
        double sum = 0;
        for (int k = 0; k <= 2 * up_; ++k) {
            const double weight = k % 2 == 1 ? 4 : (k == 0 || k == 2 * up_ ? 1 : 2);
            sum += weight * field[unknown(2 * along_, k) + 1] / (6 * up_);
        }
        return sum;
    }

    Cantilever beam_;
    int along_, up_;
    double width_, tall_;
    Sparse stiffness_, mass_;
};

}  // namespace tidewater::test
