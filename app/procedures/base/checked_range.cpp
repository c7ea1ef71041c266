#include "app/procedures/base/checked_range.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::app {

Result<void> checkRange(const char* what, double value, double min, double max) {
    const auto refused = [&](ErrorCode code, const std::string& message) {
        return failure(code, message, fmt::format("allowed: {:.6g} to {:.6g}", min, max));
    };
    if (!std::isfinite(value)) {
        return refused(ErrorCode::NotFinite, fmt::format("{} is not a finite number", what));
    }
    if (value < min || value > max) {
        return refused(ErrorCode::OutOfRange, fmt::format("{} = {:.6g} is out of range", what, value));
    }
    return {};
}

} // namespace halbench::app
