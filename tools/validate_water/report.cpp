#include "report.h"

#include <cmath>
#include <map>
#include <tuple>

#include "core/error.h"
#include "io/text.h"

namespace tidewater::validation {
namespace {

bool breaks_dam(const scene::Scene& scene) {
    return scene.water.length > 0.0 && scene.water.length < scene.domain.size.front();
}

Report report(const Run& run, const std::filesystem::path& data) {
    if (run.scene.has("wave") && run.scene.wave.kind == analysis::WaveKind::solitary)
        return report_solitary(run);
    if (run.scene.has("wave")) return report_standing(run);
    if (!breaks_dam(run.scene)) return report_rest(run);
    const bool sensors = std::filesystem::exists(run.folder / "simulate" / "pressures.csv");
    return sensors ? report_pressure(run, data) : report_front(run, data);
}

std::string padded(std::string text, std::size_t width) {
    std::size_t letters = 0;
    for (const char c : text) letters += (static_cast<unsigned char>(c) & 0xc0) != 0x80;  // of UTF-8
    if (letters < width) text.append(width - letters, ' ');
    return text;
}

// Four digits; "-" for none.
std::string short_number(double value) {
    if (!std::isfinite(value)) return "-";
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

}  // namespace

Run open_run(const std::filesystem::path& folder) {
    const auto scene = folder / "simulate" / "scene.toml";
    if (!std::filesystem::exists(folder / "simulate" / "ledger.csv") || !std::filesystem::exists(scene))
        throw InputError(folder.string() + ": no whole run; run tidewater-geometry and tidewater-simulate");
    return {std::filesystem::weakly_canonical(folder).filename().string(), folder, scene::read_scene(scene)};
}

double Finding::error() const {
    return error_unit == "%" ? 100.0 * (measured / reference - 1.0) : measured - reference;
}

std::vector<Record> read_records(const std::filesystem::path& path) {
    const io::Table table = io::read_table(path);
    const auto& time = io::require_column(table, "time", path);
    std::vector<Record> records;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        if (const auto place = io::parse_place(table.columns[c]))
            records.push_back({*place, time, table.values[c]});
    }
    if (records.empty() || time.size() < 2)
        throw InputError(path.string() + ": nothing was measured; name gauges in the scene and run again");
    return records;
}

std::vector<Report> report_all(const std::vector<Run>& runs, const std::filesystem::path& data) {
    std::vector<Report> reports;
    std::map<std::tuple<double, double, double>, std::vector<Run>> standing;  // by depth, tank and cells
    for (const Run& run : runs) {
        reports.push_back(report(run, data));
        if (run.scene.has("wave") && run.scene.wave.kind == analysis::WaveKind::standing)
            standing[{run.scene.water.depth, run.scene.domain.size.front(), run.scene.domain.cell_size}]
                .push_back(run);
    }
    for (const auto& [tank, alike] : standing) {
        if (alike.size() > 1) reports.push_back(report_dispersion(alike));
    }
    return reports;
}

void write_findings(const std::filesystem::path& path, const std::vector<Report>& reports,
                    const Provenance& provenance) {
    io::TableWriter table(path, provenance,
                          {"run", "quantity", "unit", "reference", "measured", "error", "error_unit"});
    for (const Report& report : reports) {
        for (const Finding& f : report.findings) {
            const std::vector<std::string> cells{f.run,
                                                 f.quantity,
                                                 f.unit,
                                                 io::format_number(f.reference),
                                                 io::format_number(f.measured),
                                                 io::format_number(f.error()),
                                                 f.error_unit};
            table.append_cells(cells);
        }
    }
    table.finish();
}

std::string describe(const std::vector<Report>& reports) {
    std::string text = padded("run", 24) + padded("quantity", 44) + padded("reference", 12) +
                       padded("measured", 12) + "error\n";
    for (const Report& report : reports) {
        for (const Finding& f : report.findings) {
            const std::string unit = f.unit.empty() ? "" : " (" + f.unit + ")";
            const std::string error =
                std::isfinite(f.error()) ? short_number(f.error()) + " " + f.error_unit : "";
            text += padded(f.run, 24) + padded(f.quantity + unit, 44) +
                    padded(short_number(f.reference), 12) + padded(short_number(f.measured), 12) + error +
                    "\n";
        }
    }
    return text;
}

}  // namespace tidewater::validation
