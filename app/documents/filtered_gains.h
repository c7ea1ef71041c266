#pragma once

#include "app/documents/model_file.h"
#include "app/documents/text/json_value.h"
#include "control/law/filtered_law.h"

#include <cstddef>
#include <string>
#include <vector>

namespace halbench::app {

/// GAINS.json that may ask for more than the board's law has: `gains.filter_s`, `gains.setpoint_weights`
/// {b, c}, `gains.filters` [{kind, ...}]. They stand among the gains, because there a reader that does not
/// know them refuses. Errors: as of `parseGains`; of `checkedGains`.
Result<GainsFile> parseFilteredGains(const std::string& text, const std::string& origin);
Result<GainsFile> readFilteredGains(const std::string& path);

/// Weights and filters of a law as keys of a document of gains, so that it reads back.
void setShaping(JsonValue& document, const control::FilteredLaw& filtered);
/// The figures of a filter in the order of its kind's struct, and back: `kind` as LoopFilter counts them. An
/// order of a low-pass that is not whole is one that no filter has.
std::vector<double> figuresOf(const control::LoopFilter& filter);
control::LoopFilter filterOf(std::size_t kind, const std::vector<double>& figures);
/// For reading: "notch: frequency_rad_s 180, ...".
std::string filterWords(const control::LoopFilter& filter);
/// For reading: a line each.
std::string shapingLines(const control::FilteredLaw& filtered);

} // namespace halbench::app
