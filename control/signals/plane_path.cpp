#include "control/signals/plane_path.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

using Shape = PlanePathConfig::Shape;

/// Along a circle, so that the vectors keep the limits: at speed v there is v^2/R across the direction.
/// Acceleration and speed share the limit A evenly, v^2/R <= A/sqrt(2). The jerk along the direction is at
/// most J/2 + v^3/R^2 <= 3/4 J, the one across 3 v a/R <= J/2: together at most 0.91 J.
TravelLimits onCircle(const TravelLimits& wanted, double radius) {
    TravelLimits limits;
    limits.acceleration = wanted.acceleration / std::sqrt(2.0);
    limits.speed = std::min(wanted.speed, std::sqrt(limits.acceleration * radius));
    if (wanted.jerk) {
        limits.jerk = 0.5 * *wanted.jerk;
        limits.speed = std::min(limits.speed, std::cbrt(0.25 * *wanted.jerk * radius * radius));
        limits.acceleration = std::min(limits.acceleration, *wanted.jerk * radius / (6.0 * limits.speed));
    }
    return limits;
}

Result<void> checkSize(const char* name, double size) {
    if (!std::isfinite(size)) {
        return failure(ErrorCode::NotFinite, fmt::format("the {} of a path is not a number", name),
                       "Give a finite size.");
    }
    return size != 0.0 ? Result<void>()
                       : failure(ErrorCode::OutOfRange, fmt::format("the {} of a path is zero", name),
                                 fmt::format("Give the {}.", name));
}

Result<void> checkCount(const char* name, int count) {
    return count >= 1 ? Result<void>()
                      : failure(ErrorCode::OutOfRange, fmt::format("a path of {} {}", count, name),
                                "Give at least one.");
}

Result<void> checkPath(const PlanePathConfig& config) {
    if (!std::isfinite(config.heading_rad)) {
        return failure(ErrorCode::NotFinite, "the heading of a path is not a number", "Give a finite angle.");
    }
    if (config.shape == Shape::Circle) {
        auto size = checkSize("radius", config.radius);
        return size ? checkCount("turns", config.turns) : size;
    }
    if (config.shape == Shape::Arc) {
        if (config.radius < 0.0) {
            return failure(ErrorCode::OutOfRange, "the radius of an arc is negative",
                           "Its angle says to which side it bends.");
        }
        auto size = checkSize("radius", config.radius);
        return size ? checkSize("angle", config.angle_rad) : size;
    }
    if (config.shape == Shape::Line) {
        return checkSize("length", config.length);
    }
    if (auto size = checkSize("width", config.width); !size) {
        return size;
    }
    auto count = checkCount("lines", config.lines);
    return count && config.lines > 1 ? checkSize("pitch", config.pitch) : count;
}

/// A circle whose centre lies in +x begins in the direction of -y.
std::array<double, 2> directionOf(const PlanePathConfig& config) {
    if (config.shape == Shape::Circle) {
        return {0.0, config.radius > 0.0 ? -1.0 : 1.0};
    }
    return {std::cos(config.heading_rad), std::sin(config.heading_rad)};
}

/// Angle of a whole circle or arc, positive.
double bendOf(const PlanePathConfig& config) {
    return config.shape == Shape::Circle ? 2.0 * Pi * config.turns : std::fabs(config.angle_rad);
}

/// To the part of a line between two ends.
double distanceToSegment(double along, double across, double from, double to) {
    const double nearest = std::clamp(along, std::min(from, to), std::max(from, to));
    return std::hypot(along - nearest, across);
}

} // namespace

Result<PlanePath> PlanePath::make(const PlanePathConfig& config, double period_s) {
    if (auto checked = checkPath(config); !checked) {
        return failure(checked.error());
    }
    PlanePath path;
    path.m_config = config;
    path.m_period_s = period_s;
    path.m_direction = directionOf(config);
    if (path.isBent()) {
        const double radius = std::fabs(config.radius);
        const auto added =
            path.addPiece(radius * bendOf(config), true, halbench::control::onCircle(config.limits, radius));
        return added ? Result<PlanePath>(path) : failure(added.error());
    }
    if (config.shape == Shape::Line) {
        const auto added = path.addPiece(config.length, true, config.limits);
        return added ? Result<PlanePath>(path) : failure(added.error());
    }
    for (int line = 0; line < config.lines; ++line) {
        auto added = path.addPiece(line % 2 == 0 ? config.width : -config.width, true, config.limits);
        if (added && line + 1 < config.lines) {
            added = path.addPiece(config.pitch, false, config.limits);
        }
        if (!added) {
            return failure(added.error());
        }
    }
    return path;
}

Result<void> PlanePath::addPiece(double length, bool isAlongX, const TravelLimits& limits) {
    const auto profile = TravelProfile::solve(length, limits);
    if (!profile) {
        return failure(profile.error());
    }
    Piece piece{0.0, 0.0, 0.0, isAlongX, *profile};
    if (!m_pieces.empty()) {
        const Piece& last = m_pieces.back();
        const double end = last.profile.at(last.profile.duration_s()).value;
        piece.from_s = duration_s();
        piece.x = last.isAlongX ? last.x + end : last.x;
        piece.y = last.isAlongX ? last.y : last.y + end;
    }
    m_pieces.push_back(piece);
    return {};
}

