#include "io/particle_files.h"

#include <vtkPoints.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <type_traits>

#include "core/error.h"
#include "core/parallel.h"
#include "io/hdf5_file.h"
#include "io/point_columns.h"
#include "io/text.h"

namespace tidewater::io {
namespace {

constexpr std::size_t grain = 65536;

template <class T>
void fill(const std::vector<Component>& components, std::size_t count, std::vector<T>& values) {
    const std::size_t width = components.size();
    values.resize(width * count);
    parallel_for(
        count,
        [&](std::size_t p) {
            for (std::size_t c = 0; c < width; ++c) values[width * p + c] = static_cast<T>(components[c](p));
        },
        grain);
}

void require_numbers(const PointSource& source, const std::string& column, const std::vector<float>& values,
                     bool has_gaps) {
    const auto bad = std::ranges::count_if(
        values, [&](float value) { return !std::isfinite(value) && !(has_gaps && std::isnan(value)); });
    if (bad > 0)
        source.fail("column " + column + " has " + std::to_string(bad) + " values that are not numbers");
}

void read_points(const PointSource& source, Snapshot& snapshot) {
    vtkPoints* points = source.cloud.data->GetPoints();
    if (points == nullptr) return;
    const ParticleImport& import = source.import;
    std::vector<Component> file;
    for (const int axis : {0, 1, 2}) {
        file.push_back({.array = points->GetData(),
                        .component = axis,
                        .shift = -import.origin[static_cast<std::size_t>(axis)]});
    }
    if (import.dimension == 2) {
        const int across = import.y_up ? 2 : 1;
        const auto* range = points->GetData()->GetRange(across);
        if (range[1] - range[0] > 1e-6 * (1.0 + std::abs(range[0]) + std::abs(range[1])) &&
            source.count() > 0) {
            source.fail(std::string("its points reach from ") + (import.y_up ? "z" : "y") + " = " +
                        format_number(range[0]) + " to " + format_number(range[1]) +
                        ", but the scene is in 2D; if that axis is up, pass --up " +
                        (import.y_up ? "z" : "y"));
        }
    }
    fill(turn(file, import), source.count(), snapshot.points);
    require_numbers(source, "points", snapshot.points, false);
}

std::uint8_t to_material(const PointSource& source, double number) {
    const auto& numbers = source.import.materials;
    if (numbers.empty() && (number == 0.0 || number == 1.0 || number == 2.0))
        return static_cast<std::uint8_t>(number);
    if (number == std::floor(number) && std::abs(number) < 1e9) {
        const auto found = numbers.find(static_cast<int>(number));
        if (found != numbers.end()) return static_cast<std::uint8_t>(found->second);
    }
    source.fail("column material has the number " + format_number(number) +
                ", which stands for no material; name all by --materials water=NUMBER,ice=NUMBER,...");
}

// Numbers as a file holds them, as the column's type.
void convert(const PointSource& source, const std::vector<Component>& components,
             std::vector<std::uint8_t>& material) {
    material.resize(source.count());
    const bool named = components[0].array == nullptr;  // then it is ours, whatever the files' numbers are
    for (std::size_t p = 0; p < material.size(); ++p) {
        const double number = components[0](p);
        material[p] = named ? static_cast<std::uint8_t>(number) : to_material(source, number);
    }
}

void convert(const PointSource& source, const std::vector<Component>& components,
             std::vector<std::uint32_t>& id) {
    id.resize(source.count());
    for (std::size_t p = 0; p < id.size(); ++p) {
        const double number = components[0](p);
        if (!(number >= 0.0 && number <= std::numeric_limits<std::uint32_t>::max()) ||
            number != std::floor(number)) {
            source.fail("column id has the number " + format_number(number) +
                        "; whole ones from 0 to 4294967295 are needed");
        }
        id[p] = static_cast<std::uint32_t>(number);
    }
}

void convert(const PointSource& source, const std::vector<Component>& components,
             std::vector<float>& values) {
    fill(components, source.count(), values);
}

// What is in the place of a column that the file has not and the map does not name.
struct Substitute {
    Component component;
    std::string note;
};

std::optional<Substitute> substitute(const ParticleImport& import, const std::string& column) {
    const std::string start = "no " + column + " in the files: ";
    const std::string end = "; --map " + column + "=ARRAY names one";
    if (column == "pressure")
        return Substitute{{.shift = std::numeric_limits<double>::quiet_NaN()}, start + "left out" + end};
    if (column == "volume" && import.volume > 0.0) {
        return Substitute{{.shift = import.volume},
                          start + format_digits(import.volume, 6) + (import.dimension == 2 ? " m²" : " m³") +
                              " for every particle, from the scene's cell_size and per_axis" + end};
    }
    if (column == "material" && import.material) {
        return Substitute{{.shift = static_cast<double>(*import.material)},
                          start + "all is " + std::string(material_name(*import.material)) + end};
    }
    if (column == "id")
        return Substitute{{.row = true}, start + "the row, so rows must keep their particle" + end};
    return {};
}

template <class T>
bool left_out(const PointSource& source, const SnapshotColumn<T>& column) {
    return !source.import.map.contains(column.name) && find_array(source, column.name) == nullptr;
}

// What the column is made of, as many as it has components.
template <class T>
std::vector<Component> components_for(const PointSource& source, const SnapshotColumn<T>& column,
                                      std::vector<std::string>& notes) {
    const std::string name = column.name;
    if (left_out(source, column)) {
        if (const auto instead = substitute(source.import, name)) {
            notes.push_back(instead->note);
            return {instead->component};
        }
    }
    std::vector<Component> components = column_components(source, name);
    const std::size_t found = components.size();
    if (column.components == 3) components = turn(std::move(components), source.import);
    if (components.size() != static_cast<std::size_t>(column.components)) {
        source.fail_with_arrays("column " + name + " needs " + std::to_string(column.components) +
                                " components, not " + std::to_string(found) +
                                (column.components == 3 ? "; name each, as --map " + name + "=u:v:w"
                                                        : "; name one, as --map " + name + "=ARRAY[0]"));
    }
    return components;
}

template <class T>
void read_column(const PointSource& source, const SnapshotColumn<T>& column, Snapshot& snapshot,
                 std::vector<std::string>& notes) {
    if (column.optional && left_out(source, column)) return;
    auto& values = snapshot.*column.values;
    convert(source, components_for(source, column, notes), values);
    const bool may_be_nan = column.has_gaps || left_out(source, column);
    if constexpr (std::is_same_v<T, float>) require_numbers(source, column.name, values, may_be_nan);
}

bool is_own_snapshot(const std::filesystem::path& path) {
    if (path.extension() != ".hdf" || !std::filesystem::exists(path)) return false;
    const Hdf5Reader file(path, "write it again, or copy it again");
    return file.has_attribute("/", "format") && file.text("/", "format") == "tidewater-snapshot";
}

std::set<std::string> wanted_arrays(const ColumnMap& map) {
    std::set<std::string> wanted;
    for_each_column([&](const auto& column) {
        for (const ArrayPart& part : column_source(map, column.name)) wanted.insert(part.array);
    });
    return wanted;
}

Snapshot read(const std::filesystem::path& path, const ParticleImport& import,
              std::vector<std::string>& notes) {
    const PointCloud cloud = read_point_cloud(path, wanted_arrays(import.map));
    const PointSource source{path, import, cloud};
    Snapshot snapshot;
    snapshot.dimension = import.dimension;
    snapshot.time = cloud.time;
    read_points(source, snapshot);
    for_each_column([&](const auto& column) { read_column(source, column, snapshot, notes); });
    return snapshot;
}

bool as_it_is(const ParticleImport& import) {
    return import.map.empty() && !import.y_up && import.origin == std::array<double, 3>{};
}

}  // namespace

Snapshot read_particle_file(const std::filesystem::path& path, const ParticleImport& import,
                            std::vector<std::string>* notes) {
    if (as_it_is(import) && is_own_snapshot(path)) return read_snapshot(path);
    std::vector<std::string> unread;
    return read(path, import, notes ? *notes : unread);
}

double read_particle_time(const std::filesystem::path& path) {
    return is_own_snapshot(path) ? read_snapshot_time(path) : read_point_cloud_time(path);
}

}  // namespace tidewater::io
