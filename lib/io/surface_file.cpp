#include "io/surface_file.h"

#include <array>
#include <cassert>
#include <cstdio>

#include "core/files.h"
#include "io/hdf5_file.h"

namespace tidewater::io {

std::string surface_name(std::size_t frame) {
    char name[40];
    std::snprintf(name, sizeof name, "surface_%04zu.h5", frame);
    return name;
}

void write_surface(const std::filesystem::path& path, const Surface& surface, const Provenance& provenance) {
    assert(surface.bed.size() == surface.place_count() && surface.elevation.size() == surface.place_count());
    PartFile part(path);
    Hdf5Writer file(part.part_path());
    file.attribute("/", "format", "tidewater-surface");
    file.attribute("/", "format_version", std::array{surface_format_version});
    file.attribute("/", "time", surface.time);
    file.attribute("/", "still_level", surface.still_level);
    for (const auto& [name, text] : provenance_fields(provenance)) file.attribute("/", name, text);
    const auto along = static_cast<int>(surface.x.size());
    file.array<double>("/x", surface.x);
    file.array<double>("/y", surface.y);
    file.array<float>("/bed", surface.bed, along);
    file.array<float>("/eta", surface.elevation, along);
    file.close();
    part.commit();
}

Surface read_surface(const std::filesystem::path& path) {
    const Hdf5Reader file(path, "remove it and run tidewater-postprocess again");
    file.require_format("surface", surface_format_version);
    Surface surface{.time = file.number("/", "time"),
                    .still_level = file.number("/", "still_level"),
                    .x = file.array<double>("/x"),
                    .y = file.array<double>("/y"),
                    .bed = {},
                    .elevation = {}};
    const auto along = static_cast<int>(surface.x.size());
    surface.bed = file.array<float>("/bed", along);
    surface.elevation = file.array<float>("/eta", along);
    for (const auto* values : {&surface.bed, &surface.elevation}) {
        if (values->size() != surface.place_count()) file.fail("an array does not have one entry per place");
    }
    return surface;
}

}  // namespace tidewater::io
