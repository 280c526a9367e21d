#include <algorithm>
#include <array>

#include "core/files.h"
#include "io/cell_table.h"
#include "report_parts.h"

namespace tidewater::postprocess {
namespace {

constexpr std::size_t most_rows = 100;  // of a table in the report; its file holds all

struct Contents {
    const char* file;
    const char* title;
    const char* caption;
};

constexpr std::array charts{
    Contents{"space_time.svg", "Water surface over place and time",
             "A wave's speed is the slope of its stripe."},
    Contents{"gauges.svg", "Gauges", "Surface above the still level; arrivals and leading crests as found."},
    Contents{"celerity.svg", "Celerity", "Where the crest was when, against a long wave's √(gD)."},
    Contents{"first_wave.svg", "First wave",
             "The paper's Fig. 2b: amplitude and place of the leading crest."},
    Contents{"decay.svg", "Decay with distance", "Crests over distance, with the fit and its interval."},
    Contents{"spectra.svg", "Spectra", "Variance density of the gauges' records."},
    Contents{"run_up.svg", "Run-up", "Height of the waterline on the far shore over time."},
    Contents{"calving.svg", "Calving", "Calved volume, rate and front position over time."},
    Contents{"sizes.svg", "Iceberg sizes", "How many icebergs are at least so large, with fitted laws."},
    Contents{"energy.svg", "Energy ledger", "Changes since the start; the total may only fall."},
    Contents{"energy_split.svg", "Energy of block and water", "Where the block's energy went."},
    Contents{"bodies.svg", "Blocks", "Height, angle and fastest speed."},
};

constexpr std::array tables{
    Contents{"iceberg_summary.csv", "Icebergs", "One row per iceberg; click a heading to sort."},
    Contents{"main_event.csv", "Main event", "The greatest loss between two frames; its failure plane."},
    Contents{"first_iceberg.csv", "First iceberg", "When and where it came off."},
    Contents{"iceberg_events.csv", "Splits and merges", "What became of the icebergs."},
    Contents{"waves.csv", "Waves at the gauges",
             "One row per gauge, the leading wave first; the last row is fitted over all gauges."},
    Contents{"decay_fit.csv", "Decay with distance", "Crest = amplitude × (distance/depth)^−exponent."},
    Contents{"long_waves.csv", "Speed of long waves", "From gauge to gauge, by linear dispersion."},
    Contents{"waves_3d.csv", "The wave in 3D", "Eqs. 11 to 13 of the paper, with their ±50 % band."},
    Contents{"calving_wave.csv", "The ice as a slide",
             "What the main event sent into the water, by laboratory formulas."},
    Contents{"tsunami.csv", "The wave's source", "Slide parameters, first wave and energies."},
    Contents{"size_fits.csv", "Fits of iceberg sizes", "Maximum likelihood, 95 % intervals."},
};

struct Unit {
    const char* unit;
    std::vector<const char*> columns;
};

// Of columns whose names leave no doubt.
const std::vector<Unit>& units() {
    static const std::vector<Unit> all{
        {"s", {"time",
               "time_before",
               "arrival",
               "crest_time",
               "period",
               "greatest_time",
               "mean_period",
               "record_end",
               "T_z",
               "T_s",
               "T_p",
               "T_m01",
               "T_m02",
               "detachment_time",
               "first_time",
               "last_time",
               "start_time",
               "end_time",
               "crack_time",
               "speed_time",
               "amplitude_time",
               "celerity_from"}},
        {"m",
         {"x",
          "y",
          "crest",
          "trough",
          "greatest",
          "lowest",
          "H_s",
          "H_max",
          "H_mean",
          "H_m0",
          "depth",
          "break_distance",
          "first_length",
          "first_width",
          "first_height",
          "first_x",
          "first_y",
          "first_z",
          "first_draft",
          "first_freeboard",
          "last_x",
          "last_y",
          "last_z",
          "last_draft",
          "last_freeboard",
          "failed_width",
          "amplitude",
          "amplitude_2d",
          "amplitude_3d",
          "amplitude_3d_low",
          "amplitude_3d_high",
          "impulse_height",
          "impulse_amplitude",
          "amplitude_x",
          "amplitude_distance",
          "length",
          "height"}},
        {"m/s",
         {"celerity", "long_wave_celerity", "linear_celerity", "celerity_from_arrivals", "greatest_speed",
          "speed"}},
        {"kg", {"mass", "first_mass", "last_mass"}},
        {"J", {"block_energy", "water_energy", "lost_energy", "greatest_rise"}},
        {"°", {"plane_angle", "foot_angle"}}};
    return all;
}

// "detachment_time" is "detachment time (s)", and the symbol "H_s" "H_s (m)".
std::string heading(const std::string& column) {
    std::string text = column;
    if (!text.empty() && text.front() >= 'a') std::ranges::replace(text, '_', ' ');
    for (const auto& [unit, columns] : units()) {
        if (std::ranges::find(columns, column) != columns.end()) return text + " (" + unit + ")";
    }
    return text;
}

io::ReportTable shown(const Contents& contents, io::CellTable table) {
    std::string caption = contents.caption;
    if (table.rows.size() > most_rows) {
        caption +=
            " The first " + std::to_string(most_rows) + " of " + std::to_string(table.rows.size()) + ".";
        table.rows.resize(most_rows);
    }
    for (auto& row : table.rows) {
        for (std::string& cell : row) {
            const double number = table.number(static_cast<std::size_t>(&row - table.rows.data()),
                                               table.columns[static_cast<std::size_t>(&cell - row.data())]);
            if (number == number) cell = short_number(number);
            if (cell == "nan") cell = "-";
        }
    }
    for (std::string& column : table.columns) column = heading(column);
    caption += " All digits: " + std::string(contents.file);
    if (table.rows.size() != 1) return {contents.title, caption, table.columns, table.rows};
    io::ReportTable turned{
        contents.title, caption, {"what", "value"}};  // one wide row reads better down the page
    for (std::size_t c = 0; c < table.columns.size(); ++c)
        turned.rows.push_back({table.columns[c], table.rows[0][c]});
    return turned;
}

}  // namespace

std::vector<io::ReportFigure> report_figures(const StageContext& context) {
    std::vector<io::ReportFigure> figures;
    for (const Contents& chart : charts) {
        const auto path = context.folder / chart.file;
        if (std::filesystem::exists(path)) figures.push_back({chart.title, chart.caption, read_text(path)});
    }
    return figures;
}

std::vector<io::ReportTable> report_tables(const StageContext& context) {
    std::vector<io::ReportTable> found;
    for (const Contents& contents : tables) {
        const auto path = context.folder / contents.file;
        if (std::filesystem::exists(path)) found.push_back(shown(contents, io::read_cells(path)));
    }
    return found;
}

}  // namespace tidewater::postprocess
