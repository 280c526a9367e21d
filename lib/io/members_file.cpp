#include "io/members_file.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <span>

#include "core/files.h"
#include "io/hdf5_file.h"

namespace tidewater::io {

void write_members(const std::filesystem::path& path, const Members& members, const Provenance& provenance) {
    assert(members.particle.size() == members.iceberg.size());
    PartFile part(path);
    Hdf5Writer file(part.part_path());
    file.attribute("/", "format", "tidewater-members");
    file.attribute("/", "format_version", std::array{members_format_version});
    file.attribute("/", "time", members.time);
    file.attribute("/", "given", std::array{std::int64_t{members.given}});
    for (const auto& [name, text] : provenance_fields(provenance)) file.attribute("/", name, text);
    file.array<std::uint32_t>("/particle", members.particle, 0, Packing::deflate);
    file.array<std::uint32_t>("/iceberg", members.iceberg, 0, Packing::deflate);
    file.array<double>("/front", members.front);
    file.array<std::int64_t>("/front_row", std::array{members.front_row});
    file.close();
    part.commit();
}

Members read_members(const std::filesystem::path& path) {
    const Hdf5Reader file(path, "remove it and run tidewater-postprocess again");
    file.require_format("members", members_format_version);
    Members members{.time = file.number("/", "time"),
                    .given = static_cast<std::uint32_t>(file.integer("/", "given")),
                    .particle = file.array<std::uint32_t>("/particle"),
                    .iceberg = file.array<std::uint32_t>("/iceberg"),
                    .front = file.array<double>("/front"),
                    .front_row = 0};
    const auto row = file.array<std::int64_t>("/front_row");
    if (row.size() != 1) file.fail("front_row is no single number");
    members.front_row = row.front();
    if (members.particle.size() != members.iceberg.size())
        file.fail("there is not one iceberg for each particle");
    const auto beyond = [&](std::uint32_t iceberg) { return iceberg >= members.given; };
    if (std::ranges::adjacent_find(members.particle, std::greater_equal()) != members.particle.end() ||
        std::ranges::any_of(members.iceberg, beyond))
        file.fail("its particles do not rise or are in icebergs that were not given");
    return members;
}

}  // namespace tidewater::io
