#include "io/run_facts.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/error.h"
#include "core/files.h"
#include "unit/io/fixture.h"

namespace tidewater::io {
namespace {

RunFacts example() {
    RunFacts facts;
    facts.state = "stopped";
    facts.reason = "stopped by SIGTERM at t = 0.5 s, step 12";
    facts.program = "tidewater-simulate";
    facts.command = "tidewater-simulate \"a scene\".toml";
    facts.started = "2026-01-31T18:05:00Z";
    facts.scene.title = "Eis in ½ Meter „Wasser“";
    facts.scene.dimension = 2;
    facts.scene.effects = {"water", "ice"};
    facts.machine.memory_bytes = 17'179'869'184;
    facts.threads = 2;
    facts.precision = "float";
    facts.engine.cell_size_m = 0.05;
    facts.engine.cells = {40, 20};
    facts.engine.particles = {{"water", 3000}, {"ice", 0}};
    facts.engine.grid_blocks = 12;
    facts.steps = 1000;
    facts.particle_steps = 3'000'000;
    facts.simulated_s = 0.1 + 0.2;
    facts.time_step = {.min_s = 1e-4, .mean_s = 2e-4, .max_s = 3e-4, .last_s = 2e-4};
    facts.time_step.steps_limited_by = {{"sound_in_water", 980}, {"falling", 19}, {"end", 1}};
    facts.seconds = {{"sort", 0.02}, {"pass", 1.5}, {"frames", 0.1}, {"total", 2.0}};
    facts.ledger.first = {{"time", 0.0}, {"energy", 100.0}, {"gravity_impulse_z", 0.0}};
    facts.ledger.last = {{"time", 0.3}, {"energy", 97.5}, {"gravity_impulse_z", -50.0}};
    facts.ledger.energy_rise = 0.0;
    facts.ledger.momentum_open = 1e-5;
    facts.warnings = {"a gauge lies outside"};
    return facts;
}

// The line of the error that reading the text gives.
std::string complaint(const TemporaryFolder& folder, const std::string& text) {
    write_text(folder / "run.json", text);
    try {
        read_run_facts(folder / "run.json");
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    REQUIRE(at != text.npos);
    return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("facts read back as they were written, in their order, and what is unknown as unknown") {
    const TemporaryFolder folder;
    write_run_facts(folder / "run.json", example());
    const RunFacts facts = read_run_facts(folder / "run.json");
    CHECK(facts.state == "stopped");
    CHECK(facts.command == example().command);
    CHECK(facts.scene.title == example().scene.title);
    CHECK(facts.scene.effects == example().scene.effects);
    CHECK(facts.engine.cells == example().engine.cells);
    CHECK(facts.engine.particles == example().engine.particles);
    CHECK(facts.simulated_s == 0.1 + 0.2);
    CHECK(facts.time_step.steps_limited_by == example().time_step.steps_limited_by);
    CHECK(facts.seconds == example().seconds);
    CHECK(facts.ledger.last == example().ledger.last);
    CHECK(facts.warnings == example().warnings);
    CHECK(facts.machine.memory_bytes == 17'179'869'184);
    CHECK(facts.ended.empty());
    CHECK(std::isnan(facts.settling_s));
    CHECK_FALSE(facts.peak_memory_bytes);
    const std::string text = read_text(folder / "run.json");
    CHECK(text.find("\"settling_s\": null") != text.npos);
    CHECK(text.find("\"ended\": null") != text.npos);
    write_run_facts(folder / "again.json", facts);
    CHECK(read_text(folder / "again.json") == text);
}

TEST_CASE("a file that is no JSON, foreign, newer or without a key gives one line that says so") {
    const TemporaryFolder folder;
    write_run_facts(folder / "run.json", example());
    const std::string text = read_text(folder / "run.json"), file = (folder / "run.json").string() + ": ";
    const auto expect = [&](const std::string& changed, const std::string& problem) {
        CHECK(complaint(folder, changed) ==
              file + problem +
                  "; run tidewater-simulate again, or remove the file to do without what it tells");
    };
    expect(text.substr(0, text.size() / 2), "it is no JSON, or cut short");
    expect("", "it is no JSON, or cut short");
    expect("[1, 2]", "it is JSON but does not hold the facts of a run of tidewater");
    expect("{\"format\": \"package\"}", "it is JSON but does not hold the facts of a run of tidewater");
    expect("{\"format\": \"tidewater-run-facts\"}", "it does not tell its format version");
    expect(replaced(text, "\"format_version\": 1", "\"format_version\": 2"),
           "its format version 2 is newer than this program's 1");
    expect(replaced(text, "\"steps\":", "\"stairs\":"), "key 'steps' not found");
    expect(replaced(text, "\"steps\": 1000", "\"steps\": \"many\""), "type must be number, but is string");
    CHECK(complaint(folder, text).empty());
}

TEST_CASE("the facts in words") {
    const RunFacts facts = example();
    CHECK(particles_text(facts) ==
          "3000 particles (3000 of water) in 12 blocks, 2D, float, cell size 0.05 m");
    CHECK(cost_text(facts) == "1000 steps in 2 s on 2 threads: 1.5 million particle-steps/s");
    CHECK(time_shares_text(facts) == "sort 1 %, pass 75 %, frames 5 %");
    CHECK(time_step_text(facts) == "mean 0.0002 s, 0.0001 to 0.0003 s, 0.0002 s at the end");
    CHECK(limited_by_text(facts) == "sound in water 98 %, falling 2 %");
    CHECK(ledger_text(facts) ==
          "energy 100 J at the start, -2.5 J since, at most +0 J above it; momentum open by 1e-05 kg m/s, of "
          "50 "
          "that gravity gave");
    CHECK(limited_by_text(RunFacts()).empty());
    CHECK(ledger_text(RunFacts()).empty());
}

}  // namespace tidewater::io
