#include "app/procedures/excite/move_reference.h"

#include "app/procedures/excite/move_reference_keys.h"
#include "app/procedures/excite/table_reference.h"
#include "app/procedures/excite/travel_reference.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace halbench::app {
namespace {

using enum MoveReference::Shape;
using Quantity = MoveReference::Quantity;

constexpr std::array<std::string_view, 14> ShapeNames = {
    "step",    "ramp",   "sine",   "staircase", "chirp", "multisine", "trapezoid",
    "s-curve", "circle", "raster", "arc",       "line",  "table",     "rest"};
constexpr std::array<MoveReference::Shape, ShapeNames.size()> Shapes = {
    Step, Ramp, Sine, Staircase, Chirp, Multisine, Trapezoid, SCurve, Circle, Raster, Arc, Line, Table, Rest};

Result<void> need(bool isThere, MoveReference::Shape shape, const std::string& key) {
    if (isThere) {
        return {};
    }
    return failure(ErrorCode::InvalidInput, fmt::format("a {} needs {}", moveShapeName(shape), key),
                   fmt::format("Add {}=... to the reference.", key));
}

/// A size or rate, whose key says in what: an angle or a length. Nothing that was given may say it yet.
Result<void> needSize(bool isThere, const MoveReference& reference, const char* name, const char* per = "") {
    if (isThere || reference.quantity == Quantity::Angle) {
        return need(isThere, reference.shape, fmt::format("{}_deg{}", name, per));
    }
    if (reference.quantity == Quantity::Length) {
        return need(isThere, reference.shape, fmt::format("{}_mm{}", name, per));
    }
    return failure(
        ErrorCode::InvalidInput,
        fmt::format("a {} needs {}_deg{} or {}_mm{}", moveShapeName(reference.shape), name, per, name, per),
        fmt::format("Add {}_deg{}=... or {}_mm{}=... to the reference.", name, per, name, per));
}

/// An angle or heading that the shape does not have would be left out unseen.
Result<void> checkDirections(const MoveReference& reference) {
    const bool isArc = reference.shape == Arc;
    const bool hasHeading = isArc || reference.shape == Line;
    if ((!reference.angle_rad || isArc) && (!reference.heading_rad || hasHeading)) {
        return {};
    }
    return failure(ErrorCode::InvalidInput,
                   fmt::format("a {} has no {}", moveShapeName(reference.shape),
                               reference.angle_rad && !isArc ? "angle_deg" : "heading_deg"),
                   "An arc has angle_deg and heading_deg, a line has heading_deg.");
}

Result<void> checkTableOnly(const MoveReference& reference) {
    if (isTable(reference) || (reference.file.empty() && reference.dwell_s == 0.0)) {
        return {};
    }
    return failure(ErrorCode::InvalidInput,
                   fmt::format("a {} has no {}", moveShapeName(reference.shape),
                               reference.file.empty() ? "dwell_s" : "file"),
                   "Only a table has a file of poses and dwells in them.");
}

Result<void> applyPair(MoveReference& reference, std::string_view pair) {
    const std::size_t equals = pair.find('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == pair.size()) {
        return failure(
            ErrorCode::InvalidInput, fmt::format("'{}' is not KEY=VALUE", pair),
            "Write a reference like step,amplitude_deg=100. Known keys: " + moveReferenceKeyNames() + ".");
    }
    const std::string_view text = pair.substr(equals + 1);
    if (pair.substr(0, equals) == FileKey) {
        return setMoveReferenceFile(reference, text);
    }
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, status] = std::from_chars(text.data(), end, value);
    if (status != std::errc() || stop != end) {
        return failure(ErrorCode::InvalidInput, fmt::format("'{}' is not a number", text),
                       fmt::format("Write {}=1.5.", pair.substr(0, equals)));
    }
    return setMoveReference(reference, pair.substr(0, equals), value);
}

} // namespace

std::span<const std::string_view> moveShapeNames() {
    return ShapeNames;
}

std::string_view moveShapeName(MoveReference::Shape shape) {
    return ShapeNames[static_cast<std::size_t>(std::find(Shapes.begin(), Shapes.end(), shape) -
                                               Shapes.begin())];
}

