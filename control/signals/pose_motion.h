#pragma once

#include "control/base/result.h"
#include "control/signals/travel_profile.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace halbench::control {

/// A pose a row, a value an axis; counted from where the axes stand when the motion begins.
using PoseRows = std::vector<std::vector<double>>;

/// Axes whose limits are those of the vector of their speeds, accelerations and jerks.
struct AxisGroup {
    std::vector<std::size_t> axes;
    TravelLimits limits;
};

/// State of one axis where a piece of a motion begins, and its jerk during the piece.
struct PieceStart {
    double value = 0.0;
    double speed = 0.0;
    double acceleration = 0.0;
    double jerk = 0.0;
};

/// Extremes of one axis within a piece: its range, and the largest magnitudes of the rest.
struct PiecePeaks {
    double least = 0.0;
    double most = 0.0;
    double speed = 0.0;
    double acceleration = 0.0;
    double jerk = 0.0;
};

/// A time in which every axis has a constant jerk, so that its position is a cubic polynomial.
struct MotionPiece {
    double from_s = 0.0;
    double duration_s = 0.0;
    std::size_t row = 0; ///< that it leads to, or rests in, from 0
    std::vector<PieceStart> axes;

    TravelPoint at(std::size_t axis, double time_s) const; ///< since the piece began
    PiecePeaks peaks(std::size_t axis) const;
};

/// A motion of several axes through a table of poses, from rest in the pose 0 to rest in the last row.
class PoseMotion {
public:
    /// Each pose at its time, from time 0 on. Between two pauses every axis follows the cubic spline through
    /// its poses whose position, speed and acceleration are continuous and whose speed and acceleration are 0
    /// at both ends (two further knots, within the first and the last interval, make that possible; Biagiotti
    /// and Melchiorri, Trajectory Planning for Automatic Machines and Robots, 4.4.4). Two rows with the same
    /// pose are a pause. Errors: InvalidInput (rows of other lengths, a first time of 0 with a pose that is
    /// not 0, nothing moves), OutOfRange (times that do not increase), NotFinite.
    static Result<PoseMotion> through(std::span<const double> time_s, const PoseRows& rows);

    /// One pose after the other by travels from rest to rest, all axes together on a straight line, as fast
    /// as the limits allow, with a dwell in every row but the last. Every axis that moves is in one group.
    /// Errors: InvalidInput (as above), those of TravelProfile::solve.
    static Result<PoseMotion> visiting(const PoseRows& rows, std::span<const AxisGroup> groups,
                                       double dwell_s);

    std::size_t axisCount() const { return m_end.size(); }
    std::span<const MotionPiece> pieces() const { return m_pieces; }
    double duration_s() const;
    /// When each row is reached.
    std::span<const double> arrivals_s() const { return m_arrivals_s; }
    /// When the axes leave it again; at once where they do not rest. Of the last row the end.
    std::span<const double> departures_s() const { return m_departures_s; }
    /// At rest behind the end.
    TravelPoint at(std::size_t axis, double time_s) const;
    /// Largest distance of one axis from its start.
    double reach(std::size_t axis) const;

private:
    PoseMotion() = default;
    void addRest(std::size_t row, const std::vector<double>& pose, double duration_s);
    void addTravel(std::size_t row, const std::vector<double>& from, const std::vector<double>& distance,
                   const TravelProfile& profile);
    void addStretch(std::size_t firstRow, std::span<const double> time_s, const PoseRows& poses);

    std::vector<MotionPiece> m_pieces;
    std::vector<double> m_end; ///< last pose
    std::vector<double> m_arrivals_s;
    std::vector<double> m_departures_s;
};

/// Distance of points from the trace that a motion leaves in the plane of two of its axes.
class PlaneTrace {
public:
    /// `axes` of the motion; one beyond its last does not move.
    PlaneTrace(const PoseMotion& motion, std::array<std::size_t, 2> axes);
    /// From the nearest point that the motion passes within a quarter of a second about the time.
    double distanceFrom(double x, double y, double time_s) const;

private:
    std::vector<std::array<double, 2>> m_points; ///< every millisecond
};

} // namespace halbench::control
