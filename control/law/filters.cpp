#include "control/law/filters.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::control {

namespace {

Result<void> check(double value, double above, double below) {
    if (!std::isfinite(value)) {
        return failure(ErrorCode::NotFinite, "a figure of the filter is not a finite number");
    }
    if (value <= above || value >= below) {
        return failure(ErrorCode::OutOfRange, fmt::format("invalid filter: {} is out of range", value));
    }
    return {};
}

constexpr double MostFrequency_rad_s = 1e12;

} // namespace

Result<TransferFunction> leadFilter(double frequency_rad_s, double phase_deg) {
    for (const auto& valid :
         {check(frequency_rad_s, 0.0, MostFrequency_rad_s), check(phase_deg, -90.0, 90.0)}) {
        if (!valid) {
            return failure(valid.error());
        }
    }
    const double sine = std::sin(degreesToRadians(phase_deg));
    const double root = std::sqrt((1.0 + sine) / (1.0 - sine));
    return TransferFunction::make({1.0 / frequency_rad_s, 1.0 / root}, {1.0 / (root * frequency_rad_s), 1.0},
                                  TimeBase::continuous());
}

Result<TransferFunction> lagFilter(double frequency_rad_s, double ratio) {
    for (const auto& valid : {check(frequency_rad_s, 0.0, MostFrequency_rad_s), check(ratio, 1.0, 1e9)}) {
        if (!valid) {
            return failure(valid.error());
        }
    }
    return TransferFunction::make({1.0, frequency_rad_s}, {1.0, frequency_rad_s / ratio},
                                  TimeBase::continuous());
}

Result<TransferFunction> notchFilter(double frequency_rad_s, double depth_ratio, double damping_ratio) {
    for (const auto& valid : {check(frequency_rad_s, 0.0, MostFrequency_rad_s),
                              check(depth_ratio, -1e-300, 1.0), check(damping_ratio, 0.0, 10.0)}) {
        if (!valid) {
            return failure(valid.error());
        }
    }
    const double square = frequency_rad_s * frequency_rad_s;
    const double width = 2.0 * damping_ratio * frequency_rad_s;
    return TransferFunction::make({1.0, depth_ratio * width, square}, {1.0, width, square},
                                  TimeBase::continuous());
}

Result<TransferFunction> lowPassFilter(double corner_rad_s, int order) {
    for (const auto& valid : {check(corner_rad_s, 0.0, MostFrequency_rad_s), check(order, 0.0, 3.0)}) {
        if (!valid) {
            return failure(valid.error());
        }
    }
    const double w = corner_rad_s;
    return order == 1
               ? TransferFunction::make({w}, {1.0, w}, TimeBase::continuous())
               : TransferFunction::make({w * w}, {1.0, std::sqrt(2.0) * w, w * w}, TimeBase::continuous());
}

} // namespace halbench::control
