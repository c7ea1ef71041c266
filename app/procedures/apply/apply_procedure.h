#pragma once

#include "app/procedures/apply/effort_check.h"
#include "app/procedures/base/procedure.h"
#include "app/procedures/move/motion_envelope.h"
#include "app/procedures/move/move_procedure.h"
#include "app/procedures/tune/analyse.h"

#include <optional>
#include <vector>

namespace halbench::app {

/// How new gains prove themselves before they stay.
struct ApplyVerification {
    MoveReference reference;
    double duration_s = 3.0;
    MotorEstimate motor; ///< for the prediction of the ideal loop; needs c_over_J, Kf_over_J, phi_over_J or
                         ///< J, c, Kf, phi
    double overshootTolerance_percent = 8.0; ///< measured may exceed the prediction by this
    double errorTolerance_rad = 0.02;        ///< final error, likewise
    UncertaintyDraws draws;                  ///< of the motors whose motions make the band
    std::optional<MotionEnvelope> band;      ///< that the motion must keep to; absent: made of those motors
    double bandTolerance_rad = MotionTolerance_rad; ///< around the band of those motors
    /// Of a device with several: then all numbers are in the units of the axis, and its effort limit is that
    /// of the prediction.
    std::optional<devices::AxisSpec> axis = {};
    double effortLimit = 0.0;
};

/// As `tune --apply` and the Tune panel verify: a step of half a radian, 29 degrees.
ApplyVerification stepVerification(const MotorEstimate& motor);

/// How far and how long the rotor moves when it verifies.
MoveOutlook verificationOutlook(const ApplyVerification& verification, const devices::Catalogue& catalogue);

struct ApplyConfig {
    std::vector<ParameterValue> values;
    std::optional<ApplyVerification> verification;
};

/// How the measured verification lies beside its prediction. Angles from the start.
struct VerificationBand {
    models::IdealTrace predicted;  ///< of the law as the device has it
    double friction_rad = 0.0;     ///< friction may hold the rotor so far from its reference
    double allowed_rad = 0.0;      ///< error at the end of a step, rms error of other shapes
    double largestOff_rad = 0.0;   ///< measured - predicted where they differ most
    double largestOffTime_s = 0.0; ///< and when that was
    std::optional<double> allowedOvershoot_percent;
    /// Of the band that the uncertainty of the motor allows, by what the motion needs; up to 1 is inside.
    double widening_ratio = 0.0;
    std::optional<EffortAgreement> effort = {}; ///< of a step of a device with several axes
};

struct ApplyResult {
    std::vector<ParameterValue> before;
    std::vector<ParameterValue> after; ///< as read back
    std::optional<MoveFigures> predicted;
    std::optional<MoveResult> verification;
    std::optional<VerificationBand> band; ///< with the verification
    bool isKept = false;                  ///< false: the old values run again, `quality` says why
    DataQuality quality;
};

/// One transaction: snapshot, range and finite checks, write, read back, verification move, keep or restore.
/// Walks Prepare, Propose, Apply, Verify, Done or Restored. Errors: UnknownName, NotFinite, OutOfRange
/// (before the first byte is sent), of the device, of the abort; the old values run again after each of them.
Result<ApplyResult> runApply(devices::Device& device, const ApplyConfig& config,
                             const ProcedureObserver& observer);

} // namespace halbench::app
