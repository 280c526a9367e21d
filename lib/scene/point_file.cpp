#include "scene/point_file.h"

#include <charconv>
#include <sstream>
#include <string>

#include "core/error.h"
#include "core/files.h"
#include "scene/text.h"

namespace tidewater::scene {
namespace {

std::vector<std::string> words(std::string line) {
    line = line.substr(0, line.find('#'));
    for (char& letter : line) {
        if (letter == ',' || letter == ';' || letter == '\t' || letter == '\r') letter = ' ';
    }
    std::istringstream stream(line);
    std::vector<std::string> all;
    for (std::string word; stream >> word;) all.push_back(word);
    return all;
}

bool to_number(const std::string& word, double& number) {
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, number);
    return error == std::errc() && stop == end;
}

}  // namespace

std::vector<double> read_point_file(const std::filesystem::path& path) {
    std::istringstream text(read_text(path));
    std::vector<double> points;
    int number = 0;
    for (std::string line; std::getline(text, line);) {
        ++number;
        const auto row = words(line);
        if (row.empty()) continue;
        double x = 0.0, z = 0.0;
        const bool numbers = row.size() == 2 && to_number(row[0], x) && to_number(row[1], z);
        double ignored = 0.0;
        const bool names = points.empty() && !to_number(row[0], ignored);
        if (!numbers && names) continue;
        if (!numbers) {
            throw InputError(path.string() + ":" + std::to_string(number) + ": " + quoted_text(line) +
                             " is not two numbers, x and z in m");
        }
        points.insert(points.end(), {x, z});
    }
    return points;
}

}  // namespace tidewater::scene
