#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace halbench::control {

/// Weights against leakage (Harris 1978). All are of the periodic kind, for spectra.
enum class WindowShape { Rectangular, Hann, Hamming, Blackman, BlackmanHarris, FlatTop };

/// What files and the command line call a window, and its figures for long segments.
struct WindowFigures {
    WindowShape shape;
    std::string_view name;       ///< "blackman-harris"
    double coherentGain;         ///< as coherentGain()
    double noiseBandwidth_lines; ///< as noiseBandwidth_lines()
    double scalloping_dB;        ///< how much too low a sine half way between two lines reads
    std::size_t halfLobe_lines;  ///< from the middle of the main lobe to its first zero
};

/// All windows in the order of the enumeration.
std::span<const WindowFigures> windowFigures();
const WindowFigures& figuresOf(WindowShape shape);
/// The window of that name.
std::optional<WindowShape> findWindow(std::string_view name);

/// `count` >= 1 weights.
std::vector<double> window(WindowShape shape, std::size_t count);

/// Mean of the weights: divide an amplitude read from a spectrum by it.
double coherentGain(const std::vector<double>& weights);

/// Width of the rectangular filter that passes as much white noise, in lines: 1 for Rectangular, 1.5 for
/// Hann.
double noiseBandwidth_lines(const std::vector<double>& weights);

} // namespace halbench::control
