#include "app/documents/text/procedure_choices.h"

namespace halbench::app {

Result<SweepDirections> sweepDirections(const std::string& name) {
    if (name.empty() || name == "both") {
        return SweepDirections::Both;
    }
    if (name == "forward") {
        return SweepDirections::Forward;
    }
    if (name == "reverse") {
        return SweepDirections::Reverse;
    }
    return failure(ErrorCode::Usage, "--directions: '" + name + "' is no direction",
                   "use both, forward or reverse");
}

Result<std::vector<Calibration>> calibrationsFrom(const std::string& name) {
    if (name == "all") {
        return CalibrateConfig{}.which;
    }
    for (const Calibration calibration : CalibrateConfig{}.which) {
        if (calibrationName(calibration) == name) {
            return std::vector<Calibration>{calibration};
        }
    }
    return failure(ErrorCode::Usage, "'" + name + "' is no calibration",
                   "use hall, stray, static-friction or all");
}

} // namespace halbench::app
