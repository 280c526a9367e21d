#include "iceberg_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "analysis/calving_rate.h"
#include "analysis/iceberg_track.h"
#include "break_records.h"
#include "frame_pass.h"
#include "io/table.h"
#include "io/text.h"

namespace tidewater::postprocess {
namespace {

using Kind = analysis::IcebergEvent::Kind;

constexpr double default_window = 0.1;  // of the frames' time

// A table that knows where it is from.
struct FrameTable {
    std::filesystem::path path;
    io::Table table;

    FrameTable(const StageContext& context, const char* product, std::size_t frame)
        : path(context.folder / frame_file(product, frame)), table(io::read_table(path)) {}
    const std::vector<double>& operator[](const char* column) const {
        return io::require_column(table, column, path);
    }
    std::vector<double> row(std::size_t r) const {
        std::vector<double> values;
        for (const auto& column : table.values) values.push_back(column[r]);
        return values;
    }
};

// Adds a frame's rows, and to each story what they tell of it.
void add_rows(const FrameTable& frame, IcebergTables& tables,
              std::map<std::uint32_t, IcebergStory>& stories) {
    tables.columns = frame.table.columns;
    for (std::size_t r = 0; r < frame.table.row_count(); ++r) {
        const auto iceberg = static_cast<std::uint32_t>(frame["iceberg"][r]);
        IcebergStory& story = stories[iceberg];
        story.iceberg = iceberg;
        if (story.rows++ == 0) story.first_row = tables.rows.size();
        story.last_row = tables.rows.size();
        const double speed =
            std::hypot(frame["velocity_x"][r], frame["velocity_y"][r], frame["velocity_z"][r]);
        const double rotation =
            std::hypot(frame["rotation_x"][r], frame["rotation_y"][r], frame["rotation_z"][r]);
        story.greatest_speed = std::max(story.greatest_speed, speed);
        story.greatest_rotation = std::max(story.greatest_rotation, rotation);
        tables.rows.push_back(
            {frame["time"][r], iceberg, frame["volume"][r], frame["area"][r], frame.row(r)});
    }
}

// What a split, a merger or an end tells of an iceberg; of the first frame nothing has come off yet.
void add_event(const FrameTable& events, std::size_t r, bool first,
               std::map<std::uint32_t, IcebergStory>& stories, double& calved, double& returned) {
    IcebergStory& story = stories[static_cast<std::uint32_t>(events["iceberg"][r])];
    const auto kind = static_cast<Kind>(static_cast<int>(events["kind"][r]));
    const double other = events["other"][r], volume = events["volume"][r];
    const bool of_glacier = other == analysis::glacier_id;
    if (kind == Kind::split) {
        story.parent = other;
        story.break_distance = events["break_distance"][r];
        if (first || std::isnan(other)) return;
        story.calved = of_glacier;
        story.detachment_time =
            of_glacier ? events["time"][r] : stories[static_cast<std::uint32_t>(other)].detachment_time;
        if (of_glacier) calved += volume;
        return;
    }
    story.end = kind == Kind::merge ? IcebergStory::End::merged : IcebergStory::End::gone;
    story.merged_into = other;
    if (of_glacier) returned += volume;
}

void add_calving(const FrameTable& glacier, double icebergs, double calved, double returned,
                 CalvingSeries& series) {
    series.time.push_back(glacier["time"].at(0));
    series.icebergs.push_back(icebergs);
    series.glacier.push_back(glacier["glacier_volume"].at(0));
    series.in_icebergs.push_back(glacier["iceberg_volume"].at(0));
    series.failed.push_back(glacier["failed_volume"].at(0));
    series.crumbs.push_back(glacier["crumb_volume"].at(0));
    series.front.push_back(glacier["front_position"].at(0));
    series.calved.push_back(calved);
    series.returned.push_back(returned);
    series.total.push_back((series.total.empty() ? 0.0 : series.total.back()) + calved - returned);
}

void find_rate(double window, CalvingSeries& series) {
    const double duration = series.time.empty() ? 0.0 : series.time.back() - series.time.front();
    series.window = window > 0.0 ? window : default_window * duration;
    std::vector<double> net;
    for (std::size_t i = 0; i < series.time.size(); ++i) net.push_back(series.calved[i] - series.returned[i]);
    series.rate = series.window > 0.0 ? analysis::calving_rate(series.time, net, series.window)
                                      : std::vector<double>(series.time.size(), 0.0);
}

void write_rows(const std::filesystem::path& path, const IcebergTables& tables,
                const Provenance& provenance) {
    io::TableWriter table(path, provenance, tables.columns);
    for (const IcebergRow& row : tables.rows) table.append(row.values);
    table.finish();
}

void write_summary(const std::filesystem::path& path, const IcebergTables& tables,
                   const Provenance& provenance) {
    std::vector<std::string> columns{"iceberg",    "parent",    "calved", "detachment_time", "break_distance",
                                     "first_time", "last_time", "merged", "merged_into",     "gone"};
    const std::vector<const char*> at_first{"volume", "mass", "length", "width",     "height", "x",
                                            "y",      "z",    "draft",  "freeboard", "area"};
    const std::vector<const char*> at_last{"volume", "mass",      "x",        "y",       "z",
                                           "draft",  "freeboard", "buoyancy", "grounded"};
    for (const char* name : at_first) columns.push_back(std::string("first_") + name);
    for (const char* name : at_last) columns.push_back(std::string("last_") + name);
    columns.insert(columns.end(), {"greatest_speed", "greatest_rotation"});
    io::TableWriter table(path, provenance, columns);
    for (const IcebergStory& s : tables.stories) {
        const IcebergRow &first = tables.rows[s.first_row], &last = tables.rows[s.last_row];
        std::vector<double> row{static_cast<double>(s.iceberg),
                                s.parent,
                                s.calved ? 1.0 : 0.0,
                                s.detachment_time,
                                s.break_distance,
                                first.time,
                                last.time,
                                s.end == IcebergStory::End::merged ? 1.0 : 0.0,
                                s.merged_into,
                                s.end == IcebergStory::End::gone ? 1.0 : 0.0};
        for (const char* name : at_first) row.push_back(first.values[tables.column(name)]);
        for (const char* name : at_last) row.push_back(last.values[tables.column(name)]);
        row.push_back(s.greatest_speed);
        row.push_back(s.greatest_rotation);
        table.append(row);
    }
    table.finish();
}

void write_events(const std::filesystem::path& path, const StageContext& context, const Frames& frames) {
    static constexpr std::array kinds{"split", "merge", "gone"};
    io::TableWriter table(path, context.provenance,
                          {"time", "kind", "iceberg", "other", "volume", "break_distance"});
    for (std::size_t frame = 0; frame < frames.files.size(); ++frame) {
        const FrameTable events(context, "iceberg_events", frame);
        for (std::size_t r = 0; r < events.table.row_count(); ++r) {
            std::vector<std::string> cells;
            for (const double value : events.row(r)) cells.push_back(io::format_number(value));
            cells[1] = kinds.at(static_cast<std::size_t>(events["kind"][r]));
            table.append_cells(cells);
        }
    }
    table.finish();
}

void write_calving(const std::filesystem::path& path, const CalvingSeries& s, double density,
                   const Provenance& provenance) {
    io::TableWriter table(
        path, provenance,
        {"time", "icebergs", "glacier_volume", "iceberg_volume", "failed_volume", "crumb_volume", "calved",
         "returned", "calved_total", "calved_mass", "rate", "front_position"});
    for (std::size_t i = 0; i < s.time.size(); ++i) {
        table.append(std::array{s.time[i], s.icebergs[i], s.glacier[i], s.in_icebergs[i], s.failed[i],
                                s.crumbs[i], s.calved[i], s.returned[i], s.total[i], density * s.total[i],
                                s.rate[i], s.front[i]});
    }
    table.finish();
}

}  // namespace

IcebergTables gather_icebergs(const StageContext& context, const Frames& frames) {
    IcebergTables tables;
    std::map<std::uint32_t, IcebergStory> stories;
    for (std::size_t frame = 0; frame < frames.files.size(); ++frame) {
        const FrameTable events(context, "iceberg_events", frame);
        double calved = 0.0, returned = 0.0;
        for (std::size_t r = 0; r < events.table.row_count(); ++r)
            add_event(events, r, frame == 0, stories, calved, returned);
        const std::size_t before = tables.rows.size();
        add_rows(FrameTable(context, "icebergs", frame), tables, stories);
        add_calving(FrameTable(context, "glacier", frame), static_cast<double>(tables.rows.size() - before),
                    calved, returned, tables.calving);
    }
    for (const auto& [iceberg, story] : stories) {
        if (story.rows > 0) tables.stories.push_back(story);
    }
    find_rate(context.scene.postprocess.calving_window, tables.calving);
    return tables;
}

void write_icebergs(const StageContext& context, const Frames& frames, const IcebergTables& tables) {
    const auto& folder = context.folder;
    write_rows(folder / "icebergs.csv", tables, context.provenance);
    write_summary(folder / "iceberg_summary.csv", tables, context.provenance);
    write_events(folder / "iceberg_events.csv", context, frames);
    write_calving(folder / "calving.csv", tables.calving, context.scene.ice.model.density,
                  context.provenance);
}

std::string describe(const IcebergTables& tables, int dimension) {
    const CalvingSeries& c = tables.calving;
    if (c.time.empty()) return {};
    const auto calved = std::ranges::count_if(tables.stories, &IcebergStory::calved);
    return "icebergs at " + io::format_fixed(c.time.back(), 2) +
           " s: " + io::format_fixed(c.icebergs.back(), 0) + ", " +
           volume_text(c.in_icebergs.back(), dimension) +
           "; came off the glacier: " + std::to_string(calved) + ", " +
           volume_text(c.total.back(), dimension) + " less what grew to it again\n";
}

}  // namespace tidewater::postprocess
