#include "cases.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "io/table.h"
#include "io/text.h"

namespace tidewater::lab {
namespace {

void require_file(const std::filesystem::path& path) {
    if (std::filesystem::exists(path)) return;
    throw InputError(
        path.string() +
        ": the file does not exist; run tidewater-postprocess on a run with a rigid block in water");
}

void read_tsunami(const std::filesystem::path& path, Case& c, double& direction) {
    require_file(path);
    const io::Table table = io::read_table(path);
    const auto value = [&](const char* column) {
        const auto& values = io::require_column(table, column, path);
        if (values.size() == 1) return values.front();
        throw InputError(path.string() + ": it must have one row; run tidewater-postprocess again");
    };
    direction = value("direction");
    c.speed = value("speed");
    c.froude = value("F");
    c.thickness_ratio = value("S");
    c.mass_ratio = value("M");
    c.impulse_product = value("P");
    c.amplitude = value("amplitude");
    c.amplitude_time = value("amplitude_time");
    c.amplitude_distance = value("amplitude_distance");
    c.celerity = value("celerity");
    c.linear_celerity = value("linear_celerity");
    c.long_wave_celerity = value("long_wave_celerity");
    c.block_energy = value("block_energy");
    c.water_energy = value("water_energy");
    c.lost_energy = value("lost_energy");
    c.greatest_rise = value("greatest_rise");
}

// Of the way of the higher wave; of the first way that has a celerity if no crest was found.
void read_long_waves(const std::filesystem::path& path, double direction, Case& c) {
    if (!std::filesystem::exists(path)) return;  // an older run's
    const io::Table table = io::read_table(path);
    const auto &way = io::require_column(table, "direction", path),
               &celerity = io::require_column(table, "celerity", path),
               &error = io::require_column(table, "error", path);
    for (std::size_t r = 0; r < way.size(); ++r) {
        if (std::isnan(celerity[r]) || (!std::isnan(direction) && way[r] != direction)) continue;
        c.long_waves = celerity[r];
        c.long_waves_error = error[r];
        return;
    }
}

void read_track(const std::filesystem::path& path, double direction, Case& c) {
    require_file(path);
    const io::Table table = io::read_table(path);
    const auto &time = io::require_column(table, "time_from_greatest", path),
               &ratio = io::require_column(table, "amplitude_ratio", path),
               &distance = io::require_column(table, "distance", path),
               &way = io::require_column(table, "direction", path);
    for (std::size_t r = 0; r < time.size(); ++r) {
        if (way[r] != direction) continue;
        c.time.push_back(time[r]);
        c.ratio.push_back(ratio[r]);
        c.run.push_back(distance[r] - c.amplitude_distance);
    }
}

double error_percent(double value, double reference) { return 100.0 * (value / reference - 1.0); }

// "GF   1.020 m/s (-11 %)"; "-" where there is no number.
std::string cell(double value, int decimals, std::size_t width) {
    std::string text = std::isnan(value) ? "-" : io::format_fixed(value, decimals);
    text.insert(0, width - std::min(width, text.size()), ' ');
    return text;
}

}  // namespace

const Experiment* experiment_of(std::string_view label) {
    const auto found = std::ranges::find_if(
        experiments, [&](const Experiment& experiment) { return label.starts_with(experiment.name); });
    return found == experiments.end() ? nullptr : &*found;
}

double Case::celerity_error() const { return error_percent(celerity, long_wave_celerity); }

analysis::Slide Case::slide(bool measured_speed) const {
    const Experiment* experiment = experiment_of(label);
    const bool measured = measured_speed && experiment;
    const double f = measured ? experiment->speed / long_wave_celerity : froude;
    analysis::Slide slide{.thickness = thickness_ratio, .depth = 1.0};
    slide.speed = f * std::sqrt(slide.gravity);
    slide.mass = mass_ratio * slide.water_density;
    return slide;
}

double Case::amplitude_3d(double distance_ratio, bool measured_speed) const {
    return analysis::radial_factor(slide(measured_speed), distance_ratio) * amplitude;
}

Case read_case(const std::string& argument) {
    const auto equals = argument.find('=');
    const std::filesystem::path folder = equals == argument.npos ? argument : argument.substr(equals + 1);
    Case c;
    c.label = equals == argument.npos ? std::filesystem::weakly_canonical(folder).filename().string()
                                      : argument.substr(0, equals);
    double direction = 1.0;
    read_tsunami(folder / "postprocess" / "tsunami.csv", c, direction);
    read_long_waves(folder / "postprocess" / "long_waves.csv", direction, c);
    read_track(folder / "postprocess" / "first_wave.csv", direction, c);
    return c;
}

void write_cases(const std::filesystem::path& path, const std::vector<Case>& cases,
                 const Provenance& provenance) {
    std::vector<std::string> columns{"case",
                                     "speed",
                                     "lab_speed",
                                     "speed_error_percent",
                                     "F",
                                     "S",
                                     "M",
                                     "P",
                                     "amplitude",
                                     "amplitude_time",
                                     "amplitude_distance",
                                     "celerity",
                                     "error_percent",
                                     "linear_celerity",
                                     "long_waves",
                                     "long_waves_error",
                                     "block_energy",
                                     "water_energy",
                                     "lost_energy",
                                     "greatest_rise",
                                     "energy_to_equilibrium"};
    for (const char* prefix : {"amplitude_3d_", "amplitude_3d_lab_speed_"}) {
        for (const double ratio : analysis::laboratory_distances)
            columns.push_back(prefix + io::format_number(ratio));
    }
    io::TableWriter table(path, provenance, columns);
    for (const Case& c : cases) {
        const Experiment* experiment = experiment_of(c.label);
        const double speed = experiment ? experiment->speed : analysis::none;
        std::vector<double> numbers{c.speed,
                                    speed,
                                    error_percent(c.speed, speed),
                                    c.froude,
                                    c.thickness_ratio,
                                    c.mass_ratio,
                                    c.impulse_product,
                                    c.amplitude,
                                    c.amplitude_time,
                                    c.amplitude_distance,
                                    c.celerity,
                                    c.celerity_error(),
                                    c.linear_celerity,
                                    c.long_waves,
                                    c.long_waves_error,
                                    c.block_energy,
                                    c.water_energy,
                                    c.lost_energy,
                                    c.greatest_rise,
                                    experiment ? experiment->energy : analysis::none};
        for (const bool measured : {false, true}) {
            for (const double ratio : analysis::laboratory_distances) {
                const bool known = experiment || !measured;
                numbers.push_back(known ? c.amplitude_3d(ratio, measured) : analysis::none);
            }
        }
        std::vector<std::string> cells{c.label};
        for (const double number : numbers) cells.push_back(io::format_number(number));
        table.append_cells(cells);
    }
    table.finish();
}

std::string describe(const std::vector<Case>& cases) {
    std::string text =
        "case       v_s (m/s)   lab   error %   2D a (m)  3D a at r/D = 2 (m)   celerity (m/s)  error %   "
        "linear  long waves   lost (J/m)   rise (J/m)\n";
    for (const Case& c : cases) {
        const Experiment* experiment = experiment_of(c.label);
        const double speed = experiment ? experiment->speed : analysis::none;
        std::string label = c.label;
        label.resize(std::max(label.size(), std::size_t{10}), ' ');
        text += label + cell(c.speed, 3, 10) + cell(speed, 2, 6) +
                cell(error_percent(c.speed, speed), 1, 10) + cell(c.amplitude, 4, 11) +
                cell(c.amplitude_3d(2.0), 4, 21) + cell(c.celerity, 3, 17) + cell(c.celerity_error(), 1, 9) +
                cell(c.linear_celerity, 3, 9) + cell(c.long_waves, 3, 12) + cell(c.lost_energy, 1, 13) +
                cell(c.greatest_rise, 2, 13) + "\n";
    }
    return text;
}

}  // namespace tidewater::lab
