// report.html: what a run was, what came of it, against which references, and what to be careful about; from
// the files of the run alone, of which each may be missing.
#pragma once

#include "common/stage.h"
#include "frames.h"
#include "io/run_facts.h"

namespace tidewater::postprocess {

// Written last: it shows what the stage has written before. `run` is what run.json tells, if it is there.
// Throws OutputError.
void write_run_report(const StageContext& context, const Frames& frames,
                      const std::optional<io::RunFacts>& run);

}  // namespace tidewater::postprocess
