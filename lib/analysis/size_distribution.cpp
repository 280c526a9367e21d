// Clauset, Shalizi & Newman (2009), SIAM Review 51, 661-703; Vuong (1989), Econometrica 57, 307-333.
#include "analysis/size_distribution.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.h"
#include "core/random.h"

namespace tidewater::analysis {
namespace {

constexpr double z95 = 1.959964;
constexpr std::size_t fewest = 50, fewest_in_tail = 10, most_candidates = 100;
constexpr double farthest_cutoff = 1000.0;  // in the largest size
constexpr int intervals = 512;              // of Simpson's rule, even

std::vector<double> sorted_sizes(std::span<const double> sizes) {
    std::vector<double> sorted;
    for (const double s : sizes) {
        if (std::isfinite(s) && s > 0.0) sorted.push_back(s);
    }
    std::ranges::sort(sorted);
    return sorted;
}

// What the likelihood needs of t = s/s_min.
struct Sums {
    double count = 0.0, log = 0.0, t = 0.0, largest = 1.0;
};

Sums sum_tail(std::span<const double> tail, double smallest) {
    Sums sums;
    sums.count = static_cast<double>(tail.size());
    for (const double s : tail) {
        sums.log += std::log(s / smallest);
        sums.t += s / smallest;
    }
    sums.largest = tail.back() / smallest;
    return sums;
}

// Where t^−a exp(−x t), as a density in u = ln t, has become negligible (e^−40).
double end_of_integral(double a, double x) {
    const double by_cutoff = std::log((x + 40.0 + 4.0 * std::abs(a)) / x);
    return a > 1.0 ? std::min(by_cutoff, 40.0 / (a - 1.0)) : by_cutoff;
}

// ∫ t^−a e^−xt dt from 1 on, without the factor e^−x, and the means of u = ln t and t, with their
// covariances.
struct Moments {
    double integral = 0.0;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

Moments moments(double a, double x) {
    const double step = end_of_integral(a, x) / intervals;
    Moments m;
    for (int i = 0; i <= intervals; ++i) {
        const double u = i * step, t = std::exp(u);
        const double simpson = i == 0 || i == intervals ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
        const double w = simpson * step / 3.0 * std::exp((1.0 - a) * u - x * (t - 1.0));
        const Eigen::Vector2d v(u, t - 1.0);
        m.integral += w;
        m.mean += w * v;
        m.covariance += w * v * v.transpose();
    }
    m.mean /= m.integral;
    m.covariance = m.covariance / m.integral - m.mean * m.mean.transpose();
    m.mean[1] += 1.0;
    return m;
}

double truncated_likelihood(const Sums& sums, double a, double x, const Moments& m) {
    return -a * sums.log - x * (sums.t - sums.count) - sums.count * std::log(m.integral);
}

// ln L per t; that per s is less by n ln s_min.
SizeFit fit_power_law(const Sums& sums, double smallest) {
    SizeFit fit{.model = SizeModel::power_law};
    const double rate = sums.count / sums.log;
    fit.exponent = 1.0 + rate;
    const double half = z95 * rate / std::sqrt(sums.count);
    fit.exponent_interval = {fit.exponent - half, fit.exponent + half};
    fit.log_likelihood =
        sums.count * std::log(rate) - fit.exponent * sums.log - sums.count * std::log(smallest);
    return fit;
}

SizeFit fit_exponential(const Sums& sums, double smallest) {
    SizeFit fit{.model = SizeModel::exponential};
    const double mean = sums.t / sums.count - 1.0;
    fit.cutoff = smallest * mean;
    const double factor = std::exp(z95 / std::sqrt(sums.count));
    fit.cutoff_interval = {fit.cutoff / factor, fit.cutoff * factor};
    fit.log_likelihood = -sums.count * (std::log(mean) + 1.0 + std::log(smallest));
    return fit;
}

// Newton's method for a and x on the concave ln L, with steps halved until ln L rises.
SizeFit fit_truncated(const Sums& sums, double smallest) {
    const double least_x = 1.0 / (farthest_cutoff * sums.largest);
    double a = 1.0, x = 1.0 / (sums.t / sums.count);
    Moments m = moments(a, x);
    double likelihood = truncated_likelihood(sums, a, x, m);
    for (int iteration = 0; iteration < 100; ++iteration) {
        const Eigen::Vector2d slope = sums.count * m.mean - Eigen::Vector2d(sums.log, sums.t);
        Eigen::Vector2d step = (sums.count * m.covariance).ldlt().solve(slope);
        if (x <= least_x && step[1] < 0.0) step = {slope[0] / (sums.count * m.covariance(0, 0)), 0.0};
        bool rises = false;
        for (int halving = 0; halving < 40 && !rises; ++halving, step *= 0.5) {
            const double next_a = a + step[0], next_x = std::max({x + step[1], 0.1 * x, least_x});
            const Moments next = moments(next_a, next_x);
            const double next_likelihood = truncated_likelihood(sums, next_a, next_x, next);
            if (!(next_likelihood > likelihood)) continue;
            rises = next_likelihood - likelihood > 1e-10 * sums.count;
            a = next_a, x = next_x, m = next, likelihood = next_likelihood;
            if (!rises) break;
        }
        if (!rises) break;
    }
    SizeFit fit{.model = SizeModel::truncated_power_law, .exponent = a, .cutoff = smallest / x};
    fit.log_likelihood = likelihood - sums.count * std::log(smallest);
    const Eigen::Matrix2d errors = (sums.count * m.covariance).inverse();
    const double half = z95 * std::sqrt(errors(0, 0));
    const double factor = std::exp(z95 * std::sqrt(errors(1, 1)) / x);
    fit.exponent_interval = {a - half, a + half};
    fit.cutoff_interval = {fit.cutoff / factor, fit.cutoff * factor};
    return fit;
}

// F(u) of ln t at even steps, of the truncated law.
struct Cumulative {
    explicit Cumulative(const SizeFit& fit, double smallest)
        : step(end_of_integral(fit.exponent, smallest / fit.cutoff) / (steps - 1)), share(steps, 0.0) {
        const double x = smallest / fit.cutoff;
        const auto density = [&](double u) {
            return std::exp((1.0 - fit.exponent) * u - x * (std::exp(u) - 1.0));
        };
        for (std::size_t i = 1; i < steps; ++i) {
            const double u = static_cast<double>(i) * step;
            share[i] = share[i - 1] + density(u - step) + 4.0 * density(u - 0.5 * step) + density(u);
        }
        for (double& f : share) f /= share.back();
    }

