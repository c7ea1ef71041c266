#pragma once

#include "control/base/sample_block.h"
#include "control/law/position_loop.h"

#include <optional>
#include <string>

namespace halbench::app {

/// Effort that a motion took, by the effort that the model says it needs. Feedback hides a gain that is wrong
/// from the positions, not from this ratio.
struct EffortAgreement {
    double ratio = 1.0; ///< measured over needed; half the mass needs half the effort
    double low = 1.0;   ///< allowed
    double high = 1.0;
    bool isWithin() const { return ratio >= low && ratio <= high; }
};

/// Signals of a verification in its recording.
struct EffortColumns {
    std::string position;
    std::string effort;
};

/// Over the acceleration and the braking of a step, its first `until_s` seconds, least squares of
///
///   x'' = alpha k u - c x' + p - s x,   ratio = 1/alpha
///
/// in integrated form: k, c: acceleration gain and damping rate of the model; p, s and the speed at the start
/// are free, for what holds the axis at rest and for a spring (a cable). The double integral of the effort u
/// keeps little of the noise of the readings, which the law passes on to it.
/// `gainDeviation_ratio`: 1 sigma of k relative to it. Allowed either way are 25 % for what a model leaves
/// out (coil spread, harmonics, the local scale of an uncalibrated pose, of which 11 % were seen) and two
/// standard deviations of k and of this fit together, the latter no more than 25 %. Nothing where the
/// recording is too short.
std::optional<EffortAgreement> effortAgreement(const Recording& move, const EffortColumns& columns,
                                               const control::PositionPlant& plant,
                                               double gainDeviation_ratio, double until_s);

} // namespace halbench::app
