#pragma once

#include "app/documents/result_header.h"
#include "app/experiments/run_outcome.h"

namespace halbench::app {

/// report.html of a run: the verdict, every step with its figures, findings and plots, every check. One
/// self-contained document; equal runs give equal bytes. Errors: of renderReport().
Result<std::string> renderRunReport(const ResultHeader& header, const Experiment& experiment,
                                    const RunOutcome& outcome, const devices::Device& device);

} // namespace halbench::app
