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
    if (config.shape == Shape::Circle) {
        auto size = checkSize("radius", config.radius);
        return size ? checkCount("turns", config.turns) : size;
    }
    if (auto size = checkSize("width", config.width); !size) {
        return size;
    }
    auto count = checkCount("lines", config.lines);
    return count && config.lines > 1 ? checkSize("pitch", config.pitch) : count;
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
    if (config.shape == Shape::Circle) {
        const double radius = std::fabs(config.radius);
        const auto added = path.addPiece(2.0 * Pi * radius * config.turns, true,
                                         halbench::control::onCircle(config.limits, radius));
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

PlanePoint PlanePath::onCircle(const TravelPoint& along) const {
    const double radius = m_config.radius;
    const double angle = along.value / std::fabs(radius);
    const double rate = along.speed / std::fabs(radius);
    const double change = along.acceleration / std::fabs(radius);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {TravelPoint{radius * (1.0 - c), radius * s * rate, radius * (c * rate * rate + s * change)},
            TravelPoint{-radius * s, -radius * c * rate, radius * (s * rate * rate - c * change)}};
}

PlanePoint PlanePath::at(double time_s) const {
    auto after = std::upper_bound(m_pieces.begin(), m_pieces.end(), time_s,
                                  [](double time, const Piece& piece) { return time < piece.from_s; });
    const Piece& piece = after == m_pieces.begin() ? m_pieces.front() : *(after - 1);
    TravelPoint along = piece.profile.at(time_s - piece.from_s);
    if (m_config.shape == Shape::Circle) {
        return onCircle(along);
    }
    along.value += piece.isAlongX ? piece.x : piece.y;
    return piece.isAlongX ? PlanePoint{along, TravelPoint{piece.y, 0.0, 0.0}}
                          : PlanePoint{TravelPoint{piece.x, 0.0, 0.0}, along};
}

double PlanePath::distanceFrom(double x, double y) const {
    if (m_config.shape == Shape::Circle) {
        return std::fabs(std::hypot(x - m_config.radius, y) - std::fabs(m_config.radius));
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

std::array<double, 2> PlanePath::reach() const {
    if (m_config.shape == Shape::Circle) {
        return {2.0 * std::fabs(m_config.radius), std::fabs(m_config.radius)};
    }
    return {std::fabs(m_config.width), std::fabs(m_config.pitch) * (m_config.lines - 1)};
}

} // namespace halbench::control