double PlanePath::duration_s() const {
    const Piece& last = m_pieces.back();
    const double samples = std::ceil(last.profile.duration_s() / m_period_s - 1e-6);
    return last.from_s + samples * m_period_s;
}

bool PlanePath::isBent() const {
    return m_config.shape == Shape::Circle || m_config.shape == Shape::Arc;
}

/// From the frame of the start, whose second axis points to the left, into that of the axes.
PlanePoint PlanePath::turned(const TravelPoint& ahead, const TravelPoint& across) const {
    const auto [c, s] = m_direction;
    return {TravelPoint{c * ahead.value - s * across.value, c * ahead.speed - s * across.speed,
                        c * ahead.acceleration - s * across.acceleration},
            TravelPoint{s * ahead.value + c * across.value, s * ahead.speed + c * across.speed,
                        s * ahead.acceleration + c * across.acceleration}};
}

PlanePoint PlanePath::onArc(const TravelPoint& along) const {
    const double radius = std::fabs(m_config.radius);
    const double side = m_config.shape == Shape::Arc && m_config.angle_rad < 0.0 ? -radius : radius;
    const double rate = along.speed / radius;
    const double change = along.acceleration / radius;
    const double c = std::cos(along.value / radius);
    const double s = std::sin(along.value / radius);
    return turned({radius * s, radius * c * rate, radius * (c * change - s * rate * rate)},
                  {side * (1.0 - c), side * s * rate, side * (c * rate * rate + s * change)});
}

PlanePoint PlanePath::at(double time_s) const {
    auto after = std::upper_bound(m_pieces.begin(), m_pieces.end(), time_s,
                                  [](double time, const Piece& piece) { return time < piece.from_s; });
    const Piece& piece = after == m_pieces.begin() ? m_pieces.front() : *(after - 1);
    TravelPoint along = piece.profile.at(time_s - piece.from_s);
    if (isBent()) {
        return onArc(along);
    }
    if (m_config.shape == Shape::Line) {
        return turned(along, {});
    }
    along.value += piece.isAlongX ? piece.x : piece.y;
    return piece.isAlongX ? PlanePoint{along, TravelPoint{piece.y, 0.0, 0.0}}
                          : PlanePoint{TravelPoint{piece.x, 0.0, 0.0}, along};
}

/// Within the angle of the arc the nearest point lies on the ray from the centre, else it is an end.
double PlanePath::distanceFromArc(double x, double y) const {
    const double radius = std::fabs(m_config.radius);
    const bool isRight = m_config.shape == Shape::Arc && m_config.angle_rad < 0.0;
    const auto [c, s] = m_direction;
    const double ahead =
        c * x + s * y; // in the frame of the start, mirrored so that the arc bends to the left
    const double across = (isRight ? -1.0 : 1.0) * (c * y - s * x) - radius; // from the centre
    double angle = std::atan2(ahead, -across);                               // 0 at the start
    angle = angle < 0.0 ? angle + 2.0 * Pi : angle;
    const double bend = bendOf(m_config);
    if (angle <= bend) {
        return std::fabs(std::hypot(ahead, across) - radius);
    }
    return std::min(std::hypot(ahead, across + radius),
                    std::hypot(ahead - radius * std::sin(bend), across + radius * std::cos(bend)));
}

double PlanePath::distanceFrom(double x, double y) const {
    if (isBent()) {
        return distanceFromArc(x, y);
    }
    if (m_config.shape == Shape::Line) {
        const auto [c, s] = m_direction;
        return distanceToSegment(c * x + s * y, c * y - s * x, 0.0, m_config.length);
    }
    double distance = std::numeric_limits<double>::max();
    for (const Piece& piece : m_pieces) {
        const double length = piece.profile.at(piece.profile.duration_s()).value;
        distance =
            std::min(distance, piece.isAlongX ? distanceToSegment(x, y - piece.y, piece.x, piece.x + length)
                                              : distanceToSegment(y, x - piece.x, piece.y, piece.y + length));
    }
    return distance;
}

void PathSpan::include(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
}

/// At its ends and where the direction is that of an axis: every quarter turn from there.
std::array<PathSpan, 2> PlanePath::spanOfArc() const {
    const double radius = std::fabs(m_config.radius);
    const double bend = bendOf(m_config);
    const double sign = m_config.shape == Shape::Arc && m_config.angle_rad < 0.0 ? -1.0 : 1.0;
    const double quarter = 0.5 * Pi;
    const double start = sign * std::atan2(m_direction[1], m_direction[0]);
    std::array<PathSpan, 2> span;
    const auto include = [&](double angle) {
        const PlanePoint point = onArc({radius * angle, 0.0, 0.0});
        span[0].include(point[0].value);
        span[1].include(point[1].value);
    };
    include(bend);
    const double first = std::ceil(start / quarter) * quarter - start;
    for (double angle = first; angle <= std::min(bend, first + 2.0 * Pi); angle += quarter) {
        include(angle);
    }
    return span;
}

std::array<PathSpan, 2> PlanePath::span() const {
    if (isBent()) {
        return spanOfArc();
    }
    std::array<PathSpan, 2> span;
    const bool isLine = m_config.shape == Shape::Line;
    span[0].include(isLine ? m_direction[0] * m_config.length : m_config.width);
    span[1].include(isLine ? m_direction[1] * m_config.length : m_config.pitch * (m_config.lines - 1));
    return span;
}

} // namespace halbench::control
