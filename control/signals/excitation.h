#pragma once

#include "control/base/result.h"

#include <vector>

namespace halbench::control {

/// Samples at 0, T, 2 T ... of an excitation of unit amplitude.
struct Sampling {
    double period_s = 0.01;
    double duration_s = 1.0;
};

/// sin of a phase whose frequency runs linearly from `from_Hz` to `to_Hz` over the duration.
/// Errors: NotFinite, OutOfRange (a frequency not below Nyquist, no duration, more than 10 million samples).
Result<std::vector<double>> chirp(const Sampling& sampling, double from_Hz, double to_Hz);

/// Sum of `count` equal sines at multiples of 1/duration, nearest to evenly spread over the band, with the
/// phases -pi k (k-1)/count of Schroeder (1970) that keep the peak low; scaled to a largest value of 1.
/// Periodic in the duration: no leakage. Errors: as chirp; OutOfRange when the band does not hold `count`
/// lines.
Result<std::vector<double>> multisine(const Sampling& sampling, double from_Hz, double to_Hz, int count);

/// Maximum-length binary sequence of +-1 from a shift register of `stages` (2 ... 16) bits, each bit held for
/// `hold` samples: (2^stages - 1) hold samples, one more +1 than -1 or the reverse, autocorrelation -1/N off
/// its peak. Errors: OutOfRange.
Result<std::vector<double>> binarySequence(int stages, int hold);

} // namespace halbench::control
