#include <sstream>

#include "core/files.h"
#include "io/text.h"
#include "report_parts.h"

namespace tidewater::postprocess {
namespace {

// The last line of simulate's log that holds the words; empty if none does.
std::string last_line_with(const std::string& log, const std::string& words) {
    std::istringstream lines(log);
    std::string found;
    for (std::string line; std::getline(lines, line);) {
        if (line.find(words) != line.npos) found = line;
    }
    return found;
}

std::string list(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

std::string size_text(const std::vector<double>& size) {
    std::string text;
    for (const double edge : size) text += (text.empty() ? "" : " × ") + io::format_number(edge);
    return text + " m";
}

void add(std::vector<io::Fact>& facts, const std::string& name, const std::string& value) {
    if (!value.empty()) facts.push_back({name, value});
}

// What simulate's log tells of the run's cost.
void add_cost(const StageContext& context, std::vector<io::Fact>& facts) {
    const auto path = simulated_table(context, "log");
    if (path.empty()) return;
    const std::string log = read_text(path);
    add(facts, "Particles", last_line_with(log, " blocks, "));
    add(facts, "Cost", last_line_with(log, "particle-steps/s"));
    add(facts, "Where the time went", last_line_with(log, "time in the step:"));
    const std::string step = last_line_with(log, ": dt ");
    add(facts, "Time step at the end", step.substr(step.empty() ? 0 : step.find("dt ")));
    add(facts, "Energy and momentum", last_line_with(log, "ledger: "));
}

}  // namespace

std::vector<io::Fact> report_facts(const StageContext& context, const Frames& frames) {
    const scene::Scene& scene = context.scene;
    std::vector<io::Fact> facts;
    add(facts, "Scene", scene.title);
    add(facts, "Effects", list(scene.effects));
    add(facts, "Tank",
        size_text(scene.domain.size) + ", " + std::to_string(scene.dimension) + "D, cells of " +
            io::format_number(scene.domain.cell_size) + " m");
    if (!frames.times.empty()) {
        add(facts, "Frames",
            std::to_string(frames.times.size()) + ", up to t = " + io::format_number(frames.times.back()) +
                " s");
    }
    add_cost(context, facts);
    for (const auto& [name, value] : provenance_fields(context.provenance)) add(facts, name, value);
    return facts;
}

}  // namespace tidewater::postprocess
