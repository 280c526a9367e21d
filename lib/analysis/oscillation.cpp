#include "analysis/oscillation.h"

#include <Eigen/Cholesky>
#include <cassert>
#include <cmath>

#include "core/types.h"

namespace tidewater::analysis {
namespace {

constexpr double raster_width = 0.2;  // of the guess, to each side
constexpr int raster = 80;            // steps of ω to each side

struct Record {
    std::vector<double> time, value;

    double length() const { return time.back() - time.front(); }
};

Record finite(std::span<const double> time, std::span<const double> value) {
    Record record;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (!std::isfinite(value[i])) continue;
        record.time.push_back(time[i]);
        record.value.push_back(value[i]);
    }
    return record;
}

double misfit(const Record& record, const Oscillation& fit) {
    double squares = 0.0;
    for (std::size_t i = 0; i < record.time.size(); ++i) {
        const double left = record.value[i] - fit.at(record.time[i]);
        squares += left * left;
    }
    return std::sqrt(squares / static_cast<double>(record.time.size()));
}

// The least squares' A, B, C of this ω and γ.
Oscillation best_amplitudes(const Record& record, double frequency, double decay) {
    Matrix<3, double> normal = Matrix<3, double>::Zero();
    Vector<3, double> right = Vector<3, double>::Zero();
    for (std::size_t i = 0; i < record.time.size(); ++i) {
        const double t = record.time[i], fade = std::exp(-decay * t);
        const Vector<3, double> row(fade * std::cos(frequency * t), fade * std::sin(frequency * t), 1.0);
        normal += row * row.transpose();
        right += row * record.value[i];
    }
    const Vector<3, double> best = normal.ldlt().solve(right);
    Oscillation fit{
        .frequency = frequency, .decay = decay, .cosine = best[0], .sine = best[1], .offset = best[2]};
    fit.misfit = misfit(record, fit);
    return fit;
}

Oscillation best_of_raster(const Record& record, double guess) {
    Oscillation best;
    for (int n = -raster; n <= raster; ++n) {
        for (const double losses : {0.0, 0.5, 2.0}) {
            const double frequency = guess * (1.0 + raster_width * n / raster);
            const Oscillation fit = best_amplitudes(record, frequency, losses / record.length());
            if (!(fit.misfit >= best.misfit)) best = fit;
        }
    }
    return best;
}

// One step in ω, γ, A, B, C.
Oscillation newton_step(const Record& record, const Oscillation& fit) {
    using Five = Eigen::Matrix<double, 5, 1>;
    Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
    Five right = Five::Zero();
    for (std::size_t i = 0; i < record.time.size(); ++i) {
        const double t = record.time[i], fade = std::exp(-fit.decay * t);
        const double c = fade * std::cos(fit.frequency * t), s = fade * std::sin(fit.frequency * t);
        Five row;
        row << t * (fit.sine * c - fit.cosine * s), -t * (fit.cosine * c + fit.sine * s), c, s, 1.0;
        normal += row * row.transpose();
        right += row * (record.value[i] - fit.at(t));
    }
    const Five change = normal.ldlt().solve(right);
    Oscillation next = fit;
    next.frequency += change[0];
    next.decay += change[1];
    next.cosine += change[2];
    next.sine += change[3];
    next.offset += change[4];
    next.misfit = misfit(record, next);
    return next;
}

}  // namespace

double Oscillation::at(double time) const {
    return std::exp(-decay * time) *
               (cosine * std::cos(frequency * time) + sine * std::sin(frequency * time)) +
           offset;
}

double Oscillation::envelope(double time) const { return std::hypot(cosine, sine) * std::exp(-decay * time); }

Oscillation fit_oscillation(std::span<const double> time, std::span<const double> value, double guess) {
    assert(time.size() == value.size() && guess > 0.0);
    const Record record = finite(time, value);
    if (record.time.size() < 8 || record.length() * guess < 3.14) return {};
    Oscillation fit = best_of_raster(record, guess);
    for (int iteration = 0; iteration < 50; ++iteration) {
        const Oscillation next = newton_step(record, fit);
        if (!(next.misfit < fit.misfit)) break;
        fit = next;
    }
    return fit;
}

}  // namespace tidewater::analysis
