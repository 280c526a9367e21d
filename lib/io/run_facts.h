// run.json: what a run of tidewater-simulate was, what it took and how it ended, as data: for the report, for
// tools and for scripts, so that nobody has to read the log by its words.
//
// One JSON object whose keys are those of RunFacts, in its order, after "format": "tidewater-run-facts" and
// "format_version". A key ends with its unit where it has one. null stands for what is not known: here NaN,
// an empty text or an empty optional. stages/simulate/README.md tells each key.
//
// Test: tests/unit/io/run_facts_test.cpp
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tidewater::io {

// Named values in an order of their own.
template <class T>
using Named = std::vector<std::pair<std::string, T>>;

struct RunFacts {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    std::string state;   // "running", "stopped", "complete" or "failed"
    std::string reason;  // why it stopped or failed, in a line
    std::string program, version, commit, command;
    std::string started, ended;       // UTC by ISO 8601; `started` of the first process
    std::int64_t processes = 1;       // that the run took, each going on from a checkpoint of the one before
    double went_on_from_s = unknown;  // simulated time of the checkpoint that the last process began with

    struct Scene {
        std::string file, title, hash;
        std::int64_t dimension = 0, seed = 0;
        std::vector<std::string> effects;
    } scene;

    struct Machine {
        std::string host, cpu;
        std::int64_t cores = 0;
        std::optional<std::int64_t> memory_bytes;
    } machine;
    std::int64_t threads = 0;
    std::string precision;  // "float" or "double"

    struct Engine {
        double cell_size_m = unknown;
        std::vector<std::int64_t> cells = {};  // along each axis
        std::int64_t grid_blocks = 0;          // that hold particles
        Named<std::int64_t> particles = {};    // by material
        std::int64_t rigid_bodies = 0;
    } engine;

    std::int64_t steps = 0;
    std::int64_t particle_steps = 0;  // particles summed over the steps
    double simulated_s = unknown;
    double settling_s = unknown;  // spent on settling before time began

    struct TimeStep {
        double min_s = unknown, mean_s = unknown, max_s = unknown, last_s = unknown;
        Named<std::int64_t> steps_limited_by = {};
    } time_step;

    Named<double> seconds;  // of wall time by phase; the last one is "total"
    std::optional<std::int64_t> peak_memory_bytes;

    struct Bytes {
        std::int64_t frames = 0, tables = 0;
        std::optional<std::int64_t> checkpoint;  // the last one that was written
    } bytes;

    struct Ledger {
        Named<double> first, last;       // rows of ledger.csv
        double energy_rise = unknown;    // J above its start, at most
        double momentum_open = unknown;  // kg m/s that neither gravity, walls nor outflow explain
    } ledger;

    std::vector<std::string> warnings;

    std::int64_t particle_count() const;
    double seconds_of(const char* part) const;  // of wall time; NaN without
    double total_seconds() const;               // likewise
    double particle_steps_per_second() const;   // likewise
};

// Replaces path as a whole. Throws OutputError.
void write_run_facts(const std::filesystem::path& path, const RunFacts& facts);

// Throws InputError in one line if the file is no JSON, of another format or a newer version of it, or if a
// key is missing or of another type.
RunFacts read_run_facts(const std::filesystem::path& path);

// The facts in words, each in a line, for log and report.
std::string particles_text(const RunFacts& facts);    // how many of what, on which grid
std::string cost_text(const RunFacts& facts);         // steps, seconds, particle-steps per second
std::string time_shares_text(const RunFacts& facts);  // "start 3 %, sort 2 %, …"
std::string time_step_text(const RunFacts& facts);    // its mean, range and end
std::string limited_by_text(const RunFacts& facts);  // "sound in water 97 %, output 3 %"; empty without steps
std::string ledger_text(const RunFacts& facts);      // energy and momentum; empty without a row

}  // namespace tidewater::io
