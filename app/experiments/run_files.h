#pragma once

#include "app/documents/result_header.h"
#include "app/experiments/run_outcome.h"

namespace halbench::app {

/// halbench.run/1: the steps with their results by name, the checks, the verdict; "error" says what ended a
/// run early, else null.
JsonValue runDocument(const ResultHeader& header, const Experiment& experiment, const RunOutcome& outcome);

/// The same for CI servers: one test case for each step and each check. No times: equal seeds give equal
/// bytes.
std::string junitText(const Experiment& experiment, const RunOutcome& outcome);

/// Worst verdict of the steps with the findings of all of them.
DataQuality runQuality(const RunOutcome& outcome);

/// One line a check and the verdict, for people.
std::string runText(const RunOutcome& outcome);

/// result.json, junit.xml, STEP.csv of every recorded step and report.html, the smallest and most telling
/// first. A file that cannot be written does not keep the others from it; the error names all that are
/// missing. Errors: FileSystem, Internal.
Result<void> writeRunFiles(const std::string& folder, const ResultHeader& header,
                           const Experiment& experiment, const RunOutcome& outcome, devices::Device& device);

} // namespace halbench::app
