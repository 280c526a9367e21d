// Formulas and symbols: wave_theory.h.
#include "analysis/wave_theory.h"

#include <cassert>
#include <cmath>
#include <complex>
#include <numbers>

namespace tidewater::analysis {
namespace {

using Complex = std::complex<double>;

double wavenumber(const InitialWave& wave) { return 2.0 * std::numbers::pi / wave.length; }

struct Solitary {
    double relative, decay, speed;  // ε, α/D in 1/m, √(gD)

    explicit Solitary(const InitialWave& wave)
        : relative(wave.height / wave.depth), speed(std::sqrt(wave.gravity * wave.depth)) {
        assert(wave.height > 0.0 && wave.height < wave.depth);
        const double e = relative;
        decay = std::sqrt(0.75 * e) * (1.0 - 5.0 / 8.0 * e + 71.0 / 128.0 * e * e) / wave.depth;
    }
};

// q and what its derivatives need, of a real or complex place.
template <class Number>
struct Sech2 {
    Number t, q, q_x;

    Sech2(const Solitary& solitary, Number from_center)
        : t(std::tanh(solitary.decay * from_center)), q(1.0 - t * t), q_x(-2.0 * solitary.decay * q * t) {}
};

Complex bed_velocity(const Solitary& solitary, const Complex& q) {
    const double e = solitary.relative;
    return solitary.speed * e * (q + e * (0.25 - q) * q - e * e * (19.0 / 40.0 + (0.2 - 1.2 * q) * q) * q);
}

// ∂u_b/∂q
Complex bed_velocity_slope(const Solitary& solitary, const Complex& q) {
    const double e = solitary.relative;
    return solitary.speed * e * (1.0 + e * (0.25 - 2.0 * q) - e * e * (19.0 / 40.0 + (0.4 - 3.6 * q) * q));
}

WaveFlow solitary_flow(const InitialWave& wave, double x, double z) {
    const Solitary solitary(wave);
    const Sech2<Complex> sech(solitary, Complex(x - wave.center, z));
    const Complex velocity = bed_velocity(solitary, sech.q);
    const Complex slope = bed_velocity_slope(solitary, sech.q) * sech.q_x;
    WaveFlow flow{.u = velocity.real(), .w = -velocity.imag(), .u_x = slope.real(), .u_z = -slope.imag()};
    flow.head =
        wave.depth - z + (solitary_celerity(wave) * flow.u - 0.5 * std::norm(velocity)) / wave.gravity;
    return flow;
}

}  // namespace

double angular_frequency(double wavenumber, double depth, double gravity) {
    return std::sqrt(gravity * wavenumber * std::tanh(wavenumber * depth));
}

double solitary_celerity(const InitialWave& wave) {
    const double e = wave.height / wave.depth;
    return std::sqrt(wave.gravity * wave.depth * (1.0 + e - e * e / 20.0 - 3.0 / 70.0 * e * e * e));
}

double elevation(const InitialWave& wave, double x) {
    if (wave.kind == WaveKind::standing) return wave.height * std::cos(wavenumber(wave) * x);
    const Solitary solitary(wave);
    const double e = solitary.relative, q = Sech2<double>(solitary, x - wave.center).q;
    return wave.height * q * (1.0 + e * (1.0 - q) * (-0.75 + e * (5.0 / 8.0 - 101.0 / 80.0 * q)));
}

double elevation_slope(const InitialWave& wave, double x) {
    const double k = wave.kind == WaveKind::standing ? wavenumber(wave) : 0.0;
    if (wave.kind == WaveKind::standing) return -wave.height * k * std::sin(k * x);
    const Solitary solitary(wave);
    const Sech2<double> sech(solitary, x - wave.center);
    const double e = solitary.relative, q = sech.q;
    const double second = -0.75 * (1.0 - 2.0 * q);
    const double third = 5.0 / 8.0 * (1.0 - 2.0 * q) - 101.0 / 80.0 * q * (2.0 - 3.0 * q);
    return wave.height * (1.0 + e * (second + e * third)) * sech.q_x;
}

double elevated_area(const InitialWave& wave, double x) {
    if (wave.kind == WaveKind::standing) {
        const double k = wavenumber(wave);
        return wave.height / k * std::sin(k * x);
    }
    // With t = tanh(α (x − center)/D): ∫ q = t, ∫ q (1 − q) = t³/3 and ∫ q² (1 − q) = t³/3 − t⁵/5, over α/D.
    const Solitary solitary(wave);
    const double e = solitary.relative;
    const auto up_to = [&](double from_center) {
        const double t = std::tanh(solitary.decay * from_center), cube = t * t * t / 3.0;
        return t - 0.75 * e * cube + e * e * (5.0 / 8.0 * cube - 101.0 / 80.0 * (cube - cube * t * t * 0.6));
    };
    return wave.height / solitary.decay * (up_to(x - wave.center) - up_to(-wave.center));
}

WaveFlow wave_flow(const InitialWave& wave, double x, double z) {
    if (wave.kind == WaveKind::solitary) return solitary_flow(wave, x, z);
    const double k = wavenumber(wave), eta = elevation(wave, x);
    const double still = z * wave.depth / (wave.depth + eta);
    return {.head = wave.depth - z + eta * std::cosh(k * still) / std::cosh(k * wave.depth)};
}

Displaced displace(const InitialWave& wave, double x, double z) {
    double to = x;
    for (int iteration = 0; iteration < 100; ++iteration) {  // Newton on a rising function
        const double change =
            (x - to - elevated_area(wave, to) / wave.depth) / (1.0 + elevation(wave, to) / wave.depth);
        to += change;
        if (std::abs(change) < 1e-14 * wave.depth) break;
    }
    return {to, z * (1.0 + elevation(wave, to) / wave.depth)};
}

}  // namespace tidewater::analysis
