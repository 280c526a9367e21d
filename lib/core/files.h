// Files that are whole or absent: written as "<name>.part", synced, then renamed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tidewater {

// Guards one output file. Write to part_path(), then commit(); if commit() is not reached the part is
// removed.
//     PartFile file("run/gauges.csv");
//     write(file.part_path());
//     file.commit();
class PartFile {
public:
    // Throws OutputError if the folder of final_path does not exist or cannot be written to.
    explicit PartFile(std::filesystem::path final_path);
    ~PartFile();
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    const std::filesystem::path& part_path() const { return part_; }

    // Syncs the part to disk, renames it to its final name and syncs the folder. Throws OutputError.
    void commit();

    // The part stays, under its own name, if commit() is not reached.
    void keep() { kept_ = true; }

private:
    std::filesystem::path final_;
    std::filesystem::path part_;
    bool committed_ = false;
    bool kept_ = false;
};

// Replaces path by text as a whole. Throws OutputError.
void write_text(const std::filesystem::path& path, std::string_view text);

// The whole file. Throws InputError if it cannot be read.
std::string read_text(const std::filesystem::path& path);

// Creates the folder and its parents, and checks that a file can be made there. Throws OutputError.
void make_output_folder(const std::filesystem::path& folder);

// Holds a folder for one process while it lives. Throws OutputError if another process holds it.
class FolderLock {
public:
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int descriptor_;
};

}  // namespace tidewater
