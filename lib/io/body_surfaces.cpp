#include "io/body_surfaces.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkContourTriangulator.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges2D.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/spline.h"
#include "io/text.h"
#include "io/vtk_file.h"

namespace tidewater::io {
namespace {

constexpr double volume_tolerance = 1e-3;  // of what a surface encloses
constexpr int width = 2;                   // of the spline, in spacings of the grid

// The spline's shares at the grid's points first … first + 6 along one axis.
struct Shares {
    int first;
    std::array<float, 3 * width + 1> of;
};

// `at` in spacings of the grid.
Shares shares(double at) {
    Shares result{static_cast<int>(std::ceil(at - 1.5 * width)), {}};
    for (std::size_t k = 0; k < result.of.size(); ++k) {
        const double from = result.first + static_cast<int>(k) - at;
        result.of[k] = static_cast<float>(quadratic_spline(from / width) / width);
    }
    return result;
}

// φ of one body on the points around it; x fastest, z slowest.
struct Field {
    std::array<int, 3> low{}, count{1, 1, 1};
    std::vector<float> share;
};

Field empty_field(const BodyParticles& particles, const Body& body) {
    Field field;
    std::size_t size = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (particles.dimension == 2 && axis == 1) continue;
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const std::size_t p : body.particles) {
            const double at = static_cast<double>(particles.points[3 * p + axis]) / particles.spacing;
            least = std::min(least, at);
            most = std::max(most, at);
        }
        field.low[axis] = static_cast<int>(std::floor(least)) - 2 * width;
        field.count[axis] = static_cast<int>(std::ceil(most)) + 2 * width + 1 - field.low[axis];
        size *= static_cast<std::size_t>(field.count[axis]);
    }
    field.share.assign(size, 0.0f);
    return field;
}

Field spread(const BodyParticles& particles, const Body& body) {
    Field field = empty_field(particles, body);
    const double s = particles.spacing, cell = particles.dimension == 2 ? s * s : s * s * s;
    const bool flat = particles.dimension == 2;
    for (const std::size_t p : body.particles) {
        const float* point = particles.points.data() + 3 * p;
        const auto volume = static_cast<float>(static_cast<double>(particles.volume[p]) / cell);
        const Shares x = shares(static_cast<double>(point[0]) / s);
        const Shares y = flat ? Shares{0, {1.0f}} : shares(static_cast<double>(point[1]) / s);
        const Shares z = shares(static_cast<double>(point[2]) / s);
        for (std::size_t k = 0; k < z.of.size(); ++k) {
            for (std::size_t j = 0; j < (flat ? 1 : y.of.size()); ++j) {
                const int row = (z.first + static_cast<int>(k) - field.low[2]) * field.count[1] + y.first +
                                static_cast<int>(j) - field.low[1];
                float* to = field.share.data() + static_cast<std::ptrdiff_t>(row) * field.count[0] + x.first -
                            field.low[0];
                const float of_row = volume * z.of[k] * y.of[j];
                for (std::size_t i = 0; i < x.of.size(); ++i) to[i] += of_row * x.of[i];
            }
        }
    }
    return field;
}

// The field as an image, in a plane of x and y if it is flat: the filters for planes know no other.
vtkNew<vtkImageData> image(Field& field, double spacing, bool flat) {
    vtkNew<vtkImageData> data;
    const std::array<std::size_t, 3> axes =
        flat ? std::array<std::size_t, 3>{0, 2, 1} : std::array<std::size_t, 3>{0, 1, 2};
    data->SetDimensions(field.count[axes[0]], field.count[axes[1]], field.count[axes[2]]);
    data->SetSpacing(spacing, spacing, spacing);
    data->SetOrigin(field.low[axes[0]] * spacing, field.low[axes[1]] * spacing,
                    flat ? 0.0 : field.low[2] * spacing);
    vtkNew<vtkFloatArray> share;
    share->SetArray(field.share.data(), static_cast<vtkIdType>(field.share.size()), 1);
    data->GetPointData()->SetScalars(share);
    return data;
}

