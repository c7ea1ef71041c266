#pragma once

#include "app/batch/json_value.h"
#include "app/batch/model_file.h"
#include "control/design/shaped_law.h"

#include <optional>
#include <string>

namespace halbench::app {

/// GAINS.json that may ask for more than the board's law has: `gains.filter_s`, `gains.setpoint_weights`
/// {b, c}, `gains.filters` [{kind, ...}]. They stand among the gains, because there a reader that does not
/// know them refuses.
struct ShapedGainsFile {
    GainsFile gains;                          ///< without them
    std::optional<control::ShapedLaw> shaped; ///< with them; nothing when the board's law is all of it
};

/// Errors: as of `parseGains`; of `checkedGains`.
Result<ShapedGainsFile> parseShapedGains(const std::string& text, const std::string& origin);
Result<ShapedGainsFile> readShapedGains(const std::string& path);

/// Of a document of gains the same keys, so that it reads back.
void setShaping(JsonValue& document, const control::ShapedLaw& shaped);
/// For reading: a line each.
std::string shapingLines(const control::ShapedLaw& shaped);

/// Refused: what is asked of the board, or of what shows the board's law only. `option` names it.
tl::unexpected<Error> notOnBoard(const std::string& option);

} // namespace halbench::app