Result<MoveReference::Shape> moveShape(std::string_view name) {
    const auto found = std::find(ShapeNames.begin(), ShapeNames.end(), name);
    if (found == ShapeNames.end()) {
        return failure(ErrorCode::UnknownName, fmt::format("there is no reference shape '{}'", name),
                       fmt::format("Known shapes: {}.", fmt::join(ShapeNames, ", ")));
    }
    return Shapes[static_cast<std::size_t>(found - ShapeNames.begin())];
}

Result<MoveReference> parseMoveReference(const std::string& text) {
    const std::size_t firstComma = std::min(text.find(','), text.size());
    const auto shape = moveShape(std::string_view(text).substr(0, firstComma));
    if (!shape) {
        return failure(shape.error());
    }
    MoveReference reference;
    reference.shape = *shape;
    std::string_view rest = std::string_view(text).substr(std::min(firstComma + 1, text.size()));
    std::vector<std::string_view> seen;
    while (!rest.empty()) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        const std::string_view pair = rest.substr(0, comma);
        const std::string_view key = pair.substr(0, pair.find('='));
        if (std::find(seen.begin(), seen.end(), key) != seen.end()) {
            return failure(ErrorCode::InvalidInput, fmt::format("reference: '{}' is given twice", key),
                           "give every key once");
        }
        seen.push_back(key);
        if (auto applied = applyPair(reference, pair); !applied) {
            return failure(applied.error());
        }
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    if (auto complete = checkMoveReference(reference); !complete) {
        return failure(complete.error());
    }
    return reference;
}

Result<void> checkMoveReference(const MoveReference& reference) {
    using Shape = MoveReference::Shape;
    if (auto used = checkDirections(reference); !used) {
        return used;
    }
    if (auto used = checkTableOnly(reference); !used) {
        return used;
    }
    const bool hasAmplitude = reference.amplitude != 0.0;
    switch (reference.shape) {
    case Shape::Step:
    case Shape::Staircase:
        return needSize(hasAmplitude, reference, "amplitude");
    case Shape::Ramp:
        return needSize(reference.rate != 0.0, reference, "rate", "_s");
    case Shape::Sine:
        if (auto amplitude = needSize(hasAmplitude, reference, "amplitude"); !amplitude) {
            return amplitude;
        }
        return need(reference.frequency_Hz > 0.0, reference.shape, "frequency_hz");
    case Shape::Chirp:
    case Shape::Multisine:
        if (auto amplitude = needSize(hasAmplitude, reference, "amplitude"); !amplitude) {
            return amplitude;
        }
        if (auto first = need(reference.frequency_Hz > 0.0, reference.shape, "frequency_hz"); !first) {
            return first;
        }
        return need(reference.frequencyEnd_Hz > 0.0, reference.shape, "frequency_end_hz");
    case Shape::Trapezoid:
    case Shape::SCurve:
    case Shape::Circle:
    case Shape::Raster:
    case Shape::Arc:
    case Shape::Line:
        return checkTravel(reference);
    case Shape::Table:
        return checkTableKeys(reference);
    case Shape::Rest:
        break;
    }
    return {};
}

Result<void> checkQuantity(const MoveReference& reference, const devices::AxisSpec& axis) {
    const bool isAngle = axis.positionUnit == "rad";
    const Quantity wanted = isAngle ? Quantity::Angle : Quantity::Length;
    if (reference.quantity == Quantity::Unknown || reference.quantity == wanted) {
        return {};
    }
    return failure(ErrorCode::InvalidInput,
                   isAngle ? fmt::format("axis {} is rotary, but the reference is a length", axis.id)
                           : fmt::format("axis {} is linear, but the reference is an angle", axis.id),
                   isAngle ? "Write it as an angle, e.g. amplitude_mrad=1 or amplitude_deg=1."
                           : "Write it as a length, e.g. amplitude_um=100 or amplitude_mm=1.");
}

double referenceExcursion(const MoveReference& reference, double duration_s, std::string_view axis) {
    using Shape = MoveReference::Shape;
    double excursion = std::fabs(reference.amplitude);
    if (reference.shape == Shape::Ramp) {
        const double reached = std::fabs(reference.rate) * duration_s;
        excursion = reference.amplitude == 0.0 ? reached : std::min(excursion, reached);
    } else if (reference.shape == Shape::Staircase) {
        excursion *=
            std::min(1.0 + std::floor(duration_s / reference.period_s), static_cast<double>(reference.count));
    } else if (reference.shape == Shape::Multisine) {
        excursion *= std::sqrt(2.0 * reference.count); // all lines at their peak together
    } else if (isPath(reference)) {
        return pathReach(reference);
    } else if (isTable(reference)) {
        return tableReach(reference, axis);
    }
    return excursion + std::fabs(reference.base) * duration_s;
}

