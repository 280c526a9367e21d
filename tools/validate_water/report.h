// Runs of the water scenes in configs/validation against closed forms and published measurements.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/series.h"
#include "core/provenance.h"
#include "io/chart.h"
#include "io/places.h"
#include "io/table.h"
#include "scene/scene.h"

namespace tidewater::validation {

struct Run {
    std::string name;  // of its folder
    std::filesystem::path folder;
    scene::Scene scene;
};

// Throws InputError if simulate has not been through the folder.
Run open_run(const std::filesystem::path& folder);

// A line of the table.
struct Finding {
    std::string run, quantity, unit;
    double reference = analysis::none;
    double measured = analysis::none;
    std::string error_unit;  // "%": of the reference; else as `unit`

    double error() const;  // measured − reference; in % if so
};

struct Report {
    std::string name;  // of the picture's file
    std::vector<Finding> findings;
    io::Chart chart;
};

// A column of gauges.csv or pressures.csv that was measured at a place.
struct Record {
    io::NamedPlace place;
    std::vector<double> time, value;
};
std::vector<Record> read_records(const std::filesystem::path& table);

// Each looks at what simulate wrote, and throws InputError if something is missing.
Report report_rest(const Run& run);
Report report_standing(const Run& run);
Report report_solitary(const Run& run);
Report report_front(const Run& run, const std::filesystem::path& data);
Report report_pressure(const Run& run, const std::filesystem::path& data);
// Of one tank, over k.
Report report_dispersion(const std::vector<Run>& runs);

// What a run shows follows from its scene: waves by wave.kind, a dam break by water.length (with pressure
// gauges: the pressure), else rest. Runs of standing waves of one depth and several lengths are drawn as one
// besides.
//     data   the folder of the published series, tests/validation/data
std::vector<Report> report_all(const std::vector<Run>& runs, const std::filesystem::path& data);

// validation.csv: run, quantity, unit, reference, measured, error, error_unit; the same for people.
void write_findings(const std::filesystem::path& path, const std::vector<Report>& reports,
                    const Provenance& provenance);
std::string describe(const std::vector<Report>& reports);

}  // namespace tidewater::validation
