#pragma once

#include "control/base/result.h"
#include "control/lti/transfer_function.h"

namespace halbench::control {

/// Continuous filters for a loop; `discretize` with Tustin pre-warped at the frequency keeps what they are
/// for. Errors of all: NotFinite, OutOfRange (frequency, ratio or angle that is not possible).

/// Lead: most phase, `phase_deg` (below 90), at the frequency, where the magnitude stays 1. With
/// r = (1 + sin phi)/(1 - sin phi):  F = (1/sqrt r) (1 + sqrt r s/w)/(1 + s/(sqrt r w)); a gain of 1/sqrt r
/// at rest and sqrt r far above: what the phase costs. Negative angles make the lag of the same shape.
Result<TransferFunction> leadFilter(double frequency_rad_s, double phase_deg);

/// Lag: (s + w)/(s + w/ratio): raises the gain at rest by `ratio` > 1, leaves it above w, and turns the phase
/// by at most -asin((ratio - 1)/(ratio + 1)) in between (5.7 degrees x (1 - 1/ratio) a decade above w).
Result<TransferFunction> lagFilter(double frequency_rad_s, double ratio);

/// Notch: (s^2 + 2 depth z w s + w^2)/(s^2 + 2 z w s + w^2): magnitude `depth_ratio` (0 to 1) at the
/// frequency, half of the full depth's width is z; 1 at rest and far above.
Result<TransferFunction> notchFilter(double frequency_rad_s, double depth_ratio, double damping_ratio);

/// Low-pass of order 1 or 2 (Butterworth, damping 1/sqrt 2): -3 dB at the corner.
Result<TransferFunction> lowPassFilter(double corner_rad_s, int order);

} // namespace halbench::control
