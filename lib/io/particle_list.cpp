#include "io/particle_list.h"

#include <cpl_error.h>
#include <cpl_json.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/error.h"
#include "io/particle_files.h"
#include "io/text.h"
#include "io/vtk_messages.h"

namespace tidewater::io {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct Listed {
    std::filesystem::path file;
    double time = unknown;
};

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& problem) {
    throw InputError(path.string() + ": " + problem);
}

// One entry of a collection, of which each file is a whole frame.
void add_entry(const std::filesystem::path& collection, const std::string& name, double time,
               std::vector<Listed>& entries) {
    if (name.empty()) fail(collection, "an entry names no file; write the collection again");
    if (!entries.empty() && entries.back().time == time)
        fail(collection,
             "two files are of the time " + format_number(time) + "; particles in parts are not read");
    entries.push_back({collection.parent_path() / name, time});
}

std::vector<Listed> read_pvd(const std::filesystem::path& path) {
    const QuietVtk quiet;
    const auto root =
        vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(path.c_str()));
    vtkXMLDataElement* collection = root ? root->FindNestedElementWithName("Collection") : nullptr;
    if (collection == nullptr) fail(path, "it is truncated or no collection; write it again");
    std::vector<Listed> entries;
    for (int n = 0; n < collection->GetNumberOfNestedElements(); ++n) {
        vtkXMLDataElement* entry = collection->GetNestedElement(n);
        const char *file = entry->GetAttribute("file"), *time = entry->GetAttribute("timestep");
        add_entry(path, file ? file : "", parse_number(time ? time : "").value_or(unknown), entries);
    }
    return entries;
}

std::vector<Listed> read_series(const std::filesystem::path& path) {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLJSONDocument document;
    const bool read = document.Load(path.string());
    CPLPopErrorHandler();
    if (!read) fail(path, "it is truncated or no series; write it again");
    std::vector<Listed> entries;
    const CPLJSONArray files = document.GetRoot().GetArray("files");
    for (int n = 0; files.IsValid() && n < files.Size(); ++n)
        add_entry(path, files[n].GetString("name"), files[n].GetDouble("time", unknown), entries);
    return entries;
}

std::vector<Listed> read_named(const std::filesystem::path& path) {
    const bool is_collection = path.extension() == ".pvd" || path.extension() == ".series";
    if (!is_collection) return {{path, unknown}};
    if (!std::filesystem::is_regular_file(path)) fail(path, "the file does not exist; check the path");
    auto entries = path.extension() == ".pvd" ? read_pvd(path) : read_series(path);
    if (entries.empty()) fail(path, "it names no files; write it again");
    return entries;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The length of the digits at the start, and what they say without leading zeros.
std::string_view leading_digits(std::string_view text) {
    return text.substr(0, static_cast<std::size_t>(std::ranges::find_if_not(text, is_digit) - text.begin()));
}

// Numbers within names count as numbers: a_9 is before a_10.
bool before_by_numbers(std::string_view a, std::string_view b) {
    while (!a.empty() && !b.empty()) {
        const std::string_view m = leading_digits(a), n = leading_digits(b);
        if (m.empty() || n.empty()) {
            if (a.front() != b.front()) return a.front() < b.front();
            a.remove_prefix(1);
            b.remove_prefix(1);
            continue;
        }
        const auto value = [](std::string_view digits) {
            return digits.substr(std::min(digits.find_first_not_of('0'), digits.size()));
        };
        if (value(m).size() != value(n).size()) return value(m).size() < value(n).size();
        if (value(m) != value(n)) return value(m) < value(n);
        a.remove_prefix(m.size());
        b.remove_prefix(n.size());
    }
    return a.size() < b.size();
}

void require_rising(const std::vector<Listed>& listed) {
    for (std::size_t n = 1; n < listed.size(); ++n) {
        if (listed[n - 1].time < listed[n].time) continue;
        fail(listed[n].file, "it is of the same time, " + format_number(listed[n].time) + " s, as " +
                                 listed[n - 1].file.string() + "; name each frame once, or tell --times");
    }
}

void take_times(std::vector<Listed>& listed, const std::vector<double>& times) {
    if (times.size() != listed.size()) {
        throw InputError("--times: " + std::to_string(times.size()) + " times for " +
                         std::to_string(listed.size()) + " files; tell one for each");
    }
    for (std::size_t n = 0; n < times.size(); ++n) listed[n].time = times[n];
}

}  // namespace

ParticleList list_particles(const std::vector<std::filesystem::path>& named,
                            const std::vector<double>& times) {
    std::vector<Listed> listed;
    for (const auto& path : named) {
        for (Listed& entry : read_named(path)) listed.push_back(std::move(entry));
    }
    ParticleList list;
    if (!times.empty()) take_times(listed, times);
    for (Listed& entry : listed) {
        if (!std::filesystem::is_regular_file(entry.file))
            fail(entry.file, "the file does not exist; check the path");
        if (std::isnan(entry.time)) entry.time = read_particle_time(entry.file);
    }
    if (std::ranges::any_of(listed, [](const Listed& entry) { return std::isnan(entry.time); })) {
        std::ranges::stable_sort(listed, before_by_numbers,
                                 [](const Listed& entry) { return entry.file.string(); });
        for (std::size_t n = 0; n < listed.size(); ++n) listed[n].time = static_cast<double>(n);
        list.note =
            "the files tell no times: 0, 1, 2, ... s in the order of the numbers in their names; --times "
            "tells them";
    }
    std::ranges::stable_sort(listed, {}, &Listed::time);
    require_rising(listed);
    for (Listed& entry : listed) {
        list.files.push_back(std::move(entry.file));
        list.times.push_back(entry.time);
    }
    return list;
}

}  // namespace tidewater::io
