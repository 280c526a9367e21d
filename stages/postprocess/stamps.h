// What each file of a folder was made from, so that only what a change needs is made again.
//
// The folder's journal `.stamps` holds a line "FINGERPRINT NAME" for each file that was finished; of several
// lines for one name the last counts, dashes stand for a file that was removed, and a line that is cut short,
// by a power cut say, counts for nothing.
// A line is added after its file is whole under its final name. So whatever stops a stage, what has a current
// stamp is whole and need not be made again.
//
// Test: tests/pipeline/postprocess_rerun_test.sh
#pragma once

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <unordered_map>

namespace tidewater::postprocess {

// Names are relative to the folder. Members throw OutputError if a file cannot be written or removed.
class Stamps {
public:
    explicit Stamps(std::filesystem::path folder);

    // Whether the file is there and was made from this, the text of a fingerprint without blanks.
    bool current(const std::string& name, const std::string& fingerprint) const;

    // The file is whole, and was made from this.
    void mark(const std::string& name, const std::string& fingerprint);

    // Removes the file, whole or as .part, and its stamp.
    void remove(const std::string& name);

    // The file is one of this run's.
    void claim(const std::string& name) { claimed_.insert(name); }
    // Removes what earlier runs made and this one has not claimed.
    void remove_unclaimed();

private:
    void note(const std::string& fingerprint, const std::string& name);
    void rewrite();

    std::filesystem::path folder_;
    std::unordered_map<std::string, std::string> fingerprints_;  // by name
    std::set<std::string> claimed_;
    std::ofstream journal_;
};

}  // namespace tidewater::postprocess
