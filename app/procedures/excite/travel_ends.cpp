#include "app/procedures/excite/travel_ends.h"

#include "app/procedures/excite/travel_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {

control::PathSpan referenceSpan(const MoveReference& reference, double duration_s, std::size_t pathAxis) {
    using Shape = MoveReference::Shape;
    if (isPath(reference)) {
        const auto path = planePath(reference);
        return path ? path->span().at(pathAxis) : control::PathSpan{};
    }
    control::PathSpan span;
    switch (reference.shape) {
    case Shape::Sine:
    case Shape::Chirp:
    case Shape::Multisine: {
        const double peak = referenceExcursion(reference, 0.0);
        span.include(peak);
        span.include(-peak);
        break;
    }
    case Shape::Staircase:
    case Shape::Ramp: {
        MoveReference alone = reference;
        alone.base = 0.0;
        const double way = referenceExcursion(alone, duration_s);
        const double sign = reference.shape == Shape::Ramp ? reference.rate : reference.amplitude;
        span.include(std::copysign(way, sign));
        break;
    }
    default:
        span.include(reference.amplitude);
        break;
    }
    const double drift = reference.base * duration_s;
    span.least += std::min(drift, 0.0);
    span.most += std::max(drift, 0.0);
    return span;
}

std::optional<double> placeBeyondEnd(const AxisTravel& axis, const control::PathSpan& span) {
    std::optional<double> place;
    if (span.most > 0.0 && axis.position + span.most > axis.travel) {
        place = axis.position + span.most;
    }
    if (span.least < 0.0 && axis.position + span.least < -axis.travel &&
        !(place && *place > -(axis.position + span.least))) {
        place = axis.position + span.least;
    }
    return place;
}

Result<void> checkReferenceEnds(const AxisTravel& axis, const std::string& unit,
                                const control::PathSpan& span) {
    const auto place = placeBeyondEnd(axis, span);
    if (!place) {
        return {};
    }
    return failure(ErrorCode::OutOfRange,
                   fmt::format("axis {} would come to {:.4g} {}, its travel ends at {:.4g} {}", axis.axis,
                               *place, unit, std::copysign(axis.travel, *place), unit),
                   fmt::format("A reference counts from where the axis stands, now {:.4g} {}: move it nearer "
                               "to the middle first, or less far. Nothing moved.",
                               axis.position, unit));
}

} // namespace halbench::app
