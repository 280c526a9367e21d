#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "io/cell_table.h"
#include "io/table.h"
#include "io/text.h"
#include "report_parts.h"

namespace tidewater::postprocess {
namespace {

// Rounding of single precision over a run moves the sums of the ledger by about this share.
constexpr double rounding = 1e-6;

using Warnings = std::vector<std::string>;

double span(const std::vector<double>& values) {
    const auto [low, high] = std::ranges::minmax_element(values);
    return *high - *low;
}

// Above the start, by more than rounding of the greatest energy.
void check_energy(const io::Table& ledger, Warnings& warnings) {
    const auto* energy = ledger.find("energy");
    const auto* gravitational = ledger.find("gravitational");
    if (!energy || energy->empty() || !gravitational) return;
    const double rise = *std::ranges::max_element(*energy) - energy->front();
    const double scale = std::abs(gravitational->front());
    if (rise > rounding * scale) {
        warnings.push_back(
            "The total energy rises by up to " + short_number(rise) + " J above its start, " +
            short_number(rise / scale) +
            " of the gravitational energy: it should only fall (energy chart, simulate/ledger.csv).");
    }
}

// mass + outflow_mass stays what it was at the start.
void check_mass(const io::Table& ledger, Warnings& warnings) {
    const auto* mass = ledger.find("mass");
    if (!mass || mass->empty()) return;
    std::vector<double> all = *mass;
    if (const auto* outflow = ledger.find("outflow_mass")) {
        for (std::size_t r = 0; r < all.size(); ++r) all[r] += (*outflow)[r];
    }
    if (span(all) > rounding * all.front())
        warnings.push_back("Mass drifts by " + short_number(span(all)) + " kg of " +
                           short_number(all.front()) + " kg.");
}

void check_ledger(const StageContext& context, Warnings& warnings) {
    const auto path = simulated_table(context, "ledger.csv");
    if (path.empty()) {
        warnings.push_back("There is no ledger of energy and momentum (simulate/ledger.csv).");
        return;
    }
    const io::Table ledger = io::read_table(path);
    check_energy(ledger, warnings);
    check_mass(ledger, warnings);
}

// A run that is going on, was stopped, or whose frames end early.
void check_end(const StageContext& context, const Frames& frames, Warnings& warnings) {
    const double end = context.scene.simulate.end_time;
    if (frames.times.empty() || frames.times.back() > end - 1.5 * context.scene.simulate.snapshot_interval)
        return;
    warnings.push_back("The run has not ended: its last frame is of t = " +
                       short_number(frames.times.back()) + " s of " + short_number(end) + " s.");
}

void check_gauges(const StageContext& context, Warnings& warnings) {
    const auto path = context.folder / "waves.csv";
    if (!std::filesystem::exists(path)) return;
    const io::CellTable waves = io::read_cells(path);
    const double length = context.scene.domain.size.front();
    for (std::size_t r = 0; r < waves.rows.size(); ++r) {
        if (waves.word(r, "source") == "all") continue;
        const double x = waves.number(r, "x");
        const std::string name = "The gauge at x = " + io::format_number(x) + " m ";
        if (x < 0.0 || x > length) {
            warnings.push_back(name + "lies outside of the tank.");
        } else if (std::isnan(waves.number(r, "greatest"))) {
            warnings.push_back(name + "never saw water above its level, or stands on dry ground.");
        }
    }
}

// What the fits and statistics themselves doubt.
void check_doubts(const StageContext& context, const std::string& file, const std::string& what,
                  Warnings& warnings) {
    const auto path = context.folder / file;
    if (!std::filesystem::exists(path)) return;
    const io::CellTable table = io::read_cells(path);
    Warnings doubts;
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
        const std::string doubt = table.word(r, "doubt");
        if (!doubt.empty() && std::ranges::find(doubts, doubt) == doubts.end()) doubts.push_back(doubt);
    }
    for (const std::string& doubt : doubts)
        warnings.push_back(what + " is not to be trusted: " + doubt + " (" + file + ").");
}

void check_impulse(const StageContext& context, Warnings& warnings) {
    const auto path = context.folder / "waves_3d.csv";
    if (!std::filesystem::exists(path)) return;
    const io::CellTable table = io::read_cells(path);
    if (table.word(0, "impulse_range") == "0" || table.word(0, "impulse_range") == "outside")
        warnings.push_back("The impulse-product estimate is outside of its validated range.");
}

}  // namespace

std::filesystem::path simulated_table(const StageContext& context, const std::string& name) {
    for (const std::string& each : {name, name + ".part"}) {
        const auto path = context.run / "simulate" / each;
        if (std::filesystem::exists(path)) return path;
    }
    return {};
}

std::vector<std::string> report_warnings(const StageContext& context, const Frames& frames) {
    Warnings warnings = scene::scene_warnings(context.scene);
    check_end(context, frames, warnings);
    check_ledger(context, warnings);
    check_gauges(context, warnings);
    check_doubts(context, "size_fits.csv", "The fit of the icebergs' sizes", warnings);
    check_doubts(context, "decay_fit.csv", "The fit of the wave's decay", warnings);
    check_doubts(context, "waves.csv", "A gauge's wave statistics", warnings);
    check_impulse(context, warnings);
    return warnings;
}

}  // namespace tidewater::postprocess
