// The parts of report.html.
#pragma once

#include <string>
#include <vector>

#include "common/stage.h"
#include "frames.h"
#include "io/report.h"
#include "io/run_facts.h"

namespace tidewater::postprocess {

// What the tables tell against the scene's references, √(gD), beam theory and the ledger's start.
std::vector<io::KeyNumber> report_numbers(const StageContext& context);

// What to be careful about: energy, mass and momentum, gauges, fits, a run that has not ended.
std::vector<std::string> report_warnings(const StageContext& context, const Frames& frames,
                                         const std::optional<io::RunFacts>& run);

// What was run, with what, and what it took.
std::vector<io::Fact> report_facts(const StageContext& context, const Frames& frames,
                                   const std::optional<io::RunFacts>& run);

// The charts and tables that there are.
std::vector<io::ReportFigure> report_figures(const StageContext& context);
std::vector<io::ReportTable> report_tables(const StageContext& context);

// Three digits, so that a reader sees what counts; "-" for NaN.
std::string short_number(double value);

// simulate's table, under its own name or, of a run that has not ended, as .part; empty if it is not there.
std::filesystem::path simulated_table(const StageContext& context, const std::string& name);

}  // namespace tidewater::postprocess
