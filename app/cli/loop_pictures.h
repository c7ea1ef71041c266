#pragma once

#include "app/figures/loop_curves.h"
#include "app/procedures/tune/loop_uncertainty.h"
#include "app/procedures/tune/tune.h"

#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// One picture of --picture VIEW=FILE.
struct LoopPicture {
    std::string view;
    std::string path;
};

/// bode, nyquist, nichols, sensitivity, root-locus, step, large-step, disturbance: as the Tune window shows
/// them.
const std::vector<std::string>& loopViews();

/// Errors: Usage (no VIEW=FILE, an unknown view, a file of another format).
Result<std::vector<LoopPicture>> loopPicturesOf(const std::vector<std::string>& options);

/// Content of the pictures: a judged loop, the uncertainty of its motor when that is known, other loops
/// beside it.
struct DrawnLoop {
    const TuneResult* result = nullptr;
    const MotorEstimate* motor = nullptr;
    std::vector<NamedLoop> others = {};
    UncertaintyDraws draws = {};
};

/// Each into its file. Errors: Refused (an unstable loop has no step, sensitivity or disturbance);
/// FileSystem.
Result<void> writeLoopPictures(const std::vector<LoopPicture>& pictures, const DrawnLoop& loop);

} // namespace halbench::app
