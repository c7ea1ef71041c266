#include "app/procedures/excite/travel_reference.h"

#include "app/procedures/base/axis_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace halbench::app {
namespace {

using Shape = MoveReference::Shape;

constexpr double LoopPeriod_s = 1e-3;
constexpr double Rest_s = 1.0;
constexpr double NoiseWindow_s = 0.5;
constexpr const char* PathShape = "path.shape";
constexpr double CirclePath = 1.0; // codes of that parameter
constexpr double RasterPath = 2.0;

control::TravelLimits limitsOf(const MoveReference& reference) {
    const bool isTrapezoid = reference.shape == Shape::Trapezoid;
    return {reference.rate, reference.acceleration, isTrapezoid ? std::nullopt : reference.jerk};
}

tl::unexpected<Error> missing(const MoveReference& reference, const std::string& key) {
    return failure(ErrorCode::InvalidInput, fmt::format("a {} needs {}", moveShapeName(reference.shape), key),
                   fmt::format("Add {}=... to the reference.", key));
}

/// A key in the unit that the rest is written in.
std::string keyOf(const MoveReference& reference, const char* name, const char* per) {
    const bool isAngle = reference.quantity == MoveReference::Quantity::Angle;
    return fmt::format("{}_{}{}", name, isAngle ? "rad" : "m", per);
}

} // namespace

bool isTravel(const MoveReference& reference) {
    return reference.shape == Shape::Trapezoid || reference.shape == Shape::SCurve;
}

bool isPath(const MoveReference& reference) {
    return reference.shape == Shape::Circle || reference.shape == Shape::Raster;
}

Result<void> checkTravel(const MoveReference& reference) {
    if (reference.amplitude == 0.0) {
        return missing(reference, keyOf(reference,
                                        reference.shape == Shape::Circle   ? "radius"
                                        : reference.shape == Shape::Raster ? "width"
                                                                           : "amplitude",
                                        ""));
    }
    if (!(reference.rate > 0.0)) {
        return missing(reference, keyOf(reference, "rate", "_s"));
    }
    if (!(reference.acceleration > 0.0)) {
        return missing(reference, keyOf(reference, "acceleration", "_s2"));
    }
    if (reference.shape == Shape::SCurve && !reference.jerk) {
        return missing(reference, keyOf(reference, "jerk", "_s3"));
    }
    if (reference.shape == Shape::Raster && reference.count > 1 && reference.pitch == 0.0) {
        return missing(reference, keyOf(reference, "pitch", ""));
    }
    if (reference.base != 0.0) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("a {} has no constant motion", moveShapeName(reference.shape)),
                       "Leave base out.");
    }
    if (isPath(reference)) {
        const auto path = planePath(reference);
        return path ? Result<void>() : failure(path.error());
    }
    const auto profile = travelProfile(reference);
    return profile ? Result<void>() : failure(profile.error());
}

Result<control::TravelProfile> travelProfile(const MoveReference& reference) {
    return control::TravelProfile::solve(reference.amplitude, limitsOf(reference));
}

Result<control::PlanePath> planePath(const MoveReference& reference) {
    control::PlanePathConfig config;
    const bool isCircle = reference.shape == Shape::Circle;
    config.shape =
        isCircle ? control::PlanePathConfig::Shape::Circle : control::PlanePathConfig::Shape::Raster;
    config.radius = reference.amplitude;
    config.turns = reference.count;
    config.width = reference.amplitude;
    config.pitch = reference.pitch;
    config.lines = reference.count;
    config.limits = limitsOf(reference);
    return control::PlanePath::make(config, LoopPeriod_s);
}

std::optional<double> travelTime_s(const MoveReference& reference) {
    if (isTravel(reference)) {
        const auto profile = travelProfile(reference);
        return profile ? std::optional(profile->duration_s()) : std::nullopt;
    }
    if (isPath(reference)) {
        const auto path = planePath(reference);
        return path ? std::optional(path->duration_s()) : std::nullopt;
    }
    return std::nullopt;
}

std::optional<double> defaultDuration_s(const MoveReference& reference) {
    const std::optional<double> travel_s = travelTime_s(reference);
    return travel_s ? std::optional(std::ceil(1e3 * (*travel_s + Rest_s) - 1e-6) / 1e3) : std::nullopt;
}

double restWindow_s(const MoveReference& reference, double duration_s) {
    return reference.shape == Shape::Rest ? duration_s : std::min(NoiseWindow_s, duration_s);
}

std::optional<double> travelPointAt(const MoveReference& reference, double time_s) {
    const auto profile = travelProfile(reference);
    return profile ? std::optional(profile->at(time_s).value) : std::nullopt;
}

double pathReach(const MoveReference& reference) {
    const auto path = planePath(reference);
    return path ? std::max(path->reach().front(), path->reach().back()) : 0.0;
}

std::vector<ParameterValue> pathParameters(const MoveReference& reference) {
    const bool isCircle = reference.shape == Shape::Circle;
    const double count = reference.count;
    std::vector<ParameterValue> values = {{PathShape, isCircle ? CirclePath : RasterPath},
                                          {"path.profile", reference.jerk ? 1.0 : 0.0},
                                          {isCircle ? "path.radius" : "path.width", reference.amplitude},
                                          {isCircle ? "path.turns" : "path.lines", count},
                                          {"path.speed", reference.rate},
                                          {"path.acceleration", reference.acceleration}};
    if (reference.jerk) {
        values.push_back({"path.jerk", *reference.jerk});
    }
    if (!isCircle && reference.count > 1) {
        values.push_back({"path.pitch", reference.pitch});
    }
    return values;
}

Result<void> checkGenerator(const devices::Catalogue& catalogue, const devices::AxisSpec& axis,
                            const MoveReference& reference) {
    const ParameterSpec* shape = catalogue.findParameter(axis.generator + ".shape");
    if (isPath(reference) || !isTravel(reference) || shape == nullptr ||
        static_cast<double>(reference.shape) <= shape->max) {
        return {};
    }
    return failure(ErrorCode::InvalidInput,
                   fmt::format("the generator of axis {} has no {}", axis.id, moveShapeName(reference.shape)),
                   fmt::format("It has {}.", fmt::join(shape->choices, ", ")));
}

Result<std::array<devices::AxisSpec, 2>> pathAxes(const devices::Catalogue& catalogue) {
    std::vector<devices::AxisSpec> along;
    for (const devices::AxisSpec& axis : axesOf(catalogue)) {
        if (axis.positionUnit == "m") {
            along.push_back(axis);
        }
    }
    if (along.size() < 2 || catalogue.findParameter(PathShape) == nullptr) {
        return failure(ErrorCode::InvalidInput, "this device follows no path of two axes",
                       "Move one axis: a step, a trapezoid, an s-curve.");
    }
    return std::array<devices::AxisSpec, 2>{along[0], along[1]};
}

} // namespace halbench::app
