#include "io/vdb.h"

#include <openvdb/io/Stream.h>

#include <cstring>
#include <sstream>
#include <string>

#include "core/error.h"
#include "core/files.h"
#include "core/hash.h"

namespace tidewater::io {
namespace {

constexpr const char* format_key = "tidewater_format";

// OpenVDB's header: 8 bytes of magic number, three 4-byte versions, 1 flag; then the UUID as 36 characters.
constexpr std::size_t uuid_begin = 21, uuid_size = 36;
constexpr char magic[4] = {' ', 'B', 'D', 'V'};

std::string content_uuid(std::string bytes) {
    std::fill_n(bytes.begin() + uuid_begin, uuid_size, '0');
    const std::string first = hash_hex(hash_text(bytes));
    const std::string second = hash_hex(hash_text(first));
    return first.substr(0, 8) + '-' + first.substr(8, 4) + '-' + first.substr(12, 4) + '-' +
           second.substr(0, 4) + '-' + second.substr(4, 12);
}

bool has_header(const std::string& bytes) {
    return bytes.size() >= uuid_begin + uuid_size && std::memcmp(bytes.data(), magic, sizeof magic) == 0;
}

void check_bytes(const std::filesystem::path& path) {
    const std::string bytes = read_text(path);
    const std::string remedy = "; run tidewater-geometry again";
    if (!has_header(bytes)) throw InputError(path.string() + ": not an OpenVDB file" + remedy);
    if (bytes.find(format_key) == std::string::npos) {
        throw InputError(path.string() + ": an OpenVDB file, but not one of tidewater-geometry" + remedy);
    }
    if (bytes.compare(uuid_begin, uuid_size, content_uuid(bytes)) != 0) {
        throw InputError(path.string() + ": truncated or damaged (" + std::to_string(bytes.size()) +
                         " bytes)" + remedy);
    }
}

}  // namespace

void write_level_sets(const std::filesystem::path& path, const std::vector<openvdb::FloatGrid::Ptr>& grids,
                      const Provenance& provenance) {
    openvdb::initialize();
    openvdb::MetaMap metadata;
    metadata.insertMeta(format_key, openvdb::Int32Metadata(level_set_format));
    for (const auto& [name, text] : provenance_fields(provenance)) {
        metadata.insertMeta(name, openvdb::StringMetadata(text));
    }
    // In memory first: OpenVDB does not notice when a disk fills up.
    std::ostringstream stream(std::ios::binary);
    openvdb::io::Stream(stream).write(openvdb::GridCPtrVec(grids.begin(), grids.end()), metadata);
    std::string bytes = stream.str();
    if (!has_header(bytes)) throw OutputError(path.string() + ": OpenVDB wrote an unknown header");
    bytes.replace(uuid_begin, uuid_size, content_uuid(bytes));
    write_text(path, bytes);
}

std::vector<openvdb::FloatGrid::Ptr> read_level_sets(const std::filesystem::path& path) {
    openvdb::initialize();
    check_bytes(path);
    std::vector<openvdb::FloatGrid::Ptr> level_sets;
    try {
        openvdb::io::File file(path.string());
        file.open(false);  // no delayed loading: the whole file is read here or not at all
        const auto format = file.getMetadata()->getMetadata<openvdb::Int32Metadata>(format_key);
        if (!format || format->value() > level_set_format) {
            throw InputError(path.string() +
                             ": written by a newer tidewater; update this one, or run its "
                             "tidewater-geometry again");
        }
        const openvdb::GridPtrVecPtr grids = file.getGrids();
        for (const auto& grid : *grids) {
            if (auto level_set = openvdb::gridPtrCast<openvdb::FloatGrid>(grid))
                level_sets.push_back(level_set);
        }
    } catch (const openvdb::Exception& error) {
        throw InputError(path.string() + ": cannot be read: " + error.what() +
                         "; run tidewater-geometry again");
    }
    return level_sets;
}

}  // namespace tidewater::io
