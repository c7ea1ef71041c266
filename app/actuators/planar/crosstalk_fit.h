#pragma once

#include "app/actuators/planar/platen_motion.h"

namespace halbench::app {

/// Field of the coil currents at the chips from pulses of one coil after the other (recordPulses): in each
/// burst every reading is a cubic in time, a share of the current, and a share of its second integral, by
/// which the current moves the platen meanwhile. No pose and no calibration enters.
/// Errors: Refused (a coil without 30 rows of pulses).
Result<Eigen::Matrix<double, models::FieldCount, models::CoilCount>>
fitCrosstalk_T_per_A(const PlatenMotion& pulses);

} // namespace halbench::app
