#include "first_iceberg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/box.h"
#include "analysis/failure_surface.h"
#include "analysis/iceberg_track.h"
#include "core/types.h"
#include "iceberg_frames.h"
#include "io/snapshot.h"
#include "io/table.h"
#include "io/text.h"

namespace tidewater::postprocess {
namespace {

constexpr const char *first_file = "first_iceberg.csv", *event_file = "main_event.csv";

bool is_ice(const io::Snapshot& snapshot, std::size_t p) {
    return static_cast<Material>(snapshot.material[p]) == Material::ice;
}

// Of a file without ids their places in it (iceberg_frames.h).
std::uint32_t id_of(const io::Snapshot& snapshot, std::size_t p) {
    return snapshot.id.empty() ? static_cast<std::uint32_t>(p) : snapshot.id[p];
}

// The ice of the first frame in the order of ids, with the failure times of the last.
struct Ice {
    std::vector<std::uint32_t> id;
    std::vector<float> points, volume, failure_time;

    analysis::IceAtRest at_rest() const { return {points, volume, failure_time}; }
};

// By particle id, whether it is in an iceberg from the start, beside a glacier.
std::vector<bool> apart_from_glacier(const io::Members& first) {
    std::vector<bool> apart;
    if (!std::ranges::count(first.iceberg, analysis::glacier_id)) return apart;
    if (!first.particle.empty()) apart.resize(std::size_t{first.particle.back()} + 1, false);
    for (std::size_t i = 0; i < first.particle.size(); ++i)
        apart[first.particle[i]] = first.iceberg[i] != analysis::glacier_id;
    return apart;
}

// Without what floats apart from the start.
Ice read_ice(const io::Snapshot& first, const io::Members& members) {
    const std::vector<bool> apart = apart_from_glacier(members);
    std::vector<std::uint32_t> order;
    for (std::uint32_t p = 0; p < first.particle_count(); ++p) {
        const std::uint32_t id = id_of(first, p);
        if (is_ice(first, p) && !(id < apart.size() && apart[id])) order.push_back(p);
    }
    std::ranges::sort(order, {}, [&](std::uint32_t p) { return id_of(first, p); });
    Ice ice;
    ice.id.reserve(order.size());
    ice.volume.reserve(order.size());
    ice.points.reserve(3 * order.size());
    for (const std::uint32_t p : order) {
        ice.id.push_back(id_of(first, p));
        ice.volume.push_back(first.volume[p]);
        ice.points.insert(ice.points.end(), &first.points[3 * p], &first.points[3 * p] + 3);
    }
    return ice;
}

void add_failure_times(const io::Snapshot& last, Ice& ice) {
    if (last.failure_time.empty()) return;
    ice.failure_time.assign(ice.id.size(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t p = 0; p < last.particle_count(); ++p) {
        if (!is_ice(last, p)) continue;
        const auto at = std::ranges::lower_bound(ice.id, id_of(last, p));
        if (at != ice.id.end() && *at == id_of(last, p))
            ice.failure_time[static_cast<std::size_t>(at - ice.id.begin())] = last.failure_time[p];
    }
}

double failed_share(const Ice& ice) {
    double failed = 0.0, all = 0.0;
    for (std::size_t p = 0; p < ice.volume.size(); ++p) {
        all += ice.volume[p];
        if (!std::isnan(ice.failure_time[p])) failed += ice.volume[p];
    }
    return failed / all;
}

analysis::CalvingSettings calving_settings(const scene::Scene& scene) {
    return {.dimension = scene.dimension,
            .spacing = particle_spacing(scene),
            .reach = scene.postprocess.iceberg_reach,
            .smallest_share = scene.postprocess.iceberg_share};
}

FirstIceberg find_first(const Ice& ice, double end_time, const scene::Scene& scene) {
    const analysis::CalvingSettings settings = calving_settings(scene);
    FirstIceberg first;
    first.end_time = end_time;
    if (ice.volume.empty()) return first;
    const auto crack =
        analysis::first_crack(ice.at_rest(), {.spacing = settings.spacing, .reach = settings.reach});
    first.crack = crack.value_or(first.crack);
    first.calving = analysis::first_detachment(ice.at_rest(), settings).value_or(analysis::Calving{});
    first.failed_share = failed_share(ice);
    first.ice_height = analysis::bounds(ice.points).height() + settings.spacing;
    return first;
}

// What came off the glacier in a frame.
struct Detached {
    std::size_t frame = 0;
    double volume = 0.0, largest_volume = 0.0;
    std::vector<std::uint32_t> icebergs;  // the largest first
};

Detached read_detached(const std::filesystem::path& folder, std::size_t frame) {
    const auto path = folder / frame_file("iceberg_events", frame);
    const io::Table table = io::read_table(path);
    const auto &kind = io::require_column(table, "kind", path),
               &iceberg = io::require_column(table, "iceberg", path),
               &other = io::require_column(table, "other", path),
               &volume = io::require_column(table, "volume", path);
    Detached detached;
    detached.frame = frame;
    for (std::size_t r = 0; r < kind.size(); ++r) {
        const bool split = kind[r] == static_cast<double>(analysis::IcebergEvent::Kind::split);
        if (!split || other[r] != analysis::glacier_id) continue;
        detached.volume += volume[r];
        detached.icebergs.push_back(static_cast<std::uint32_t>(iceberg[r]));
        if (volume[r] <= detached.largest_volume) continue;
        detached.largest_volume = volume[r];
        std::swap(detached.icebergs.front(), detached.icebergs.back());
    }
    return detached;
}

MainEvent find_main_event(const Ice& ice, const Frames& frames, const StageContext& context) {
    Detached main;
    for (std::size_t frame = 1; frame < frames.files.size(); ++frame) {
        Detached detached = read_detached(context.folder, frame);
        if (detached.volume > main.volume) main = std::move(detached);
    }
    if (main.icebergs.empty()) return {};
    const io::Members members = read_members(context.folder, main.frame);
    std::vector<std::uint8_t> came_off(members.given, 0);
    for (const std::uint32_t iceberg : main.icebergs) came_off[iceberg] = 1;
    std::vector<analysis::Side> sides(ice.id.size(), analysis::Side::neither);
    for (std::size_t i = 0, p = 0; i < members.particle.size(); ++i) {
        while (p < ice.id.size() && ice.id[p] < members.particle[i]) ++p;
        if (p == ice.id.size()) break;
        if (ice.id[p] != members.particle[i]) continue;
        if (came_off[members.iceberg[i]]) sides[p] = analysis::Side::iceberg;
        if (members.iceberg[i] == analysis::glacier_id) sides[p] = analysis::Side::rear;
    }
    return {.frame = static_cast<double>(main.frame),
            .time_before = frames.times[main.frame - 1],
            .icebergs = static_cast<double>(main.icebergs.size()),
            .largest = static_cast<double>(main.icebergs.front()),
            .calving = analysis::measure_calving(ice.at_rest(), sides, frames.times[main.frame],
                                                 calving_settings(context.scene))};
}

// A column of a table of one row and the number that it holds, in the order of the columns.
template <class Record>
struct Column {
    const char* name;
    double& (*value)(Record&);
};

constexpr std::array first_columns{
    Column<FirstIceberg>{"time", [](FirstIceberg& f) -> double& { return f.calving.time; }},
    Column<FirstIceberg>{"length", [](FirstIceberg& f) -> double& { return f.calving.length; }},
    Column<FirstIceberg>{"length_top", [](FirstIceberg& f) -> double& { return f.calving.length_top; }},
    Column<FirstIceberg>{"length_middle", [](FirstIceberg& f) -> double& { return f.calving.length_middle; }},
    Column<FirstIceberg>{"length_bottom", [](FirstIceberg& f) -> double& { return f.calving.length_bottom; }},
    Column<FirstIceberg>{"height", [](FirstIceberg& f) -> double& { return f.calving.height; }},
    Column<FirstIceberg>{"volume", [](FirstIceberg& f) -> double& { return f.calving.volume; }},
    Column<FirstIceberg>{"plane_angle", [](FirstIceberg& f) -> double& { return f.calving.plane_angle; }},
    Column<FirstIceberg>{"plane_misfit", [](FirstIceberg& f) -> double& { return f.calving.plane_misfit; }},
    Column<FirstIceberg>{"foot_angle", [](FirstIceberg& f) -> double& { return f.calving.foot_angle; }},
    Column<FirstIceberg>{"start_height", [](FirstIceberg& f) -> double& { return f.calving.start_height; }},
    Column<FirstIceberg>{"start_time", [](FirstIceberg& f) -> double& { return f.calving.start_time; }},
    Column<FirstIceberg>{"crack_time", [](FirstIceberg& f) -> double& { return f.crack.time; }},
    Column<FirstIceberg>{"crack_start_height",
                         [](FirstIceberg& f) -> double& { return f.crack.start_height; }},
    Column<FirstIceberg>{"crack_start_time", [](FirstIceberg& f) -> double& { return f.crack.start_time; }},
    Column<FirstIceberg>{"crack_position", [](FirstIceberg& f) -> double& { return f.crack.position; }},
    Column<FirstIceberg>{"failed_share", [](FirstIceberg& f) -> double& { return f.failed_share; }},
    Column<FirstIceberg>{"ice_height", [](FirstIceberg& f) -> double& { return f.ice_height; }},
    Column<FirstIceberg>{"end_time", [](FirstIceberg& f) -> double& { return f.end_time; }},
};

constexpr std::array event_columns{
    Column<MainEvent>{"time", [](MainEvent& e) -> double& { return e.calving.time; }},
    Column<MainEvent>{"time_before", [](MainEvent& e) -> double& { return e.time_before; }},
    Column<MainEvent>{"frame", [](MainEvent& e) -> double& { return e.frame; }},
    Column<MainEvent>{"icebergs", [](MainEvent& e) -> double& { return e.icebergs; }},
    Column<MainEvent>{"largest", [](MainEvent& e) -> double& { return e.largest; }},
    Column<MainEvent>{"volume", [](MainEvent& e) -> double& { return e.calving.volume; }},
    Column<MainEvent>{"failed_width", [](MainEvent& e) -> double& { return e.calving.length; }},
    Column<MainEvent>{"failed_width_top", [](MainEvent& e) -> double& { return e.calving.length_top; }},
    Column<MainEvent>{"failed_width_middle", [](MainEvent& e) -> double& { return e.calving.length_middle; }},
    Column<MainEvent>{"failed_width_bottom", [](MainEvent& e) -> double& { return e.calving.length_bottom; }},
    Column<MainEvent>{"height", [](MainEvent& e) -> double& { return e.calving.height; }},
    Column<MainEvent>{"plane_angle", [](MainEvent& e) -> double& { return e.calving.plane_angle; }},
    Column<MainEvent>{"plane_misfit", [](MainEvent& e) -> double& { return e.calving.plane_misfit; }},
    Column<MainEvent>{"foot_angle", [](MainEvent& e) -> double& { return e.calving.foot_angle; }},
    Column<MainEvent>{"start_height", [](MainEvent& e) -> double& { return e.calving.start_height; }},
    Column<MainEvent>{"start_time", [](MainEvent& e) -> double& { return e.calving.start_time; }},
};

// `more` are columns that follow from the others and are not read back.
template <class Record, std::size_t count>
void write_row(const std::filesystem::path& path, Record record,
               const std::array<Column<Record>, count>& columns,
               const std::vector<std::pair<std::string, double>>& more, const Provenance& provenance) {
    std::vector<std::string> names;
    std::vector<double> values;
    for (const auto& column : columns) {
        names.push_back(column.name);
        values.push_back(column.value(record));
    }
    for (const auto& [name, value] : more) {
        names.push_back(name);
        values.push_back(value);
    }
    io::TableWriter table(path, provenance, names);
    table.append(values);
    table.finish();
}

template <class Record, std::size_t count>
std::optional<Record> read_row(const std::filesystem::path& path,
                               const std::array<Column<Record>, count>& columns) {
    if (!std::filesystem::exists(path)) return {};
    const io::Table table = io::read_table(path);
    Record record;
    for (const auto& column : columns) {
        const auto& values = io::require_column(table, column.name, path);
        if (!values.empty()) column.value(record) = values.front();
    }
    return record;
}

std::string percent(double share) { return io::format_fixed(100.0 * share, 1) + " %"; }

std::string place_text(double length) {
    return std::isnan(length) ? "nowhere" : io::format_fixed(length, 1) + " m";
}

// "at the top", "from the bottom", "inside", "from inside".
std::string start_text(analysis::CrackStart start, const std::string& preposition) {
    if (start == analysis::CrackStart::inside) return preposition == "from" ? "from inside" : "inside";
    return preposition + (start == analysis::CrackStart::top ? " the top" : " the bottom");
}

std::string crack_text(const analysis::FirstCrack& crack, double height) {
    if (std::isnan(crack.time)) return "no crack formed\n";
    return "first crack: " + start_text(crack.start(), "from") + ", " + io::format_fixed(crack.position, 0) +
           " m (" + io::format_fixed(crack.position / height, 2) + " H) behind the front, at " +
           io::format_fixed(crack.start_time, 1) + " s\n";
}

std::string calving_text(const analysis::Calving& calving, int dimension) {
    std::string text = "first iceberg: came off at " + io::format_fixed(calving.time, 2) + " s, " +
                       volume_text(calving.volume, dimension);
    if (std::isnan(calving.length)) return text + ", from above or below the rest\n";
    return text + ", " + io::format_fixed(calving.length, 1) + " m long, " +
           io::format_fixed(calving.length / calving.height, 3) + " of its height of " +
           io::format_fixed(calving.height, 1) + " m\nits crack: began " + start_text(calving.start(), "at") +
           " at " + io::format_fixed(calving.start_time, 2) + " s; behind the front by " +
           place_text(calving.length_top) + " at the top, " + place_text(calving.length_middle) +
           " halfway, " + place_text(calving.length_bottom) + " at the bottom\n";
}

}  // namespace

std::string volume_text(double volume, int dimension) {
    return io::format_fixed(volume, 0) + (dimension == 2 ? " m² per m of width" : " m³");
}

FrameProduct first_iceberg_product(const StageContext& context, const Frames& frames) {
    constexpr std::array<std::string_view, 4> keys{"postprocess.iceberg_damage", "postprocess.iceberg_reach",
                                                   "postprocess.iceberg_volume", "postprocess.iceberg_share"};
    const bool breaks = context.scene.has("fracture");
    return {
        .name = "first_iceberg",
        .settings = scene::values_of(context.scene, keys),
        .files =
            [&frames, breaks, any = context.scene.has("ice")](std::size_t frame) {
                std::vector<std::string> names;
                if (!any || frame + 1 != frames.files.size()) return names;
                if (breaks) names.push_back(first_file);
                names.push_back(event_file);
                return names;
            },
        .make =
            [&context, &frames, breaks](std::size_t, const io::Snapshot& last, const Provenance& provenance) {
                const scene::Scene& scene = context.scene;
                Ice ice = read_ice(read_frame(frames, 0, scene), read_members(context.folder, 0));
                add_failure_times(last, ice);
                const double density = scene.ice.model.density;
                if (breaks && !ice.failure_time.empty()) {
                    const FirstIceberg first = find_first(ice, last.time, scene);
                    const analysis::Calving& c = first.calving;
                    write_row(context.folder / first_file, first, first_columns,
                              {{"length_ratio", c.length / c.height}, {"mass", density * c.volume}},
                              provenance);
                }
                const MainEvent event = find_main_event(ice, frames, context);
                write_row(context.folder / event_file, event, event_columns,
                          {{"mass", density * event.calving.volume}}, provenance);
            },
        .follows = true};
}

std::optional<FirstIceberg> read_first_iceberg(const std::filesystem::path& folder) {
    return read_row(folder / first_file, first_columns);
}

std::optional<MainEvent> read_main_event(const std::filesystem::path& folder) {
    return read_row(folder / event_file, event_columns);
}

std::string describe(const FirstIceberg& first, int dimension) {
    const std::string crack = crack_text(first.crack, first.ice_height);
    if (!std::isnan(first.calving.time)) return crack + calving_text(first.calving, dimension);
    return crack + "no iceberg came off: " + percent(first.failed_share) + " of the ice failed\n";
}

std::string describe(const MainEvent& event, int dimension) {
    if (std::isnan(event.frame)) return "main event: none, nothing came off the glacier\n";
    const analysis::Calving& c = event.calving;
    const auto number = [](double value, int decimals) {
        return std::isnan(value) ? std::string("unknown") : io::format_fixed(value, decimals);
    };
    return "main event: between " + number(event.time_before, 2) + " and " + number(c.time, 2) + " s, " +
           volume_text(c.volume, dimension) + " in " + number(event.icebergs, 0) +
           (event.icebergs == 1.0 ? " iceberg" : " icebergs") + "; failed width " + place_text(c.length) +
           ", at the top " + place_text(c.length_top) + "; failure plane " + number(c.plane_angle, 0) +
           "° by fit, " + number(c.foot_angle, 0) + "° from the front's foot\n";
}

}  // namespace tidewater::postprocess
