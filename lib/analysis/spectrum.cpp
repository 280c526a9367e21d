#include "analysis/spectrum.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace tidewater::analysis {
namespace {

constexpr double most_missing = 0.1;  // share of a record

struct Stretch {
    std::size_t first = 0, count = 0;
};

Stretch longest_without_gap(std::span<const double> value) {
    Stretch longest;
    for (std::size_t first = 0, end = 0; first < value.size(); first = end + 1) {
        for (end = first; end < value.size() && !std::isnan(value[end]);) ++end;
        if (end - first > longest.count) longest = {first, end - first};
    }
    return longest;
}

// At as many even times, from the first to the last.
std::vector<double> at_even_times(std::span<const double> time, std::span<const double> value) {
    std::vector<double> even;
    const double step = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    std::size_t after = 1;
    for (std::size_t i = 0; i < time.size(); ++i) {
        const double at = time.front() + static_cast<double>(i) * step;
        while (after + 1 < time.size() && time[after] < at) ++after;
        const double share = (at - time[after - 1]) / (time[after] - time[after - 1]);
        even.push_back(std::lerp(value[after - 1], value[after], std::clamp(share, 0.0, 1.0)));
    }
    return even;
}

void take_off_line(std::span<double> value) {
    const double count = static_cast<double>(value.size()), middle = 0.5 * (count - 1.0);
    double mean = 0.0, slope = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const double u = static_cast<double>(i) - middle;
        mean += value[i] / count;
        slope += u * value[i];
        squares += u * u;
    }
    for (std::size_t i = 0; i < value.size(); ++i)
        value[i] -= mean + slope / squares * (static_cast<double>(i) - middle);
}

double mean_square(std::span<const double> value) {
    double sum = 0.0;
    for (const double v : value) sum += v * v;
    return sum / static_cast<double>(value.size());
}

// Tukey's; share: of the place in the segment, in (0, 1).
double window(double share, double taper) {
    const double from_end = std::min(share, 1.0 - share);
    return from_end < 0.5 * taper ? 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * from_end / taper) : 1.0;
}

// Sum over segments of the squared amplitudes at 0 … padded/2.
std::vector<double> squared_amplitudes(std::span<const double> value, std::size_t length, std::size_t padded,
                                       const SpectrumSettings& settings) {
    Eigen::FFT<double> transform;
    std::vector<double> squares(padded / 2 + 1, 0.0), segment;
    std::vector<std::complex<double>> amplitude;
    const auto last = static_cast<std::size_t>(settings.segments - 1);
    for (std::size_t s = 0; s <= last; ++s) {
        const std::size_t first = last == 0 ? 0 : s * (value.size() - length) / last;
        segment.assign(padded, 0.0);
        for (std::size_t i = 0; i < length; ++i) {
            const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(length);
            segment[i] = value[first + i] * window(share, settings.taper);
        }
        transform.fwd(amplitude, segment);
        for (std::size_t k = 0; k < squares.size(); ++k) squares[k] += std::norm(amplitude[k]);
    }
    return squares;
}

std::size_t greatest_density(const Spectrum& spectrum) {
    return static_cast<std::size_t>(std::ranges::max_element(spectrum.density) - spectrum.density.begin());
}

}  // namespace

double Spectrum::width(std::size_t k) const {
    return (k == 0 || k + 1 == frequency.size() ? 0.5 : 1.0) * (frequency[1] - frequency[0]);
}

double Spectrum::moment(int order) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < frequency.size(); ++k)
        sum += std::pow(frequency[k], order) * density[k] * width(k);
    return sum;
}

bool Spectrum::peak_is_resolved() const {
    if (frequency.empty()) return false;
    const std::size_t peak = greatest_density(*this);
    return density[peak] > 0.0 && frequency[peak] >= 2.0 * resolution;
}

double Spectrum::significant_height() const { return peak_is_resolved() ? 4.0 * std::sqrt(moment(0)) : none; }
double Spectrum::mean_period() const { return peak_is_resolved() ? moment(0) / moment(1) : none; }
double Spectrum::zero_crossing_period() const {
    return peak_is_resolved() ? std::sqrt(moment(0) / moment(2)) : none;
}

double Spectrum::peak_period() const {
    if (!peak_is_resolved()) return none;
    const std::size_t peak = greatest_density(*this);
    double shift = 0.0;
    if (peak + 1 < density.size() && density[peak - 1] > 0.0 && density[peak + 1] > 0.0) {
        const double before = std::log(density[peak - 1] / density[peak]);
        const double after = std::log(density[peak + 1] / density[peak]);
        if (before + after < 0.0) shift = 0.5 * (before - after) / (before + after);
    }
    return 1.0 / (frequency[peak] + shift * (frequency[1] - frequency[0]));
}

Spectrum wave_spectrum(std::span<const double> time, std::span<const double> elevation,
                       const SpectrumSettings& settings) {
    assert(time.size() == elevation.size() && settings.segments >= 1);
    assert(settings.taper >= 0.0 && settings.taper <= 1.0);
    Spectrum spectrum;
    const Stretch stretch = longest_without_gap(elevation);
    // Segments that overlap by half: (segments + 1)/2 lengths make the record.
    const std::size_t length = 2 * stretch.count / static_cast<std::size_t>(settings.segments + 1);
    if (length < fewest_samples) {
        spectrum.doubt = "fewer than " + std::to_string(fewest_samples) + " samples without a gap";
        return spectrum;
    }
    const auto t = time.subspan(stretch.first, stretch.count);
    std::vector<double> value = at_even_times(t, elevation.subspan(stretch.first, stretch.count));
    take_off_line(value);
    spectrum.from = t.front();
    spectrum.to = t.back();
    const double step = (t.back() - t.front()) / static_cast<double>(t.size() - 1);
    spectrum.resolution = 1.0 / (step * static_cast<double>(length));
    const std::size_t padded = std::bit_ceil(4 * length);
    spectrum.density = squared_amplitudes(value, length, padded, settings);
    for (std::size_t k = 0; k < spectrum.density.size(); ++k)
        spectrum.frequency.push_back(static_cast<double>(k) / (step * static_cast<double>(padded)));
    const double sum = spectrum.moment(0), variance = mean_square(value);
    for (double& density : spectrum.density) density *= sum > 0.0 ? variance / sum : 0.0;

    const double missing = 1.0 - static_cast<double>(stretch.count) / static_cast<double>(time.size());
    if (missing > most_missing) spectrum.doubt = "gaps take more than a tenth of the record";
    if (!spectrum.peak_is_resolved()) spectrum.doubt = "the record is too short for its longest waves";
    return spectrum;
}

}  // namespace tidewater::analysis