// The triangles around or, in 2D, within φ = level.
vtkSmartPointer<vtkPolyData> surface_at(double level, vtkImageData* share, bool flat) {
    if (!flat) {
        vtkNew<vtkFlyingEdges3D> edges;
        edges->SetInputData(share);
        edges->SetValue(0, level);
        edges->ComputeNormalsOff();
        edges->ComputeScalarsOff();
        edges->Update();
        return edges->GetOutput();
    }
    vtkNew<vtkFlyingEdges2D> edges;
    edges->SetInputData(share);
    edges->SetValue(0, level);
    edges->ComputeScalarsOff();
    vtkNew<vtkContourTriangulator> area;
    area->SetInputConnection(edges->GetOutputPort());
    area->Update();
    vtkSmartPointer<vtkPolyData> surface = area->GetOutput();
    for (vtkIdType point = 0; point < surface->GetNumberOfPoints(); ++point) {
        const double* at = surface->GetPoint(point);
        surface->GetPoints()->SetPoint(point, at[0], 0.0, at[1]);
    }
    return surface;
}

// What triangles around a body enclose (divergence theorem) or, in 2D, their area.
double enclosed(vtkPolyData* surface, bool flat) {
    double sum = 0.0;
    const auto corners = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
    for (corners->GoToFirstCell(); !corners->IsDoneWithTraversal(); corners->GoToNextCell()) {
        vtkIdType count = 0;
        const vtkIdType* of = nullptr;
        corners->GetCurrentCell(count, of);
        Eigen::Vector3d a, b, c;
        surface->GetPoint(of[0], a.data());
        surface->GetPoint(of[1], b.data());
        surface->GetPoint(of[2], c.data());
        sum += flat ? 0.5 * (b - a).cross(c - a).norm() : a.dot(b.cross(c)) / 6.0;
    }
    return sum;
}

// The surface on the level that encloses `volume`: by false position between a level that encloses more and
// one that encloses less, halving where that stays on one side.
vtkSmartPointer<vtkPolyData> surface_of(Field& field, double spacing, bool flat, double volume) {
    const auto share = image(field, spacing, flat);
    double low = 0.0, high = static_cast<double>(*std::ranges::max_element(field.share));
    double more = std::numeric_limits<double>::infinity(), less = 0.0;  // what these enclose
    double level = std::min(0.5, 0.5 * high);
    for (int tries = 1;; ++tries) {
        const auto surface = surface_at(level, share, flat);
        const double found = enclosed(surface, flat);
        if (std::abs(found - volume) <= volume_tolerance * volume || tries == 20) return surface;
        const bool too_much = found > volume;
        (too_much ? low : high) = level;
        (too_much ? more : less) = found;
        const bool halve = !std::isfinite(more) || tries % 3 == 0;
        level = low + (high - low) * (halve ? 0.5 : (more - volume) / (more - less));
    }
}

template <class Array, class T>
void add_constant(const char* name, T value, vtkPolyData* data) {
    vtkNew<Array> array;
    array->SetName(name);
    array->SetNumberOfValues(data->GetNumberOfCells());
    array->FillValue(value);
    data->GetCellData()->AddArray(array);
}

double volume_of(const BodyParticles& particles, const Body& body) {
    double sum = 0.0;
    for (const std::size_t p : body.particles) sum += static_cast<double>(particles.volume[p]);
    return sum;
}

}  // namespace

std::string body_surfaces_name(std::size_t frame) { return numbered_name("iceberg_surfaces", frame, "vtp"); }

void write_body_surfaces(const std::filesystem::path& path, const BodyParticles& particles,
                         std::span<const Body> bodies, const Provenance& provenance) {
    vtkNew<vtkAppendPolyData> all;
    vtkNew<vtkPolyData> none;
    all->AddInputData(none);
    for (const Body& body : bodies) {
        if (body.particles.empty()) continue;
        Field field = spread(particles, body);
        const double volume = volume_of(particles, body);
        const auto surface = surface_of(field, particles.spacing, particles.dimension == 2, volume);
        add_constant<vtkTypeInt32Array>("iceberg", body.iceberg, surface);
        add_constant<vtkUnsignedCharArray>("material", body.material, surface);
        add_constant<vtkDoubleArray>("volume", volume, surface);
        all->AddInputData(surface);
    }
    all->Update();
    if (all->GetOutput()->GetPoints() == nullptr) all->GetOutput()->SetPoints(vtkNew<vtkPoints>());
    add_provenance(all->GetOutput(), "tidewater-body-surfaces", body_surfaces_format_version, provenance);
    write_vtk<vtkXMLPolyDataWriter>(path, all->GetOutput());
}

}  // namespace tidewater::io
