#include "app/procedures/excite/travel_reference.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/excite/table_reference.h"

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

/// The key that says how large the movement is.
const char* sizeKey(Shape shape) {
    switch (shape) {
    case Shape::Circle:
    case Shape::Arc:
        return "radius";
    case Shape::Raster:
        return "width";
    case Shape::Line:
        return "length";
    default:
        return "amplitude";
    }
}

/// Codes of the board's path.shape.
double pathCode(Shape shape) {
    switch (shape) {
    case Shape::Circle:
        return 1.0;
    case Shape::Raster:
        return 2.0;
    case Shape::Arc:
        return 3.0;
    default:
        return 4.0; // Line
    }
}

control::PlanePathConfig::Shape pathShape(Shape shape) {
    switch (shape) {
    case Shape::Circle:
        return control::PlanePathConfig::Shape::Circle;
    case Shape::Raster:
        return control::PlanePathConfig::Shape::Raster;
    case Shape::Arc:
        return control::PlanePathConfig::Shape::Arc;
    default:
        return control::PlanePathConfig::Shape::Line;
    }
}

/// A figure that only this shape needs.
Result<void> checkOwnFigures(const MoveReference& reference) {
    if (reference.shape == Shape::SCurve && !reference.jerk) {
        return missing(reference, keyOf(reference, "jerk", "_s3"));
    }
    if (reference.shape == Shape::Raster && reference.count > 1 && reference.pitch == 0.0) {
        return missing(reference, keyOf(reference, "pitch", ""));
    }
    if (reference.shape == Shape::Arc && reference.angle_rad.value_or(0.0) == 0.0) {
        return missing(reference, "angle_deg");
    }
    if (reference.shape == Shape::Arc && reference.amplitude < 0.0) {
        return failure(ErrorCode::InvalidInput, "the radius of an arc is positive",
                       "The sign of angle_deg says whether it bends to the left (positive) or to the right.");
    }
    return {};
}

} // namespace

bool isTravel(const MoveReference& reference) {
    return reference.shape == Shape::Trapezoid || reference.shape == Shape::SCurve;
}

bool isPath(const MoveReference& reference) {
    return reference.shape == Shape::Circle || reference.shape == Shape::Raster ||
           reference.shape == Shape::Arc || reference.shape == Shape::Line;
}

Result<void> checkTravel(const MoveReference& reference) {
    if (reference.amplitude == 0.0) {
        return missing(reference, keyOf(reference, sizeKey(reference.shape), ""));
    }
    if (!(reference.rate > 0.0)) {
        return missing(reference, keyOf(reference, "rate", "_s"));
    }
    if (!(reference.acceleration > 0.0)) {
        return missing(reference, keyOf(reference, "acceleration", "_s2"));
    }
    if (auto own = checkOwnFigures(reference); !own) {
        return own;
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
    config.shape = pathShape(reference.shape);
    config.radius = reference.amplitude;
    config.turns = reference.count;
    config.width = reference.amplitude;
    config.pitch = reference.pitch;
    config.lines = reference.count;
    config.angle_rad = reference.angle_rad.value_or(0.0);
    config.heading_rad = reference.heading_rad.value_or(0.0);
    config.length = reference.amplitude;
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
    if (reference.table) {
        return reference.table->motion.duration_s();
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
    return path ? std::max(path->span().front().reach(), path->span().back().reach()) : 0.0;
}

std::vector<ParameterValue> pathParameters(const MoveReference& reference) {
    std::vector<ParameterValue> values = {
        {PathShape, pathCode(reference.shape)},
        {"path.profile", reference.jerk ? 1.0 : 0.0},
        {std::string("path.") + sizeKey(reference.shape), reference.amplitude},
        {"path.speed", reference.rate},
        {"path.acceleration", reference.acceleration}};
    const double count = reference.count;
    if (reference.jerk) {
        values.push_back({"path.jerk", *reference.jerk});
    }
    if (reference.shape == Shape::Circle) {
        values.push_back({"path.turns", count});
    } else if (reference.shape == Shape::Raster) {
        values.push_back({"path.lines", count});
        if (reference.count > 1) {
            values.push_back({"path.pitch", reference.pitch});
        }
    } else {
        values.push_back({"path.heading", reference.heading_rad.value_or(0.0)});
    }
    if (reference.shape == Shape::Arc) {
        values.push_back({"path.angle", reference.angle_rad.value_or(0.0)});
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
