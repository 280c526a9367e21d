#include "io/run_facts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/files.h"
#include "io/text.h"

namespace tidewater::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "tidewater-run-facts";
constexpr std::int64_t format_version = 1;

// The one list of keys: shows each value with its name to `fields`, which writes or reads it.
template <class Facts, class Fields>
void visit(Facts& f, Fields fields) {
    fields("state", f.state);
    fields("reason", f.reason);
    fields("program", f.program);
    fields("version", f.version);
    fields("commit", f.commit);
    fields("command", f.command);
    fields("started", f.started);
    fields("ended", f.ended);
    fields("processes", f.processes);
    fields("went_on_from_s", f.went_on_from_s);
    const Fields scene = fields.within("scene");
    scene("file", f.scene.file);
    scene("title", f.scene.title);
    scene("hash", f.scene.hash);
    scene("seed", f.scene.seed);
    scene("dimension", f.scene.dimension);
    scene("effects", f.scene.effects);
    const Fields machine = fields.within("machine");
    machine("host", f.machine.host);
    machine("cpu", f.machine.cpu);
    machine("cores", f.machine.cores);
    machine("memory_bytes", f.machine.memory_bytes);
    fields("threads", f.threads);
    fields("precision", f.precision);
    const Fields engine = fields.within("engine");
    engine("cell_size_m", f.engine.cell_size_m);
    engine("cells", f.engine.cells);
    engine("grid_blocks", f.engine.grid_blocks);
    engine("particles", f.engine.particles);
    engine("rigid_bodies", f.engine.rigid_bodies);
    fields("steps", f.steps);
    fields("particle_steps", f.particle_steps);
    fields("simulated_s", f.simulated_s);
    fields("settling_s", f.settling_s);
    const Fields time_step = fields.within("time_step");
    time_step("min_s", f.time_step.min_s);
    time_step("mean_s", f.time_step.mean_s);
    time_step("max_s", f.time_step.max_s);
    time_step("last_s", f.time_step.last_s);
    time_step("steps_limited_by", f.time_step.steps_limited_by);
    fields("seconds", f.seconds);
    fields("peak_memory_bytes", f.peak_memory_bytes);
    const Fields bytes = fields.within("bytes");
    bytes("frames", f.bytes.frames);
    bytes("tables", f.bytes.tables);
    bytes("checkpoint", f.bytes.checkpoint);
    const Fields ledger = fields.within("ledger");
    ledger("first", f.ledger.first);
    ledger("last", f.ledger.last);
    ledger("energy_rise_J", f.ledger.energy_rise);
    ledger("momentum_open_kg_m_s", f.ledger.momentum_open);
    fields("warnings", f.warnings);
}

class Writer {
public:
    explicit Writer(Json& object) : object_(object) {
        if (object_.is_null()) object_ = Json::object();
    }

    Writer within(const char* name) const { return Writer(object_[name]); }

    template <class T>
    void operator()(const char* name, const T& value) const {
        object_[name] = value;
    }
    void operator()(const char* name, double value) const { object_[name] = number(value); }
    void operator()(const char* name, const std::string& text) const {
        object_[name] = text.empty() ? Json() : Json(text);
    }
    void operator()(const char* name, const std::optional<std::int64_t>& value) const {
        object_[name] = value ? Json(*value) : Json();
    }
    template <class T>
    void operator()(const char* name, const Named<T>& values) const {
        const Writer inner = within(name);
        for (const auto& [key, value] : values) inner(key.c_str(), value);
    }

private:
    // JSON has no NaN and no infinity.
    static Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

    Json& object_;
};

class Reader {
public:
    explicit Reader(const Json& object) : object_(object) {}

    Reader within(const char* name) const { return Reader(object_.at(name)); }

    template <class T>
    void operator()(const char* name, T& value) const {
        object_.at(name).get_to(value);
    }
    void operator()(const char* name, double& value) const {
        const Json& found = object_.at(name);
        value = found.is_null() ? RunFacts::unknown : found.get<double>();
    }
    void operator()(const char* name, std::string& text) const {
        const Json& found = object_.at(name);
        text = found.is_null() ? std::string() : found.get<std::string>();
    }
    void operator()(const char* name, std::optional<std::int64_t>& value) const {
        const Json& found = object_.at(name);
        value = found.is_null() ? std::nullopt : std::optional(found.get<std::int64_t>());
    }
    template <class T>
    void operator()(const char* name, Named<T>& values) const {
        const Json& found = object_.at(name);
        const Reader inner(found);
        values.clear();
        for (const auto& entry : found.items()) {
            values.emplace_back(entry.key(), T());
            inner(entry.key().c_str(), values.back().second);
        }
    }

private:
    const Json& object_;
};

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& problem) {
    throw InputError(path.string() + ": " + problem +
                     "; run tidewater-simulate again, or remove the file to do without what it tells");
}

// The library's message without its code: "[json.exception.out_of_range.403] key 'steps' not found".
std::string message(const Json::exception& error) {
    const std::string text = error.what();
    const auto end = text.find("] ");
    return end == text.npos ? text : text.substr(end + 2);
}

