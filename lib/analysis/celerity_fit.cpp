#include "analysis/celerity_fit.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <unsupported/Eigen/FFT>

#include "analysis/dispersion.h"

namespace tidewater::analysis {
namespace {

constexpr double smoothing = 0.1;                 // deviation in √(D/g)
constexpr double highest_frequency = 8.0;         // in √(g/D)
constexpr double slowest = 0.6, step = 0.01;      // of √(gD)
constexpr std::size_t trials = 101, padding = 4;  // speeds; lengths of the record
constexpr double least_explained = 0.5;

using Complex = std::complex<double>;

bool known(const std::vector<double>& record) {
    return std::ranges::none_of(record, [](double v) { return std::isnan(v); });
}

std::vector<double> prepare(std::span<const double> time, const std::vector<double>& record,
                            double deviation) {
    std::vector<double> smoothed = smooth(time, record, deviation);
    const double first = smoothed.front();
    for (double& v : smoothed) v -= first;
    return smoothed;
}

double squares(std::span<const double> values) {
    return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

// A record that is transformed once and then sent on over distances at trial speeds.
class Upstream {
public:
    Upstream(std::span<const double> record, double interval) {
        std::vector<double> padded(record.begin(), record.end());
        padded.resize(std::bit_ceil(padding * record.size()), 0.0);
        unit_ = 2.0 * std::numbers::pi / (interval * static_cast<double>(padded.size()));
        fft_.fwd(spectrum_, padded);
    }

    // At a place `distance` further, with waves whose gravity is given.
    std::vector<double> send(double distance, double depth, double gravity) {
        const double most = highest_frequency * std::sqrt(gravity / depth);
        std::vector<Complex> sent(spectrum_.size());
        sent[0] = spectrum_[0];
        for (std::size_t n = 1; n < sent.size() / 2 && static_cast<double>(n) * unit_ < most; ++n) {
            const double k = dispersion_wavenumber(static_cast<double>(n) * unit_, depth, gravity);
            sent[n] = spectrum_[n] * std::polar(1.0, -k * distance);
            sent[sent.size() - n] = std::conj(sent[n]);
        }
        std::vector<double> record;
        fft_.inv(record, sent);
        return record;
    }

private:
    Eigen::FFT<double> fft_;
    std::vector<Complex> spectrum_;
    double unit_ = 0.0;  // rad/s
};

// Of one pair: the misfit at each trial speed, m² summed over times, and what there is to explain.
struct Pair {
    std::vector<double> misfit;
    double squares = 0.0;
};

double trial(double n, double usual) { return usual * (slowest + step * n); }

Pair compare(std::span<const double> from, std::span<const double> to, double interval, double distance,
             double depth, double usual) {
    Upstream upstream(from, interval);
    Pair pair{{}, squares(to)};
    for (std::size_t n = 0; n < trials; ++n) {
        const double c = trial(static_cast<double>(n), usual);
        const std::vector<double> sent = upstream.send(distance, depth, c * c / depth);
        double sum = 0.0;
        for (std::size_t i = 0; i < to.size(); ++i) sum += (to[i] - sent[i]) * (to[i] - sent[i]);
        pair.misfit.push_back(sum);
    }
    return pair;
}

// Where the misfit of all pairs but one is least, in trials, and how much it is; NaN at the range's ends.
struct Least {
    double place = none, misfit = none;
};

Least find_least(std::span<const Pair> pairs, std::size_t without) {
    std::vector<double> sum(trials, 0.0);
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        for (std::size_t n = 0; n < trials && p != without; ++n) sum[n] += pairs[p].misfit[n];
    }
    const auto n = static_cast<std::size_t>(std::ranges::min_element(sum) - sum.begin());
    if (n == 0 || n + 1 == trials) return {};
    const double bend = sum[n - 1] - 2.0 * sum[n] + sum[n + 1], slope = 0.5 * (sum[n + 1] - sum[n - 1]);
    if (!(bend > 0.0)) return {};
    return {static_cast<double>(n) - slope / bend, sum[n] - 0.5 * slope * slope / bend};
}

double jackknife(std::span<const Pair> pairs, double usual) {
    std::vector<double> speeds;
    for (std::size_t p = 0; p < pairs.size(); ++p) speeds.push_back(trial(find_least(pairs, p).place, usual));
    const auto count = static_cast<double>(speeds.size());
    const double mean = std::accumulate(speeds.begin(), speeds.end(), 0.0) / count;
    for (double& v : speeds) v -= mean;
    return std::sqrt((count - 1.0) / count * squares(speeds));
}

}  // namespace

CelerityFit fit_celerity(std::span<const double> distance, std::span<const double> time,
                         std::span<const std::vector<double>> records, double depth, double gravity) {
    assert(distance.size() == records.size() && time.size() >= 4 && depth > 0.0 && gravity > 0.0);
    const double usual = std::sqrt(gravity * depth), deviation = smoothing * std::sqrt(depth / gravity);
    const double interval = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    std::vector<Pair> pairs;
    for (std::size_t g = 1; g < records.size(); ++g) {
        if (!known(records[g - 1]) || !known(records[g])) continue;
        pairs.push_back(compare(prepare(time, records[g - 1], deviation),
                                prepare(time, records[g], deviation), interval, distance[g] - distance[g - 1],
                                depth, usual));
    }
    CelerityFit fit;
    fit.pairs = static_cast<int>(pairs.size());
    if (pairs.size() < 2) return fit;
    const Least least = find_least(pairs, pairs.size());
    double all = 0.0;
    for (const Pair& pair : pairs) all += pair.squares;
    fit.explained = 1.0 - least.misfit / all;
    if (!(fit.explained >= least_explained)) return fit;
    fit.celerity = trial(least.place, usual);
    fit.error = jackknife(pairs, usual);
    return fit;
}

}  // namespace tidewater::analysis
