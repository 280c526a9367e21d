#include "core/files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

#include "core/error.h"

namespace tidewater {
namespace {

std::filesystem::path folder_of(const std::filesystem::path& path) {
    const auto parent = path.parent_path();
    return parent.empty() ? std::filesystem::path(".") : parent;
}

std::string reason() { return std::strerror(errno); }

void sync(const std::filesystem::path& path, int flags) {
    const int descriptor = ::open(path.c_str(), flags);
    if (descriptor < 0) throw OutputError(path.string() + ": cannot be synced: " + reason());
    const bool synced = ::fsync(descriptor) == 0;
    const std::string why = synced ? "" : reason();
    ::close(descriptor);
    if (!synced)
        throw OutputError(path.string() + ": cannot be synced: " + why + "; free disk space and run again");
}

}  // namespace

PartFile::PartFile(std::filesystem::path final_path) : final_(std::move(final_path)), part_(final_) {
    part_ += ".part";
    std::ofstream probe(part_, std::ios::binary | std::ios::trunc);
    if (!probe) {
        throw OutputError(final_.string() + ": cannot be written: " + reason() +
                          "; choose a folder that you may write to with --run");
    }
}

PartFile::~PartFile() {
    std::error_code ignored;
    if (!committed_ && !kept_) std::filesystem::remove(part_, ignored);
}

void PartFile::commit() {
    sync(part_, O_RDONLY);
    if (std::rename(part_.c_str(), final_.c_str()) != 0) {
        throw OutputError(final_.string() + ": cannot be renamed from its .part: " + reason());
    }
    committed_ = true;
    sync(folder_of(final_), O_RDONLY | O_DIRECTORY);
}

void write_text(const std::filesystem::path& path, std::string_view text) {
    PartFile file(path);
    std::ofstream stream(file.part_path(), std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) throw OutputError(path.string() + ": writing failed: " + reason() + "; is the disk full?");
    file.commit();
}

std::string read_text(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream || std::filesystem::is_directory(path)) {
        throw InputError(path.string() + ": cannot be read; check the path");
    }
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void make_output_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        throw OutputError(folder.string() + ": cannot be created: " + error.message() +
                          "; choose a folder that you may write to with --run");
    }
    const PartFile probe(folder / "probe");
}

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    // A file system without locks is no reason to stop.
    if (descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        ::close(descriptor_);
        throw OutputError(folder.string() +
                          ": another run is writing here; wait for it, or choose another folder with --run");
    }
}

FolderLock::~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace tidewater