Json parse(const std::filesystem::path& path) {
    const Json json = Json::parse(read_text(path), nullptr, false);
    if (json.is_discarded()) fail(path, "it is no JSON, or cut short");
    return json;
}

// Throws InputError if the object is of another format or a newer version.
void require_format(const Json& json, const std::filesystem::path& path) {
    if (!json.is_object() || json.value("format", Json()) != format_name)
        fail(path, "it is JSON but does not hold the facts of a run of tidewater");
    const Json version = json.value("format_version", Json());
    if (!version.is_number_integer()) fail(path, "it does not tell its format version");
    if (version > format_version)
        fail(path, "its format version " + version.dump() + " is newer than this program's " +
                       std::to_string(format_version));
}

// The value under this name; NaN without.
double find(const Named<double>& values, const std::string& name) {
    const auto found = std::ranges::find(values, name, &std::pair<std::string, double>::first);
    return found == values.end() ? RunFacts::unknown : found->second;
}

std::string short_number(double value) { return format_digits(value, 3); }

// Of parts of a whole "sort 3 %, pass 96 %", in their order; parts of less than half a percent are left out.
template <class T>
std::string shares(const Named<T>& parts, double whole) {
    std::string text;
    for (const auto& [name, part] : parts) {
        const double percent = 100.0 * static_cast<double>(part) / whole;
        if (!(percent >= 0.5)) continue;
        std::string words = name;
        std::ranges::replace(words, '_', ' ');
        text += (text.empty() ? "" : ", ") + words + " " + std::to_string(std::lround(percent)) + " %";
    }
    return text;
}

}  // namespace

std::int64_t RunFacts::particle_count() const {
    std::int64_t count = 0;
    for (const auto& [material, number] : engine.particles) count += number;
    return count;
}

double RunFacts::seconds_of(const char* part) const { return find(seconds, part); }

double RunFacts::total_seconds() const { return seconds_of("total"); }

double RunFacts::particle_steps_per_second() const {
    return static_cast<double>(particle_steps) / total_seconds();
}

void write_run_facts(const std::filesystem::path& path, const RunFacts& facts) {
    Json json{{"format", format_name}, {"format_version", format_version}};
    visit(facts, Writer(json));
    write_text(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

RunFacts read_run_facts(const std::filesystem::path& path) {
    const Json json = parse(path);
    require_format(json, path);
    RunFacts facts;
    try {
        visit(facts, Reader(json));
    } catch (const Json::exception& error) {
        fail(path, message(error));
    }
    return facts;
}

std::string particles_text(const RunFacts& facts) {
    std::string text;
    for (const auto& [material, number] : facts.engine.particles) {
        if (number > 0) text += (text.empty() ? "" : " + ") + std::to_string(number) + " of " + material;
    }
    return std::to_string(facts.particle_count()) + " particles" + (text.empty() ? "" : " (" + text + ")") +
           " in " + std::to_string(facts.engine.grid_blocks) + " blocks, " +
           std::to_string(facts.scene.dimension) + "D, " + facts.precision + ", cell size " +
           short_number(facts.engine.cell_size_m) + " m";
}

std::string cost_text(const RunFacts& facts) {
    return std::to_string(facts.steps) + " steps in " + short_number(facts.total_seconds()) + " s on " +
           std::to_string(facts.threads) + (facts.threads == 1 ? " thread: " : " threads: ") +
           short_number(1e-6 * facts.particle_steps_per_second()) + " million particle-steps/s";
}

std::string time_shares_text(const RunFacts& facts) {
    Named<double> parts = facts.seconds;
    std::erase_if(parts, [](const auto& part) { return part.first == "total"; });
    return shares(parts, facts.total_seconds());
}

std::string time_step_text(const RunFacts& facts) {
    const auto& step = facts.time_step;
    return "mean " + short_number(step.mean_s) + " s, " + short_number(step.min_s) + " to " +
           short_number(step.max_s) + " s, " + short_number(step.last_s) + " s at the end";
}

std::string limited_by_text(const RunFacts& facts) {
    double counted = 0.0;
    for (const auto& [limit, steps] : facts.time_step.steps_limited_by) counted += static_cast<double>(steps);
    return shares(facts.time_step.steps_limited_by, counted);
}

std::string ledger_text(const RunFacts& facts) {
    if (facts.ledger.last.empty()) return {};
    const double first = find(facts.ledger.first, "energy"), last = find(facts.ledger.last, "energy");
    char text[256];
    std::snprintf(
        text, sizeof text,
        "energy %.6g J at the start, %+.3g J since, at most %+.3g J above it; momentum open by %.2g "
        "kg m/s, of %.3g that gravity gave",
        first, last - first, facts.ledger.energy_rise, facts.ledger.momentum_open,
        std::abs(find(facts.ledger.last, "gravity_impulse_z")));
    return text;
}

}  // namespace tidewater::io
