#include "app/procedures/base/axis_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace halbench::app {
namespace {

Result<void> checkEstimate(const std::string& name, const control::Estimate& estimate,
                           const std::string& unit, bool isZeroAllowed) {
    if (!estimate.value) {
        return {};
    }
    if (estimate.unit != unit) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{} is in \"{}\", not in \"{}\"", name, estimate.unit, unit),
                       "use the unit of the axis");
    }
    const auto& interval = estimate.interval95;
    if (!std::isfinite(*estimate.value) ||
        (interval && (!std::isfinite(interval->first) || !std::isfinite(interval->second)))) {
        return failure(ErrorCode::NotFinite, name + " is not a finite number", "identify the axis again");
    }
    if (*estimate.value < 0.0 || (!isZeroAllowed && *estimate.value == 0.0)) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("{} = {:.4g} must {}", name, *estimate.value,
                                   isZeroAllowed ? "not be negative" : "be positive"),
                       "identify the axis again");
    }
    return {};
}

Result<void> checkAxis(const IdentifiedAxis& axis) {
    if (axis.axis.empty()) {
        return failure(ErrorCode::InvalidInput, "an axis of the model has no name", "name every axis");
    }
    if (axis.positionUnit != "rad" && axis.positionUnit != "m") {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("axis {}: \"{}\" is not a position unit", axis.axis, axis.positionUnit),
                       "use rad or m");
    }
    if (!axis.dampingRate.value || !axis.accelerationGain.value) {
        const char* missing = axis.accelerationGain.value ? "damping rate" : "acceleration gain";
        return failure(ErrorCode::Refused, fmt::format("axis {}: unknown {}", axis.axis, missing),
                       "identify the axis again");
    }
    const std::string name = "axis " + axis.axis;
    for (const auto& valid :
         {checkEstimate(name + ": damping rate", axis.dampingRate, "1/s", true),
          checkEstimate(name + ": acceleration gain", axis.accelerationGain, accelerationGainUnit(axis),
                        false),
          checkEstimate(name + ": breakaway effort", axis.breakawayEffort, axis.effortUnit, true)}) {
        if (!valid) {
            return valid;
        }
    }
    const control::LoopTiming timing = timingOr(axis.timing, {});
    const auto valid = control::checkTiming(timing);
    return valid ? valid
                 : failure(valid.error().code, name + ": " + valid.error().message, valid.error().hint);
}

Result<void> checkCovariance(const AxisModel& model) {
    std::set<std::string> known;
    for (const IdentifiedAxis& axis : model.axes) {
        for (const char* quantity : {".damping_rate", ".acceleration_gain", ".breakaway_effort"}) {
            known.insert(axis.axis + quantity);
        }
    }
    const std::size_t size = model.covarianceNames.size();
    for (const std::string& name : model.covarianceNames) {
        if (known.erase(name) == 0) {
            return failure(
                ErrorCode::InvalidInput,
                fmt::format(
                    "the covariance contains '{}', which is not a quantity of the model or occurs twice",
                    name),
                "name AXIS.damping_rate, AXIS.acceleration_gain, AXIS.breakaway_effort");
        }
    }
    const bool isSquare =
        model.covariance.size() == size &&
        std::all_of(model.covariance.begin(), model.covariance.end(), [size](const auto& row) {
            return row.size() == size &&
                   std::all_of(row.begin(), row.end(), [](double value) { return std::isfinite(value); });
        });
    return isSquare ? Result<void>()
                    : failure(ErrorCode::InvalidInput,
                              "the covariance needs as many rows and columns of finite numbers as names",
                              "identify the axes again");
}

} // namespace

const IdentifiedAxis* AxisModel::find(const std::string& axis) const {
    const auto found =
        std::find_if(axes.begin(), axes.end(), [&](const auto& candidate) { return candidate.axis == axis; });
    return found == axes.end() ? nullptr : &*found;
}

std::string accelerationGainUnit(const IdentifiedAxis& axis) {
    return fmt::format("{}/(s^2*{})", axis.positionUnit, axis.effortUnit);
}

Result<void> checkAxisModel(const AxisModel& model) {
    if (model.axes.empty()) {
        return failure(ErrorCode::InvalidInput, "the model has no axis", "identify the axes again");
    }
    std::set<std::string> names;
    for (const IdentifiedAxis& axis : model.axes) {
        if (const auto valid = checkAxis(axis); !valid) {
            return valid;
        }
        if (!names.insert(axis.axis).second) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("axis {} occurs twice in the model", axis.axis), "remove one of them");
        }
    }
    return checkCovariance(model);
}

} // namespace halbench::app
