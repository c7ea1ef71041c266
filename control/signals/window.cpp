#include "control/signals/window.h"

#include "control/base/assert.h"
#include "control/base/units.h"

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
    case WindowShape::FlatTop:
        return {0.21557895, 0.41663158, 0.277263158, 0.083578947, 0.006947368};
    case WindowShape::Rectangular:
        break;
    }
    return {1.0};
}

} // namespace

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
