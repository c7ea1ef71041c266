#pragma once

#include "app/cli/tuning_source.h"
#include "app/procedures/apply/apply_procedure.h"

#include <string>

namespace halbench::app {

// How `tune --apply` gets gains onto a device.

/// The device of --apply; without the option nothing. What it is not of this motor, or does not have of the
/// timing that was designed for, stands among the findings of the result, which is judged again for the
/// latter. Errors: ConsentMissing, of the device; Refused (what is refused there is not written).
Result<void> openToApply(CommandContext& context, const TuneOptions& options, TuningSource& source,
                         TuneResult& result);

/// An apply as it is printed and written.
struct AppliedGains {
    ApplyResult result;
    JsonValue body;
    std::string steps; ///< lines about them; empty: at once
};

/// --live: small steps, each proved by a move. Errors: of runLiveApply.
Result<AppliedGains> applyInSteps(CommandContext& context, TuningSource& source, const TuneResult& result);
/// All at once, proved by a move. Errors: of runApply.
Result<AppliedGains> applyGains(CommandContext& context, TuningSource& source, const TuneResult& result);

} // namespace halbench::app
