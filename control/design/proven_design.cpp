#include "control/design/proven_design.h"

#include <utility>

namespace halbench::control {

Result<ProvenDesign> provenDesign(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing,
                                  double currentLimit_A) {
    auto assessment = assessDesign(plant, gains, timing, currentLimit_A);
    if (!assessment) {
        return failure(assessment.error());
    }
    if (!assessment->isStable) {
        return failure(ErrorCode::Refused, "the design is unstable in the sampled loop",
                       "use a slower target, or reduce the computing delay");
    }
    return ProvenDesign{gains, std::move(*assessment)};
}

tl::unexpected<Error> impossibleTargets() {
    return failure(ErrorCode::OutOfRange, "invalid design targets: they must be positive, Ms above 1");
}

} // namespace halbench::control
