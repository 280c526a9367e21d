#include "io/snapshot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "core/error.h"
#include "core/files.h"
#include "io/hdf5_file.h"
#include "io/text.h"

namespace tidewater::io {
namespace {

constexpr std::uint8_t vtk_poly_vertex = 2;

std::string column_path(const char* name) { return std::string("/VTKHDF/PointData/") + name; }

void check_sizes(const Snapshot& snapshot) {
    for_each_column([&](const auto& column) {
        if (left_out(snapshot, column)) return;
        const std::size_t expected = snapshot.particle_count() * static_cast<std::size_t>(column.components);
        if ((snapshot.*column.values).size() != expected) {
            throw std::invalid_argument(std::string("write_snapshot: column ") + column.name +
                                        " does not have one entry per particle");
        }
    });
}

// One cell that holds all points, without which ParaView's surface view is empty.
void write_cell(Hdf5Writer& file, std::size_t particle_count) {
    const auto count = static_cast<std::int64_t>(particle_count);
    std::vector<std::int64_t> connectivity(particle_count);
    std::iota(connectivity.begin(), connectivity.end(), std::int64_t{0});
    file.array<std::int64_t>("/VTKHDF/Connectivity", connectivity, 0, Packing::deflate);
    file.array<std::int64_t>("/VTKHDF/Offsets", std::array{std::int64_t{0}, count});
    file.array<std::uint8_t>("/VTKHDF/Types", std::array{vtk_poly_vertex});
    file.array<std::int64_t>("/VTKHDF/NumberOfPoints", std::array{count});
    file.array<std::int64_t>("/VTKHDF/NumberOfCells", std::array{std::int64_t{1}});
    file.array<std::int64_t>("/VTKHDF/NumberOfConnectivityIds", std::array{count});
    file.group("/VTKHDF/CellData");
}

void write_header(Hdf5Writer& file, const Snapshot& snapshot, const Provenance& provenance) {
    file.attribute("/", "format", "tidewater-snapshot");
    file.attribute("/", "format_version", std::array{snapshot_format_version});
    file.attribute("/", "time", snapshot.time);
    file.attribute("/", "dimension", std::array<std::int64_t, 1>{snapshot.dimension});
    for (const auto& [name, text] : provenance_fields(provenance)) file.attribute("/", name, text);
}

Hdf5Reader open_snapshot(const std::filesystem::path& path) {
    Hdf5Reader file(path, "run tidewater-simulate again");
    file.require_format("snapshot", snapshot_format_version);
    return file;
}

// The number in "frame_0012.hdf"; nothing for a name that snapshot_name does not make.
std::optional<std::size_t> frame_number(const std::string& name) {
    constexpr std::string_view prefix = "frame_", suffix = ".hdf";
    if (name.size() <= prefix.size() + suffix.size()) return {};
    if (!name.starts_with(prefix) || !name.ends_with(suffix)) return {};
    const std::string digits = name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
    if (digits.find_first_not_of("0123456789") != std::string::npos || digits.size() > 18) return {};
    const std::size_t number = std::stoull(digits);
    return name == snapshot_name(number) ? std::optional(number) : std::nullopt;
}

}  // namespace

std::string snapshot_name(std::size_t frame) {
    return numbered_name("frame", frame, "hdf");
}

void write_snapshot(const std::filesystem::path& path, const Snapshot& snapshot,
                    const Provenance& provenance) {
    check_sizes(snapshot);
    PartFile part(path);
    Hdf5Writer file(part.part_path());
    write_header(file, snapshot, provenance);
    file.group("/VTKHDF");
    file.attribute("/VTKHDF", "Version", std::array<std::int64_t, 2>{1, 0});
    file.attribute("/VTKHDF", "Type", "UnstructuredGrid");
    file.array<float>("/VTKHDF/Points", snapshot.points, 3);
    write_cell(file, snapshot.particle_count());
    file.group("/VTKHDF/PointData");
    for_each_column([&](const auto& column) {
        if (left_out(snapshot, column)) return;
        const int components = column.components > 1 ? column.components : 0;
        file.array(column_path(column.name), std::span(snapshot.*column.values), components);
    });
    file.close();
    part.commit();
}

namespace {

void check_finite(const Hdf5Reader& file, const std::string& name, const std::vector<float>& values,
                  bool has_gaps = false) {
    const auto bad = std::count_if(values.begin(), values.end(), [&](float value) {
        return !std::isfinite(value) && !(has_gaps && std::isnan(value));
    });
    if (bad > 0) file.fail("array " + name + " has " + std::to_string(bad) + " values that are not numbers");
}

}  // namespace

Snapshot read_snapshot(const std::filesystem::path& path) {
    const Hdf5Reader file = open_snapshot(path);
    Snapshot snapshot;
    snapshot.time = file.number("/", "time");
    snapshot.dimension = static_cast<int>(file.integer("/", "dimension"));
    snapshot.points = file.array<float>("/VTKHDF/Points", 3);
    for_each_column([&](const auto& column) {
        const std::string name = column_path(column.name);
        if (column.optional && !file.has_array(name)) return;
        auto& values = snapshot.*column.values;
        using Value = typename std::remove_reference_t<decltype(values)>::value_type;
        values = file.array<Value>(name, column.components > 1 ? column.components : 0);
        if (values.size() != snapshot.particle_count() * static_cast<std::size_t>(column.components)) {
            file.fail("array " + name + " does not have one entry per particle");
        }
        if constexpr (std::is_floating_point_v<Value>) check_finite(file, name, values, column.has_gaps);
    });
    check_finite(file, "/VTKHDF/Points", snapshot.points);
    return snapshot;
}

double read_snapshot_time(const std::filesystem::path& path) {
    return open_snapshot(path).number("/", "time");
}

std::vector<std::filesystem::path> list_snapshots(const std::filesystem::path& folder) {
    std::vector<std::pair<std::size_t, std::filesystem::path>> found;
    if (std::filesystem::is_directory(folder)) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            if (const auto number = frame_number(entry.path().filename().string())) {
                found.emplace_back(*number, entry.path());
            }
        }
    }
    if (found.empty()) {
        throw InputError(folder.string() + ": there is no frame_NNNN.hdf; run tidewater-simulate first");
    }
    std::sort(found.begin(), found.end());
    std::vector<std::filesystem::path> paths;
    for (const auto& [number, path] : found) {
        if (number != paths.size()) {
            throw InputError(
                (folder / snapshot_name(paths.size())).string() +
                ": the file is missing, though later ones are there; run tidewater-simulate again");
        }
        paths.push_back(path);
    }
    return paths;
}

void write_series(const std::filesystem::path& folder, const std::vector<double>& frame_times) {
    std::string json = "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [\n";
    for (std::size_t frame = 0; frame < frame_times.size(); ++frame) {
        json += "    {\"name\": \"" + snapshot_name(frame) +
                "\", \"time\": " + format_number(frame_times[frame]) +
                (frame + 1 < frame_times.size() ? "},\n" : "}\n");
    }
    write_text(folder / "frame.hdf.series", json + "  ]\n}\n");
}

}  // namespace tidewater::io
