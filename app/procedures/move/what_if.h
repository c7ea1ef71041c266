#pragma once

#include "app/procedures/move/motion_envelope.h"
#include "app/procedures/move/recorded_move.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// A move that was measured, and the loop that ran then.
struct WhatIfConfig {
    RecordedMove move;
    LoopLaw ran;
    LoopConditions conditions;
    MotorEstimate motor;
    UncertaintyDraws draws;
};

/// What holds for every set of new gains: whether the identified loop with the gains that ran explains the
/// record, and what it leaves unexplained of it.
struct WhatIfBasis {
    WhatIfConfig config;
    std::vector<control::ReferencePoint> reference; ///< one a period of the loop
    RunMotor identified;
    std::vector<RunMotor> motors; ///< drawn
    MotionRemainder remainder;
    MotionEnvelope explained;    ///< of the gains that ran, without the record's own disturbance
    double widening_ratio = 0.0; ///< that `explained` needs to hold nineteen of twenty of the recorded points
    double outside_ratio = 0.0;  ///< share of the recorded points outside `explained`
    DataQuality quality;         ///< Refused: the record is not explained, nothing follows from it

    /// What every angle is known to at best: three times the noise of the recorded one.
    double resolution_rad() const { return 3.0 * remainder.resolution_rad; }
};

/// The move as it would have been. Rows 1 ms apart, angles from the start.
struct WhatIf {
    std::vector<double> angle_rad; ///< of the identified motor
    std::vector<double> current_A;
    std::optional<MotionEnvelope>
        band;                         ///< nine tenths of the drawn motors, as wide as the record itself needs
    double amplification_ratio = 1.0; ///< of that, because these gains forgive less than those that ran
    DataQuality quality = {};         ///< of the record and of these gains
};

/// Figures of a motion behind its reference, for a table beside the picture.
struct MotionFigures {
    double rmsError_rad = 0.0;
    double finalError_rad = 0.0;
    std::optional<double> overshoot_rad; ///< beyond a reference that is level from its start
};
MotionFigures motionFigures(const std::vector<double>& reference_rad, const std::vector<double>& angle_rad);

/// Judges the record: some tenths of a second. Errors: Refused (a motor without covariance); of
/// plantFromEstimate, of the gains; not when the record is not explained, which `quality` says.
Result<WhatIfBasis> prepareWhatIf(WhatIfConfig config);

/// The recorded error through new gains on the identified loop: the same reference and, as a current, what
/// the identified loop does not explain of the recorded motion; thus the gains that ran give the record
/// again. Half a millisecond, without a band. Errors: Refused (the record is not explained; the new loop is
/// unstable); of the gains.
Result<WhatIf> whatIf(const WhatIfBasis& basis, const LoopLaw& law);

/// The same with its band: what holds three hundred motors with the friction of another run, both with what
/// each does not explain of the record, as if that came again, and without it. Some tenths of a second.
Result<WhatIf> whatIfWithBand(const WhatIfBasis& basis, const LoopLaw& law);

} // namespace halbench::app
