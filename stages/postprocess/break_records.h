// How the ice broke, as first_iceberg.csv and main_event.csv hold it, one row each (first_iceberg.h finds
// it).
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "analysis/calving.h"
#include "analysis/first_crack.h"
#include "core/provenance.h"

namespace tidewater::postprocess {

inline constexpr const char *first_iceberg_file = "first_iceberg.csv", *main_event_file = "main_event.csv";

// What first_iceberg.csv holds, in one row; NaN where there was none.
struct FirstIceberg {
    analysis::FirstCrack crack{analysis::none, analysis::none, analysis::none, analysis::none};
    analysis::Calving calving;
    double end_time = 0.0;               // of the last frame, s
    double failed_share = 0.0;           // of the ice's volume, at the end
    double ice_height = analysis::none;  // of the ice at rest, m
};

// What main_event.csv holds, in one row: the frame in which the most ice came off the glacier.
struct MainEvent {
    double frame = analysis::none;        // its number; NaN: nothing came off
    double time_before = analysis::none;  // s, of the frame before
    double icebergs = 0.0;                // that came off in it
    double largest = analysis::none;      // iceberg, the largest of them
    analysis::Calving calving;            // of all of them; time is the frame's
};

// density: of the ice, kg/m³, for its mass.
void write_first_iceberg(const std::filesystem::path& folder, const FirstIceberg& first, double density,
                         const Provenance& provenance);
void write_main_event(const std::filesystem::path& folder, const MainEvent& event, double density,
                      const Provenance& provenance);

// Nothing if the file is not there. Throws InputError.
std::optional<FirstIceberg> read_first_iceberg(const std::filesystem::path& folder);
std::optional<MainEvent> read_main_event(const std::filesystem::path& folder);

// The lines that the stage prints for people.
std::string describe(const FirstIceberg& first, int dimension);
std::string describe(const MainEvent& event, int dimension);

// "1234 m³", "1234 m² per m of width"
std::string volume_text(double volume, int dimension);

}  // namespace tidewater::postprocess
