#include "control/signals/window.h"

#include "control/base/assert.h"
#include "control/base/units.h"

#include <array>
#include <cmath>

namespace halbench::control {

namespace {

/// a_0 - a_1 cos x + a_2 cos 2x - ...
std::vector<double> cosineCoefficients(WindowShape shape) {
    switch (shape) {
    case WindowShape::Hann:
        return {0.5, 0.5};
    case WindowShape::Hamming:
        return {0.54, 0.46};
    case WindowShape::Blackman:
        return {0.42, 0.5, 0.08};
    case WindowShape::BlackmanHarris: // four terms, side lobes below -92 dB
        return {0.35875, 0.48829, 0.14128, 0.01168};
    case WindowShape::FlatTop:
        return {0.21557895, 0.41663158, 0.277263158, 0.083578947, 0.006947368};
    case WindowShape::Rectangular:
        break;
    }
    return {1.0};
}

// Of the coefficients above: gain a_0, bandwidth 1 + sum (a_k / a_0)^2 / 2; scalloping is the transform of
// the window half a line off, over that on the line.
constexpr std::array Figures = {
    WindowFigures{WindowShape::Rectangular, "rectangular", 1.0, 1.0, 3.9224, 1},
    WindowFigures{WindowShape::Hann, "hann", 0.5, 1.5, 1.4236, 2},
    WindowFigures{WindowShape::Hamming, "hamming", 0.54, 1.36283, 1.7514, 2},
    WindowFigures{WindowShape::Blackman, "blackman", 0.42, 1.72676, 1.0989, 3},
    WindowFigures{WindowShape::BlackmanHarris, "blackman-harris", 0.35875, 2.00435, 0.8256, 4},
    WindowFigures{WindowShape::FlatTop, "flat-top", 0.21557895, 3.77025, 0.0098, 5},
};

} // namespace

std::span<const WindowFigures> windowFigures() {
    return Figures;
}

const WindowFigures& figuresOf(WindowShape shape) {
    return Figures[static_cast<std::size_t>(shape)];
}

std::optional<WindowShape> findWindow(std::string_view name) {
    for (const WindowFigures& figures : Figures) {
        if (figures.name == name) {
            return figures.shape;
        }
    }
    return std::nullopt;
}

std::vector<double> window(WindowShape shape, std::size_t count) {
    HB_ASSERT(count >= 1);
    const std::vector<double> coefficients = cosineCoefficients(shape);
    std::vector<double> weights(count, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
        const double x = 2.0 * Pi * static_cast<double>(i) / static_cast<double>(count);
        double sign = 1.0;
        for (std::size_t k = 0; k < coefficients.size(); ++k) {
            weights[i] += sign * coefficients[k] * std::cos(static_cast<double>(k) * x);
            sign = -sign;
        }
    }
    return weights;
}

double coherentGain(const std::vector<double>& weights) {
    HB_ASSERT(!weights.empty());
    double sum = 0.0;
    for (const double weight : weights) {
        sum += weight;
    }
    return sum / static_cast<double>(weights.size());
}

double noiseBandwidth_lines(const std::vector<double>& weights) {
    double squares = 0.0;
    for (const double weight : weights) {
        squares += weight * weight;
    }
    const double mean = coherentGain(weights);
    return squares / static_cast<double>(weights.size()) / (mean * mean);
}

} // namespace halbench::control