    double at(double u) const {
        const double place = u / step;
        const auto i = static_cast<std::size_t>(place);
        if (i + 1 >= steps) return 1.0;
        return share[i] + (place - static_cast<double>(i)) * (share[i + 1] - share[i]);
    }

    double inverse(double f) const {
        const auto above = std::min(std::ranges::upper_bound(share, f), share.end() - 1);
        const auto i = static_cast<std::size_t>(above - share.begin());
        const double part = (f - share[i - 1]) / (share[i] - share[i - 1]);
        return (static_cast<double>(i - 1) + std::min(part, 1.0)) * step;
    }

    static constexpr std::size_t steps = 2049;
    double step;
    std::vector<double> share;
};

template <class Model>
double greatest_distance(std::span<const double> tail, const Model& cumulative) {
    const double count = static_cast<double>(tail.size());
    double greatest = 0.0;
    for (std::size_t i = 0; i < tail.size(); ++i) {
        const double f = cumulative(tail[i]), below = static_cast<double>(i) / count;
        greatest = std::max({greatest, f - below, below + 1.0 / count - f});
    }
    return greatest;
}

double ks_distance(std::span<const double> tail, double smallest, const SizeFit& fit) {
    if (fit.model == SizeModel::power_law) {
        return greatest_distance(tail,
                                 [&](double s) { return 1.0 - std::pow(s / smallest, 1.0 - fit.exponent); });
    }
    if (fit.model == SizeModel::exponential) {
        return greatest_distance(tail, [&](double s) { return -std::expm1(-(s - smallest) / fit.cutoff); });
    }
    const Cumulative cumulative(fit, smallest);
    return greatest_distance(tail, [&](double s) { return cumulative.at(std::log(s / smallest)); });
}

SizeFit fit_model(SizeModel model, std::span<const double> tail, double smallest) {
    const Sums sums = sum_tail(tail, smallest);
    SizeFit fit = model == SizeModel::power_law     ? fit_power_law(sums, smallest)
                  : model == SizeModel::exponential ? fit_exponential(sums, smallest)
                                                    : fit_truncated(sums, smallest);
    fit.distance = ks_distance(tail, smallest, fit);
    return fit;
}

std::span<const double> tail_of(std::span<const double> sorted, double smallest) {
    return {std::ranges::lower_bound(sorted, smallest), sorted.end()};
}

double choose_smallest(std::span<const double> sorted) {
    double best = sorted.front(), least = 2.0, last = 0.0;
    if (sorted.size() <= fewest_in_tail) return best;
    const std::size_t end = sorted.size() - fewest_in_tail,
                      stride = (end + most_candidates - 1) / most_candidates;
    for (std::size_t i = 0; i < end; i += stride) {
        if (sorted[i] == last || sorted[i] == sorted.back()) continue;
        last = sorted[i];
        const double distance = fit_model(SizeModel::power_law, tail_of(sorted, last), last).distance;
        if (distance < least) least = distance, best = last;
    }
    return best;
}

// p of a fit to sizes ≥ smallest, of which `body` are the smaller ones where s_min was chosen.
double bootstrap(const SizeFit& fit, std::size_t count, double smallest, std::span<const double> body,
                 const SizeSettings& settings) {
    const bool choose = std::isnan(settings.smallest) && fit.model == SizeModel::power_law;
    const std::size_t total = count + (choose ? body.size() : 0);
    std::vector<std::uint8_t> farther(static_cast<std::size_t>(settings.replicates), 0);
    parallel_for(farther.size(), [&](std::size_t r) {
        const auto stream = 4 * r + 8 * farther.size() * static_cast<std::size_t>(fit.model);
        std::vector<double> drawn = draw_sizes(fit, smallest, total, settings.seed, stream);
        for (std::size_t i = 0; choose && i < total; ++i) {
            const double pick = random_uniform(settings.seed, stream + 1, i) * static_cast<double>(total);
            if (pick < static_cast<double>(body.size())) drawn[i] = body[static_cast<std::size_t>(pick)];
        }
        std::ranges::sort(drawn);
        const double from = choose ? choose_smallest(drawn) : smallest;
        const auto tail = tail_of(drawn, from);
        farther[r] = tail.front() < tail.back() && fit_model(fit.model, tail, from).distance >= fit.distance;
    });
    return static_cast<double>(std::ranges::count(farther, 1)) / static_cast<double>(farther.size());
}

LikelihoodRatio compare_nested(const SizeFit& general, const SizeFit& special) {
    const double ratio = general.log_likelihood - special.log_likelihood;
    return {ratio, std::erfc(std::sqrt(std::max(ratio, 0.0)))};
}

LikelihoodRatio compare_by_vuong(std::span<const double> tail, double smallest, const SizeFit& power,
                                 const SizeFit& exponential) {
    const double count = static_cast<double>(tail.size());
    const double ratio = power.log_likelihood - exponential.log_likelihood;
    double squares = 0.0;
    for (const double s : tail) {
        const double l1 =
            std::log((power.exponent - 1.0) / smallest) - power.exponent * std::log(s / smallest);
        const double l2 = -std::log(exponential.cutoff) - (s - smallest) / exponential.cutoff;
        squares += (l1 - l2 - ratio / count) * (l1 - l2 - ratio / count);
    }
    return {ratio, std::erfc(std::abs(ratio) / std::sqrt(2.0 * squares))};
}

}  // namespace

std::vector<Exceedance> exceedance(std::span<const double> sizes) {
    const std::vector<double> sorted = sorted_sizes(sizes);
    std::vector<Exceedance> all;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        if (i == 0 || sorted[i] != sorted[i - 1]) all.push_back({sorted[i], sorted.size() - i});
    }
    return all;
}

std::vector<SizeBin> logarithmic_histogram(std::span<const double> sizes, int per_decade) {
    assert(per_decade >= 1);
    const std::vector<double> sorted = sorted_sizes(sizes);
    std::vector<SizeBin> bins;
    if (sorted.empty()) return bins;
    std::size_t next = 0;
    while (next < sorted.size()) {
        const double place = static_cast<double>(bins.size());
        SizeBin bin{sorted.front() * std::pow(10.0, place / per_decade),
                    sorted.front() * std::pow(10.0, (place + 1.0) / per_decade)};
        const bool last = sorted.back() <= bin.high * (1.0 + 1e-12);
        for (; next < sorted.size() && (last || sorted[next] < bin.high); ++next) ++bin.count;
        bin.density = static_cast<double>(bin.count) / (bin.high - bin.low);
        bins.push_back(bin);
    }
    return bins;
}

std::vector<double> draw_sizes(const SizeFit& fit, double smallest, std::size_t count, std::uint64_t seed,
                               std::uint64_t stream) {
    std::vector<double> drawn(count);
    const bool tabulated = fit.model == SizeModel::truncated_power_law;
    const Cumulative cumulative(tabulated ? fit : SizeFit{.exponent = 2.0, .cutoff = smallest}, smallest);
    for (std::size_t i = 0; i < count; ++i) {
        const double f = random_uniform(seed, stream, i);
        if (fit.model == SizeModel::power_law) {
            drawn[i] = smallest * std::pow(1.0 - f, -1.0 / (fit.exponent - 1.0));
        } else if (tabulated) {
            drawn[i] = smallest * std::exp(cumulative.inverse(f));
        } else {
            drawn[i] = smallest - fit.cutoff * std::log1p(-f);
        }
    }
    return drawn;
}

double modelled_exceedance(const SizeFit& fit, double smallest, double size) {
    const double decay = std::exp((smallest - size) / fit.cutoff);
    if (fit.model == SizeModel::exponential) return decay;
    const double power = std::pow(size / smallest, 1.0 - fit.exponent);
    if (fit.model == SizeModel::power_law) return power;
    if (std::isnan(fit.exponent) || std::isnan(fit.cutoff)) return none;
    return power * decay * moments(fit.exponent, size / fit.cutoff).integral /
           moments(fit.exponent, smallest / fit.cutoff).integral;
}

SizeDistribution fit_sizes(std::span<const double> sizes, const SizeSettings& settings) {
    SizeDistribution all;
    const std::vector<double> sorted = sorted_sizes(sizes);
    all.smallest = settings.smallest;
    if (std::isnan(all.smallest) && !sorted.empty()) all.smallest = choose_smallest(sorted);
    const auto tail = tail_of(sorted, std::isnan(all.smallest) ? 0.0 : all.smallest);
    all.count = tail.size();
    if (tail.empty() || tail.front() == tail.back()) {
        all.doubt = "fewer than two different sizes";
        return all;
    }
    all.decades = std::log10(tail.back() / all.smallest);
    if (all.count < fewest) {
        all.doubt = "only " + std::to_string(all.count) + " fragments, fewer than 50";
    } else if (all.decades < 1.0) {
        all.doubt = "sizes span less than one decade";
    }
    const auto body = std::span(sorted).first(sorted.size() - tail.size());
    all.power_law = fit_model(SizeModel::power_law, tail, all.smallest);
    all.truncated = fit_model(SizeModel::truncated_power_law, tail, all.smallest);
    all.exponential = fit_model(SizeModel::exponential, tail, all.smallest);
    if (settings.replicates > 0) {
        for (SizeFit* fit : {&all.power_law, &all.truncated, &all.exponential}) {
            fit->p = bootstrap(*fit, tail.size(), all.smallest, body, settings);
        }
    }
    all.power_over_exponential = compare_by_vuong(tail, all.smallest, all.power_law, all.exponential);
    all.truncated_over_power = compare_nested(all.truncated, all.power_law);
    all.truncated_over_exponential = compare_nested(all.truncated, all.exponential);
    return all;
}

}  // namespace tidewater::analysis