std::optional<double> referenceAt(const MoveReference& reference, double time_s, std::string_view axis) {
    using Shape = MoveReference::Shape;
    const double base = reference.base * time_s;
    switch (reference.shape) {
    case Shape::Step:
        return reference.amplitude + base;
    case Shape::Ramp: {
        const double end = std::fabs(reference.amplitude);
        const double ramp = reference.rate * time_s;
        return (end > 0.0 ? std::clamp(ramp, -end, end) : ramp) + base;
    }
    case Shape::Sine:
        return reference.amplitude * std::sin(2.0 * Pi * reference.frequency_Hz * time_s) + base;
    case Shape::Staircase: {
        const double steps = 1.0 + std::floor(time_s / reference.period_s + 1e-9);
        return reference.amplitude * std::min(steps, static_cast<double>(reference.count)) + base;
    }
    case Shape::Trapezoid:
    case Shape::SCurve:
        return travelPointAt(reference, time_s);
    case Shape::Table:
        return tablePointAt(reference, time_s, axis);
    case Shape::Rest:
        return 0.0;
    case Shape::Chirp:
    case Shape::Multisine:
    case Shape::Circle:
    case Shape::Raster:
    case Shape::Arc:
    case Shape::Line:
        break;
    }
    return std::nullopt;
}

std::vector<ParameterValue> generatorParameters(const MoveReference& reference, double duration_s,
                                                const std::string& generator) {
    using Shape = MoveReference::Shape;
    const bool isSwept = reference.shape == Shape::Chirp || reference.shape == Shape::Multisine;
    // A second more, so that the generator does not end while the last samples are on their way.
    const double generator_s = isSwept ? duration_s : duration_s + 1.0;
    if (isPath(reference)) {
        return pathParameters(reference);
    }
    if (isTable(reference)) {
        return tableParameters(reference);
    }
    const Shape shape = reference.shape == Shape::Rest ? Shape::Step : reference.shape; // of no height
    std::vector<ParameterValue> values = {{generator + ".shape", static_cast<double>(shape)},
                                          {generator + ".amplitude", reference.amplitude},
                                          {generator + ".rate", reference.rate},
                                          {generator + ".frequency", reference.frequency_Hz},
                                          {generator + ".frequency_end", reference.frequencyEnd_Hz},
                                          {generator + ".period", reference.period_s},
                                          {generator + ".count", static_cast<double>(reference.count)},
                                          {generator + ".duration", generator_s},
                                          {generator + ".base", reference.base},
                                          {generator + ".seed", static_cast<double>(reference.seed)}};
    if (isTravel(reference)) {
        values.push_back({generator + ".acceleration", reference.acceleration});
        if (reference.shape == Shape::SCurve) {
            values.push_back({generator + ".jerk", *reference.jerk});
        }
    }
    return values;
}

std::optional<control::LoopReference> idealReference(const MoveReference& reference) {
    using Shape = MoveReference::Shape;
    control::LoopReference ideal{control::LoopReference::Shape::Step,
                                 reference.amplitude,
                                 reference.rate,
                                 reference.frequency_Hz,
                                 reference.period_s,
                                 reference.count};
    switch (reference.shape) {
    case Shape::Step:
        break;
    case Shape::Ramp:
        ideal.shape = control::LoopReference::Shape::Ramp;
        break;
    case Shape::Sine:
        ideal.shape = control::LoopReference::Shape::Sine;
        break;
    case Shape::Staircase:
        ideal.shape = control::LoopReference::Shape::Staircase;
        break;
    case Shape::Chirp:
    case Shape::Multisine:
    case Shape::Trapezoid:
    case Shape::SCurve:
    case Shape::Circle:
    case Shape::Raster:
    case Shape::Arc:
    case Shape::Line:
    case Shape::Table:
    case Shape::Rest:
        return std::nullopt;
    }
    return reference.base == 0.0 ? std::optional(ideal) : std::nullopt;
}

} // namespace halbench::app
