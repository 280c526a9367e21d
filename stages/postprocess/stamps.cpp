#include "stamps.h"

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/files.h"

namespace tidewater::postprocess {
namespace {

constexpr const char* journal_name = ".stamps";
constexpr std::size_t fingerprint_length = 16;
const std::string no_fingerprint(fingerprint_length, '-');  // of a file that was removed

void remove_file(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::remove(path, error);
    if (error) {
        throw OutputError(path.string() + ": cannot be removed: " + error.message() +
                          "; remove it or choose another folder with --run");
    }
}

}  // namespace

Stamps::Stamps(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::ifstream stream(folder_ / journal_name);
    for (std::string line; std::getline(stream, line) && !stream.eof();) {
        if (line.size() < fingerprint_length + 2 || line[fingerprint_length] != ' ') continue;
        fingerprints_[line.substr(fingerprint_length + 1)] = line.substr(0, fingerprint_length);
    }
    stream.close();
    rewrite();
}

bool Stamps::current(const std::string& name, const std::string& fingerprint) const {
    const auto found = fingerprints_.find(name);
    return found != fingerprints_.end() && found->second == fingerprint &&
           std::filesystem::exists(folder_ / name);
}

void Stamps::mark(const std::string& name, const std::string& fingerprint) {
    fingerprints_[name] = fingerprint;
    note(fingerprint, name);
}

void Stamps::note(const std::string& fingerprint, const std::string& name) {
    journal_ << fingerprint << ' ' << name << '\n' << std::flush;
    if (!journal_)
        throw OutputError((folder_ / journal_name).string() + ": writing failed; is the disk full?");
}

void Stamps::remove(const std::string& name) {
    remove_file(folder_ / name);
    remove_file(folder_ / (name + ".part"));
    if (fingerprints_.erase(name) > 0) note(no_fingerprint, name);
}

void Stamps::remove_unclaimed() {
    std::vector<std::string> names;
    for (const auto& [name, fingerprint] : fingerprints_) {
        if (!claimed_.contains(name)) names.push_back(name);
    }
    for (const std::string& name : names) remove(name);
}

void Stamps::rewrite() {
    std::vector<std::string> lines;
    std::erase_if(fingerprints_, [](const auto& each) { return each.second == no_fingerprint; });
    for (const auto& [name, fingerprint] : fingerprints_) lines.push_back(fingerprint + ' ' + name + '\n');
    std::ranges::sort(lines);
    std::string text;
    for (const std::string& line : lines) text += line;
    journal_.close();
    write_text(folder_ / journal_name, text);
    journal_.open(folder_ / journal_name, std::ios::app);
}

}  // namespace tidewater::postprocess
