#include "control/base/parameter_spec.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench {
namespace {

std::string quantity(double value, const std::string& unit) {
    return unit.empty() ? fmt::format("{}", value) : fmt::format("{} {}", value, unit);
}

} // namespace

Result<void> checkParameterValue(const ParameterSpec& spec, double value) {
    if (spec.access == ParameterAccess::ReadOnly) {
        return failure(ErrorCode::DeviceRefused, fmt::format("parameter '{}' is read only", spec.name),
                       "leave it out");
    }
    if (!std::isfinite(value)) {
        return failure(ErrorCode::NotFinite, fmt::format("parameter '{}' needs a finite number", spec.name),
                       fmt::format("give a value from {} to {}", spec.min, quantity(spec.max, spec.unit)));
    }
    if (value < spec.min || value > spec.max) {
        return failure(
            ErrorCode::OutOfRange,
            fmt::format("parameter '{}' = {} is out of range", spec.name, quantity(value, spec.unit)),
            fmt::format("allowed is {} to {}", spec.min, quantity(spec.max, spec.unit)));
    }
    if (spec.isInteger && value != std::floor(value)) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("parameter '{}' = {} needs a whole number", spec.name, value),
                       fmt::format("allowed is {} to {}", spec.min, spec.max));
    }
    return {};
}

} // namespace halbench
