#pragma once

#include "app/actuators/htm/motor_analysis.h"

#include <optional>

namespace halbench::app {

struct FieldQuestion {
    double ringRadius_m = 33.71e-3; ///< bars with their corners inside diameter 76.4 mm
    double remanence_T = 1.32;      ///< N42
    double sensorRadius_m = 14.5e-3;
};
/// Field of the bars, cuboid by cuboid, against B0, and the remanence that B0 would need; one that no magnet
/// has is flagged (4.3, 6.11).
MotorAnalysis analyseField(const models::HtmParameters& motor, const FieldQuestion& question);

/// Winding and inductance of the reference coil of section 4.4, with what a wire pitch would mean
/// (6.12, 6.13). Errors: of the amplifier's parts.
Result<MotorAnalysis> analyseCoil(const models::HtmParameters& motor, std::optional<double> pitch_m);

} // namespace halbench::app
