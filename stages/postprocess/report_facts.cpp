#include "io/text.h"
#include "report_parts.h"

namespace tidewater::postprocess {
namespace {

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

std::string size_text(std::int64_t bytes) {
    return bytes < 1'000'000 ? short_number(1e-3 * static_cast<double>(bytes)) + " kB"
                             : short_number(1e-6 * static_cast<double>(bytes)) + " MB";
}

std::string state_text(const io::RunFacts& run) {
    std::string text = run.state + (run.reason.empty() ? "" : ": " + run.reason);
    if (run.processes > 1) text += "; in " + std::to_string(run.processes) + " pieces";
    return text + "; began " + run.started + (run.ended.empty() ? "" : ", ended " + run.ended);
}

std::string machine_text(const io::RunFacts& run) {
    std::string text = run.machine.cpu.empty() ? "unknown processor" : run.machine.cpu;
    text += ", " + std::to_string(run.machine.cores) + " cores";
    if (run.machine.memory_bytes) text += ", " + size_text(*run.machine.memory_bytes);
    return text + (run.machine.host.empty() ? "" : " (" + run.machine.host + ")");
}

// What simulate took, from run.json.
void add_cost(const io::RunFacts& run, std::vector<io::Fact>& facts) {
    add(facts, "Simulation", state_text(run));
    add(facts, "Particles", io::particles_text(run));
    add(facts, "Cost", io::cost_text(run));
    add(facts, "Where the time went", io::time_shares_text(run));
    if (run.steps > 0) add(facts, "Time step", io::time_step_text(run));
    add(facts, "Steps limited by", io::limited_by_text(run));
    add(facts, "Peak memory", run.peak_memory_bytes ? size_text(*run.peak_memory_bytes) : "");
    add(facts, "Written",
        size_text(run.bytes.frames) + " of frames, " + size_text(run.bytes.tables) + " of tables");
    add(facts, "Energy and momentum", io::ledger_text(run));
    add(facts, "Machine", machine_text(run));
    add(facts, "Simulated by", run.program + " " + run.version + ", commit " + run.commit);
}

}  // namespace

std::vector<io::Fact> report_facts(const StageContext& context, const Frames& frames,
                                   const std::optional<io::RunFacts>& run) {
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
    if (run) {
        add_cost(*run, facts);
    } else {
        add(facts, "Cost", "not recorded: there is no simulate/run.json");
    }
    for (const auto& [name, value] : provenance_fields(context.provenance)) add(facts, name, value);
    return facts;
}

}  // namespace tidewater::postprocess
