// The run's icebergs and calving, gathered from the files of its frames (iceberg_frames.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "analysis/series.h"
#include "common/stage.h"
#include "frames.h"

namespace tidewater::postprocess {

// A row of icebergs.csv, as far as others need it.
struct IcebergRow {
    double time = 0.0;
    std::uint32_t iceberg = 0;
    double volume = 0.0, area = 0.0;  // m³, m² (2D: m², m)
    std::vector<double> values;       // of all columns
};

// What became of one iceberg.
struct IcebergStory {
    enum class End : std::uint8_t { none, merged, gone };

    std::uint32_t iceberg = 0;
    double parent = analysis::none;  // from which it split; NaN: none
    // When its ice came off the glacier: in its own first frame, or of one that split from an iceberg in that
    // one's. NaN: not known, or it was no part of a glacier.
    double detachment_time = analysis::none;  // s
    double break_distance =
        analysis::none;  // m, analysis/glacier_front.h; NaN unless it split from the glacier
    End end = End::none;
    double merged_into = analysis::none;      // iceberg
    std::size_t rows = 0;                     // how many frames have it
    std::size_t first_row = 0, last_row = 0;  // in IcebergTables
    double greatest_speed = 0.0;              // m/s
    double greatest_rotation = 0.0;           // rad/s

    bool calved = false;  // whether it split from the glacier itself
};

// By frame.
struct CalvingSeries {
    std::vector<double> time;                                         // s
    std::vector<double> icebergs;                                     // how many
    std::vector<double> glacier, in_icebergs, failed, crumbs, front;  // volumes, m³ (2D: m²); front: x, m
    std::vector<double> calved, returned;  // volume that came off the glacier since the frame before; that
                                           // grew to it again
    std::vector<double> total;             // Σ calved − returned so far
    std::vector<double> rate;              // m³/s (2D: m²/s), analysis/calving_rate.h
    double window = 0.0;                   // s, of the rate
};

struct IcebergTables {
    std::vector<std::string> columns;   // of icebergs.csv
    std::vector<IcebergRow> rows;       // by frame, then iceberg
    std::vector<IcebergStory> stories;  // by iceberg; those of which a frame has a row
    CalvingSeries calving;

    std::size_t column(const std::string& name) const {  // its place in `columns`, which has it
        return static_cast<std::size_t>(std::ranges::find(columns, name) - columns.begin());
    }
};

// Throws InputError if a file is damaged.
IcebergTables gather_icebergs(const StageContext& context, const Frames& frames);

// icebergs.csv, iceberg_summary.csv, iceberg_events.csv and calving.csv.
void write_icebergs(const StageContext& context, const Frames& frames, const IcebergTables& tables);

// The line that the stage prints for people.
std::string describe(const IcebergTables& tables, int dimension);

}  // namespace tidewater::postprocess
