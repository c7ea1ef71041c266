#pragma once

#include "control/signals/travel_profile.h"

#include <array>
#include <span>
#include <vector>

namespace halbench::control {

/// A path of two axes from rest to rest. The limits are those of the vectors of speed, acceleration, jerk.
///
/// Circle: counter-clockwise, begins in the origin, with its centre a radius away along +x (-x for a
/// negative radius). Raster: lines along x, forth and back, a pitch along y between them; it rests at every
/// corner. Arc: of a radius through an angle, counter-clockwise where that is positive; begins in the
/// direction `heading`, counted from +x towards +y. Line: of a length in that direction.
struct PlanePathConfig {
    enum class Shape { Circle, Raster, Arc, Line };
    Shape shape = Shape::Circle;
    double radius = 0.0;
    int turns = 1;
    double width = 0.0;
    double pitch = 0.0;
    int lines = 1;
    double angle_rad = 0.0;
    double heading_rad = 0.0;
    double length = 0.0;
    TravelLimits limits;
};

/// How far a path goes along one axis, counted from its start: `least` is negative or 0, `most` positive or 0.
struct PathSpan {
    double least = 0.0;
    double most = 0.0;

    double reach() const { return -least > most ? -least : most; }
    void include(double value);
};

/// x and y at one instant.
using PlanePoint = std::array<TravelPoint, 2>;

/// The path as a board with a sample period follows it: a piece ends with the first sample behind its end,
/// where the next one begins.
class PlanePath {
public:
    /// Errors: as TravelProfile::solve, the size that is wrong named.
    static Result<PlanePath> make(const PlanePathConfig& config, double period_s);

    PlanePoint at(double time_s) const;
    double duration_s() const;
    /// From a point to the nearest one of the whole path: its contour error.
    double distanceFrom(double x, double y) const;
    /// Along each axis, exact: at its ends and where it turns round.
    std::array<PathSpan, 2> span() const;

private:
    struct Piece {
        double from_s;
        double x, y; ///< where it begins
        bool isAlongX;
        TravelProfile profile;
    };
    PlanePath() = default;
    Result<void> addPiece(double length, bool isAlongX, const TravelLimits& limits);
    bool isBent() const;
    PlanePoint turned(const TravelPoint& ahead, const TravelPoint& across) const;
    PlanePoint onArc(const TravelPoint& along) const;
    double distanceFromArc(double x, double y) const;
    std::array<PathSpan, 2> spanOfArc() const;

    PlanePathConfig m_config;
    std::array<double, 2> m_direction = {1.0, 0.0}; ///< at the start, of length one
    double m_period_s = 1e-3;
    std::vector<Piece> m_pieces;
};

} // namespace halbench::control
