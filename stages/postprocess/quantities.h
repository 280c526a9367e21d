// The numbers that a report tells, by name, from the tables that the stage has written; and what a scene file
// says that they should be.
//
// A scene states its references in postprocess.references, one text each:
//     "failed_width 50 60 Lüthi & Vieli 2016"       name, least, greatest (in the quantity's unit), source
//     "crest@250 45 50 Lüthi & Vieli 2016"          of the gauge nearest to x = 250 m
//     "celerity 31 - theory"                        "-": no bound on that side
//
// Test: tests/pipeline/report_test.sh
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tidewater::postprocess {

inline constexpr const char* volume_unit = "m³";  // in 2D per metre of width

struct Quantity {
    std::string name, label, unit;
    double value = 0.0;  // NaN: the run's tables do not tell it
};

// All that the tables in the folder tell, in the order of the catalogue; a table that is not there tells
// nothing.
std::vector<Quantity> told_quantities(const std::filesystem::path& folder);

// The quantity of a reference, "crest@250" too; its value is NaN if the tables do not tell it.
Quantity find_quantity(const std::filesystem::path& folder, const std::string& name);

struct Reference {
    std::string quantity;          // of the catalogue, with @x where it is one gauge's
    double low = 0.0, high = 0.0;  // infinite: no bound
    std::string source;
};

// Throws SceneError, naming postprocess.references and what is wrong in which text; unknown names are told
// with the catalogue's.
std::vector<Reference> parse_references(const std::vector<std::string>& texts);

}  // namespace tidewater::postprocess
