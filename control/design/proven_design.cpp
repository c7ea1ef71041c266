#include "control/design/proven_design.h"

#include <utility>

namespace halbench::control {

Result<ProvenDesign> provenDesign(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing,
                                  double currentLimit_A) {
    auto proof = proveDesign(plant, gains, timing, currentLimit_A);
    if (!proof) {
        return failure(proof.error());
    }
    if (!proof->isStable) {
        return failure(ErrorCode::Refused, "the design is unstable in the sampled loop",
                       "ask for less speed, or shorten the computing delay");
    }
    return ProvenDesign{gains, std::move(*proof)};
}

tl::unexpected<Error> impossibleTargets() {
    return failure(ErrorCode::OutOfRange,
                   "the targets of this design are not possible: they must be positive, Ms above 1");
}

} // namespace halbench::control
