#pragma once

#include "app/documents/model_file.h"
#include "app/documents/text/json_value.h"
#include "app/procedures/move/what_if.h"

#include <optional>
#include <string>

namespace halbench::app {

/// A recorded move and the loop that ran then.
struct RanMove {
    RecordedMove move;
    LoopLaw law;
    LoopConditions conditions; ///< of the board then, as far as they were recorded
};

/// Reads a recording with its sidecar. `ranFile`: the gains that ran, when they are not recorded; else empty.
/// Errors: of the files; InvalidInput (no gains recorded, or changed within; those of `ranFile` are of
/// another sample period than `conditions`); of recordedMove().
Result<RanMove> readRanMove(const std::string& recordingPath, const std::string& ranFile,
                            const LoopConditions& conditions);
/// Whether that is for want of `ranFile`: who has it can ask for it.
bool needsRanFile(const Error& error);

/// What `analyse --what-if` answers: also why nothing is predicted.
struct WhatIfReport {
    WhatIfBasis basis;
    std::optional<WhatIf> predicted;
    std::optional<Error> withheld;
    DataQuality quality;
};
/// Errors: of prepareWhatIf(). A prediction that is withheld is an answer.
Result<WhatIfReport> reportWhatIf(const RanMove& ran, const MotorEstimate& motor, const LoopLaw& law,
                                  const UncertaintyDraws& draws);

/// `what_if` of halbench.analysis/1.
JsonValue whatIfBody(const WhatIfReport& report);
/// The same for people.
std::string whatIfText(const WhatIfReport& report);
/// time_s, reference_rad, recorded_rad, and what is predicted with its band: rows of the band.
std::string whatIfTable(const WhatIfReport& report);

} // namespace halbench::app
