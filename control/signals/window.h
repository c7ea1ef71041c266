#pragma once

#include <cstddef>
#include <vector>

namespace halbench::control {

/// Weights against leakage (Harris 1978). All are of the periodic kind, for spectra.
enum class WindowShape { Rectangular, Hann, Hamming, Blackman, FlatTop };

/// `count` >= 1 weights.
std::vector<double> window(WindowShape shape, std::size_t count);

/// Mean of the weights: divide an amplitude read from a spectrum by it.
double coherentGain(const std::vector<double>& weights);

/// Width of the rectangular filter that passes as much white noise, in lines: 1 for Rectangular, 1.5 for
/// Hann.
double noiseBandwidth_lines(const std::vector<double>& weights);

} // namespace halbench::control
