#pragma once

#include "control/base/result.h"
#include "control/lti/dead_time.h"
#include "control/lti/delta_system.h"
#include "control/lti/transfer_function.h"

#include <complex>
#include <vector>

namespace halbench::control {

/// A point of the Nyquist curve for positive frequencies; the other half is its mirror image.
struct NyquistPoint {
    double frequency_rad_s = 0.0;
    std::complex<double> value;
    bool isIndented = false; ///< on the small arc that passes a pole on the axis on its right
};

/// Stability of the closed loop by Nyquist's criterion: the curve of L along the imaginary axis (sampled:
/// the unit circle) circles -1 as often as the open loop has unstable poles.
struct NyquistResult {
    std::vector<NyquistPoint> curve;
    int encirclements = 0;           ///< of -1, counter-clockwise, by the whole curve (both halves)
    int unstableOpenLoopPoles = 0;   ///< strictly beyond the axis; poles on it are passed on their right
    int unstableClosedLoopPoles = 0; ///< unstableOpenLoopPoles - encirclements
};

/// Walks the contour with steps that turn 1 + L by at most 45 degrees (halved until they do) and adds the
/// turns up, with the exact dead time. Poles on the axis are passed on arcs so small that |L| > 10 there, as
/// far as the digits of L allow. Errors: Refused (the curve runs through -1: the loop is on the limit of
/// stability), InvalidInput (behind a dead time L does not fall below 1: it circles without end).
Result<NyquistResult> nyquist(const TransferFunction& openLoop);
Result<NyquistResult> nyquist(const DeltaSystem& openLoop);
Result<NyquistResult> nyquist(const DeadTimeSystem& openLoop);

} // namespace halbench::control
