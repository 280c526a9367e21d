// What simulate left beside its frames, each as far as it is there: of a run that still grows what is written
// so far, of a copy without some of it the rest. What is missing is told in a line and left out.
// Test: tests/pipeline/postprocess_inputs_test.sh
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "bodies.h"
#include "common/ground.h"
#include "common/stage.h"
#include "gauges.h"
#include "io/run_facts.h"
#include "io/table.h"

namespace tidewater::postprocess {

struct Inputs {
    std::vector<GaugeRecord> gauges;
    std::optional<io::Table> ledger;
    std::filesystem::path ledger_file;
    std::vector<Body> bodies;  // empty where no block makes a wave, too
    Ground ground;
    std::optional<io::RunFacts> facts;  // of run.json
};

// Of frames of another program only the ground is read. Throws InputError if one of the files is damaged.
Inputs read_inputs(const StageContext& context);

}  // namespace tidewater::postprocess
