#include <algorithm>
#include <cmath>
#include <map>

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

// Above the start, by more than rounding of what it is a sum of; told as a share of what moves.
void check_energy(const io::Table& ledger, Warnings& warnings) {
    const auto *energy = ledger.find("energy"), *gravitational = ledger.find("gravitational"),
               *kinetic = ledger.find("kinetic");
    if (!energy || energy->empty() || !gravitational || !kinetic) return;
    const double rise = *std::ranges::max_element(*energy) - energy->front();
    if (rise <= rounding * std::max(std::abs(energy->front()), std::abs(gravitational->front()))) return;
    warnings.push_back("The total energy rises by up to " + short_number(rise) + " J above its start, " +
                       short_number(100.0 * rise / *std::ranges::max_element(*kinetic)) +
                       " % of the greatest kinetic energy: it should only fall (simulate/ledger.csv).");
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

// momentum + outflow − walls' impulse − gravity's impulse stays what it was, to rounding of what was brought.
void check_momentum(const io::Table& ledger, Warnings& warnings) {
    for (const std::string axis : {"x", "y", "z"}) {
        const auto *momentum = ledger.find("momentum_" + axis), *wall = ledger.find("wall_impulse_" + axis),
                   *outflow = ledger.find("outflow_momentum_" + axis),
                   *gravity = ledger.find("gravity_impulse_" + axis);
        if (!momentum || momentum->empty() || !wall) continue;
        std::vector<double> open = *momentum;
        double brought = 0.0;
        for (std::size_t r = 0; r < open.size(); ++r) {
            const double pull = gravity ? (*gravity)[r] : 0.0;
            open[r] += (outflow ? (*outflow)[r] : 0.0) - (*wall)[r] - pull;
            brought = std::max({brought, std::abs(pull), std::abs((*wall)[r]), std::abs((*momentum)[r])});
        }
        if (span(open) > rounding * brought)
            warnings.push_back("Momentum along " + axis + " is open by " + short_number(span(open)) +
                               " kg m/s of " + short_number(brought) +
                               " kg m/s brought by walls and gravity.");
    }
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
    check_momentum(ledger, warnings);
}

// A run of this program that failed, is going on or was stopped; frames.h refuses gaps.
void check_end(const StageContext& context, const Frames& frames, const std::optional<io::RunFacts>& run,
               Warnings& warnings) {
    if (!run) return;
    if (run->state == "failed") return warnings.push_back("The run failed: " + run->reason + ".");
    const double end = context.scene.simulate.end_time, interval = context.scene.simulate.snapshot_interval;
    if (frames.times.empty() || frames.times.back() >= end - 1.5 * interval) return;
    warnings.push_back("The run is going on or was stopped: its last frame is of t = " +
                       short_number(frames.times.back()) + " s of " + short_number(end) + " s.");
}

// What simulate warned of besides the scene's warnings, which are there already.
void add_run_warnings(const std::optional<io::RunFacts>& run, Warnings& warnings) {
    if (!run) return;
    for (const std::string& warning : run->warnings) {
        if (std::ranges::find(warnings, warning) == warnings.end()) warnings.push_back(warning);
    }
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

// What the fits and statistics themselves doubt, with the rows that do: by the column `by`.
void check_doubts(const StageContext& context, const std::string& file, const std::string& by,
                  const std::string& what, Warnings& warnings) {
    const auto path = context.folder / file;
    if (!std::filesystem::exists(path)) return;
    const io::CellTable table = io::read_cells(path);
    std::map<std::string, Warnings> rows;
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
        const std::string doubt = table.word(r, "doubt");
        if (doubt.empty() || doubt == "none") continue;
        Warnings& names = rows[doubt];
        if (std::ranges::find(names, table.word(r, by)) == names.end()) names.push_back(table.word(r, by));
    }
    for (const auto& [doubt, names] : rows) {
        std::string list;
        for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
        warnings.push_back(what + " (" + by + " " + list + ") is not to be trusted: " + doubt + " (" + file +
                           ").");
    }
}

void check_impulse(const StageContext& context, Warnings& warnings) {
    const auto path = context.folder / "waves_3d.csv";
    if (!std::filesystem::exists(path)) return;
    const io::CellTable table = io::read_cells(path);
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
        const std::string range = table.word(r, "impulse_range");
        if (!range.starts_with("outside")) continue;
        warnings.push_back("The impulse-product estimate of the wave is " + range + " (waves_3d.csv).");
        return;
    }
}

}  // namespace

std::filesystem::path simulated_table(const StageContext& context, const std::string& name) {
    for (const std::string& each : {name, name + ".part"}) {
        const auto path = context.run / "simulate" / each;
        if (std::filesystem::exists(path)) return path;
    }
    return {};
}

std::vector<std::string> report_warnings(const StageContext& context, const Frames& frames,
                                         const std::optional<io::RunFacts>& run) {
    Warnings warnings = scene::scene_warnings(context.scene);
    check_end(context, frames, run, warnings);
    add_run_warnings(run, warnings);
    check_ledger(context, warnings);
    check_gauges(context, warnings);
    check_doubts(context, "size_fits.csv", "set", "The fit of the icebergs' sizes", warnings);
    check_doubts(context, "decay_fit.csv", "source", "The fit of the wave's decay", warnings);
    check_doubts(context, "waves.csv", "x", "The waves' statistics at gauges", warnings);
    check_impulse(context, warnings);
    return warnings;
}

}  // namespace tidewater::postprocess
