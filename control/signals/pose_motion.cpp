#include "control/signals/pose_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace halbench::control {
namespace {

using Pose = std::vector<double>;

PieceStart after(const PieceStart& start, double time_s) {
    const double acceleration = start.acceleration + start.jerk * time_s;
    const double speed = start.speed + time_s * (start.acceleration + 0.5 * start.jerk * time_s);
    const double value =
        start.value +
        time_s * (start.speed + time_s * (0.5 * start.acceleration + start.jerk * time_s / 6.0));
    return {value, speed, acceleration, start.jerk};
}

Result<void> checkRows(const PoseRows& rows) {
    if (rows.empty() || rows.front().empty()) {
        return failure(ErrorCode::InvalidInput, "a motion without poses", "Give at least one pose.");
    }
    bool moves = false;
    for (const Pose& pose : rows) {
        if (pose.size() != rows.front().size()) {
            return failure(ErrorCode::InvalidInput, "poses with different numbers of axes",
                           "Give every axis in every row.");
        }
        for (const double value : pose) {
            if (!std::isfinite(value)) {
                return failure(ErrorCode::NotFinite, "a pose is not a number", "Give finite poses.");
            }
            moves = moves || value != 0.0;
        }
    }
    return moves ? Result<void>()
                 : failure(ErrorCode::InvalidInput, "the poses move nothing",
                           "Poses count from where the axes stand: give one that differs from 0.");
}

Result<void> checkTimes(std::span<const double> time_s, const PoseRows& rows) {
    if (time_s.size() != rows.size()) {
        return failure(ErrorCode::InvalidInput, "not as many times as poses", "Give a time for every pose.");
    }
    for (std::size_t row = 0; row < time_s.size(); ++row) {
        if (!std::isfinite(time_s[row])) {
            return failure(ErrorCode::NotFinite, "a time of a pose is not a number", "Give finite times.");
        }
        if (time_s[row] < 0.0 || (row > 0 && time_s[row] <= time_s[row - 1])) {
            return failure(ErrorCode::OutOfRange, "the times of poses do not increase",
                           "Sort the rows; times begin at 0 or later.");
        }
    }
    const bool startsElsewhere =
        time_s.front() == 0.0 &&
        std::any_of(rows.front().begin(), rows.front().end(), [](double value) { return value != 0.0; });
    return startsElsewhere
               ? failure(ErrorCode::InvalidInput, "at time 0 the pose is not 0",
                         "Poses count from where the axes stand when they start: begin with zeros, or later.")
               : Result<void>();
}

/// One knot of a spline: its value is `value + slope speed`, which is how the end's acceleration becomes 0.
struct Knot {
    double time_s;
    double value;
    double slope;
    std::size_t row;
};

/// Knots of one axis: the poses, and one within the first and the last interval.
std::vector<Knot> knotsOf(std::size_t firstRow, std::span<const double> time_s, const PoseRows& poses,
                          std::size_t axis) {
    const std::size_t last = time_s.size() - 1;
    const double share = last == 1 ? 1.0 / 3.0 : 0.5;
    const double first_s = share * (time_s[1] - time_s[0]);
    const double last_s = share * (time_s[last] - time_s[last - 1]);
    std::vector<Knot> knots = {{time_s[0], poses[0][axis], 0.0, firstRow},
                               {time_s[0] + first_s, poses[0][axis], first_s / 3.0, firstRow + 1}};
    for (std::size_t i = 1; i < last; ++i) {
        knots.push_back({time_s[i], poses[i][axis], 0.0, firstRow + i});
    }
    knots.push_back({time_s[last] - last_s, poses[last][axis], -last_s / 3.0, firstRow + last});
    knots.push_back({time_s[last], poses[last][axis], 0.0, firstRow + last});
    return knots;
}

/// Speeds at the knots for a continuous acceleration, 0 at both ends. With h the interval before a knot and k
/// the one behind it
///
///   v_before/h + 2 v (1/h + 1/k) + v_behind/k = 3 ((p - p_before)/h^2 + (p_behind - p)/k^2)
///
/// where p may depend on v (Knot). Tridiagonal, solved by elimination.
std::vector<double> speedsAt(const std::vector<Knot>& knots) {
    const std::size_t count = knots.size();
    std::vector<double> upper(count, 0.0);
    std::vector<double> speeds(count, 0.0);
    for (std::size_t i = 1; i + 1 < count; ++i) {
        const Knot& before = knots[i - 1];
        const Knot& knot = knots[i];
        const Knot& behind = knots[i + 1];
        const double h = knot.time_s - before.time_s;
        const double k = behind.time_s - knot.time_s;
        const double lower = 1.0 / h + 3.0 * before.slope / (h * h);
        const double diagonal = 2.0 / h + 2.0 / k - 3.0 * knot.slope * (1.0 / (h * h) - 1.0 / (k * k));
        const double wanted =
            3.0 * ((knot.value - before.value) / (h * h) + (behind.value - knot.value) / (k * k));
        const double pivot = diagonal - lower * upper[i - 1];
        upper[i] = (1.0 / k - 3.0 * behind.slope / (k * k)) / pivot;
        speeds[i] = (wanted - lower * speeds[i - 1]) / pivot;
    }
    for (std::size_t i = count - 1; i-- > 1;) {
        speeds[i] -= upper[i] * speeds[i + 1];
    }
    return speeds;
}

/// The cubic polynomial with these ends.
PieceStart between(const Knot& knot, double speed, const Knot& behind, double speedBehind) {
    const double h = behind.time_s - knot.time_s;
    const double value = knot.value + knot.slope * speed;
    const double mean = (behind.value + behind.slope * speedBehind - value) / h;
    return {value, speed, (6.0 * mean - 4.0 * speed - 2.0 * speedBehind) / h,
            (6.0 * (speed + speedBehind) - 12.0 * mean) / (h * h)};
}

/// Acceleration and jerk of a travel over 1, piece by piece.
struct Phase {
    double duration_s;
    double acceleration;
    double jerk;
};

std::vector<Phase> phasesOf(const TravelProfile& profile) {
    const double acceleration = profile.peakAcceleration();
    const double jerk = profile.jerk().value_or(0.0);
    const double jerk_s = jerk > 0.0 ? acceleration / jerk : 0.0;
    const double hold_s = profile.ramp_s() - 2.0 * jerk_s;
    const double flat_s = profile.duration_s() - 2.0 * profile.ramp_s();
    std::vector<Phase> phases = {
        {jerk_s, 0.0, jerk},  {hold_s, acceleration, 0.0},  {jerk_s, acceleration, -jerk}, {flat_s, 0.0, 0.0},
        {jerk_s, 0.0, -jerk}, {hold_s, -acceleration, 0.0}, {jerk_s, -acceleration, jerk}};
    const double shortest_s = 1e-12 * profile.duration_s(); // that rounding made of nothing
    std::erase_if(phases, [shortest_s](const Phase& phase) { return phase.duration_s <= shortest_s; });
    return phases;
}

/// The limits of a travel over 1 that moves every axis by its distance; nothing where no axis moves.
std::optional<TravelLimits> limitsOver(const Pose& distance, std::span<const AxisGroup> groups) {
    std::optional<TravelLimits> all;
    for (const AxisGroup& group : groups) {
        double length = 0.0;
        for (const std::size_t axis : group.axes) {
            length = std::hypot(length, distance[axis]);
        }
        if (length == 0.0) {
            continue;
        }
        const TravelLimits& own = group.limits;
        const bool isFirst = !all;
        TravelLimits& limits = isFirst ? all.emplace() : *all;
        limits.speed = isFirst ? own.speed / length : std::min(limits.speed, own.speed / length);
        limits.acceleration =
            isFirst ? own.acceleration / length : std::min(limits.acceleration, own.acceleration / length);
        if (own.jerk) {
            const double jerk = *own.jerk / length;
            limits.jerk = std::min(limits.jerk.value_or(jerk), jerk);
        }
    }
    return all;
}

Pose differenceOf(const Pose& to, const Pose& from) {
    Pose difference(to.size());
    std::transform(to.begin(), to.end(), from.begin(), difference.begin(), std::minus<>());
    return difference;
}

} // namespace

TravelPoint MotionPiece::at(std::size_t axis, double time_s) const {
    const PieceStart point = after(axes[axis], time_s);
    return {point.value, point.speed, point.acceleration};
}

PiecePeaks MotionPiece::peaks(std::size_t axis) const {
    const PieceStart& start = axes[axis];
    std::vector<double> times = {0.0, duration_s};
    const auto add = [&](double time_s) {
        if (time_s > 0.0 && time_s < duration_s) {
            times.push_back(time_s);
        }
    };
    if (start.jerk != 0.0) {
        const double turn_s = -start.acceleration / start.jerk; // where the speed is largest
        add(turn_s);
        const double root = turn_s * turn_s - 2.0 * start.speed / start.jerk;
        if (root >= 0.0) { // where the axis turns back
            add(turn_s - std::sqrt(root));
            add(turn_s + std::sqrt(root));
        }
    } else if (start.acceleration != 0.0) {
        add(-start.speed / start.acceleration);
    }
    PiecePeaks peaks;
    peaks.least = peaks.most = start.value;
    peaks.jerk = std::fabs(start.jerk);
    for (const double time_s : times) {
        const PieceStart point = after(start, time_s);
        peaks.least = std::min(peaks.least, point.value);
        peaks.most = std::max(peaks.most, point.value);
        peaks.speed = std::max(peaks.speed, std::fabs(point.speed));
        peaks.acceleration = std::max(peaks.acceleration, std::fabs(point.acceleration));
    }
    return peaks;
}

Result<PoseMotion> PoseMotion::through(std::span<const double> time_s, const PoseRows& rows) {
    if (auto checked = checkRows(rows); !checked) {
        return failure(checked.error());
    }
    if (auto checked = checkTimes(time_s, rows); !checked) {
        return failure(checked.error());
    }
    PoseMotion motion;
    motion.m_end = rows.back();
    std::vector<double> stretch_s = {0.0};
    PoseRows stretch = {Pose(rows.front().size(), 0.0)};
    std::size_t firstRow = 0; // of the stretch; its first pose is the row before, or the start
    const auto close = [&](std::size_t nextRow) {
        if (stretch.size() > 1) {
            motion.addStretch(firstRow, stretch_s, stretch);
        }
        stretch_s = {stretch_s.back()};
        stretch = {stretch.back()};
        firstRow = nextRow;
    };
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const double since_s = time_s[row] - stretch_s.back();
        if (rows[row] == stretch.back()) {
            close(row + 1);
            motion.addRest(row, rows[row], since_s);
            stretch_s = {time_s[row]};
        } else {
            stretch_s.push_back(time_s[row]);
            stretch.push_back(rows[row]);
        }
    }
    close(rows.size());
    motion.m_arrivals_s.assign(time_s.begin(), time_s.end());
    motion.m_departures_s = motion.m_arrivals_s;
    for (std::size_t row = 0; row + 1 < rows.size(); ++row) {
        if (rows[row] == rows[row + 1]) {
            motion.m_departures_s[row] = time_s[row + 1];
        }
    }
    return motion;
}

Result<PoseMotion> PoseMotion::visiting(const PoseRows& rows, std::span<const AxisGroup> groups,
                                        double dwell_s) {
    if (auto checked = checkRows(rows); !checked) {
        return failure(checked.error());
    }
    PoseMotion motion;
    motion.m_end = rows.back();
    Pose from(rows.front().size(), 0.0);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const Pose distance = differenceOf(rows[row], from);
        if (const auto limits = limitsOver(distance, groups)) {
            const auto profile = TravelProfile::solve(1.0, *limits);
            if (!profile) {
                return failure(profile.error());
            }
            motion.addTravel(row, from, distance, *profile);
        }
        motion.m_arrivals_s.push_back(motion.duration_s());
        if (row + 1 < rows.size() && dwell_s > 0.0) {
            motion.addRest(row, rows[row], dwell_s);
        }
        motion.m_departures_s.push_back(motion.duration_s());
        from = rows[row];
    }
    return motion;
}

void PoseMotion::addRest(std::size_t row, const Pose& pose, double duration_s) {
    if (!(duration_s > 0.0)) {
        return;
    }
    MotionPiece piece{this->duration_s(), duration_s, row, {}};
    for (const double value : pose) {
        piece.axes.push_back({value, 0.0, 0.0, 0.0});
    }
    m_pieces.push_back(std::move(piece));
}

void PoseMotion::addTravel(std::size_t row, const Pose& from, const Pose& distance,
                           const TravelProfile& profile) {
    PieceStart along; // over a distance of 1
    for (const Phase& phase : phasesOf(profile)) {
        along.acceleration = phase.acceleration;
        along.jerk = phase.jerk;
        MotionPiece piece{duration_s(), phase.duration_s, row, {}};
        for (std::size_t axis = 0; axis < from.size(); ++axis) {
            const double d = distance[axis];
            piece.axes.push_back(
                {from[axis] + d * along.value, d * along.speed, d * along.acceleration, d * along.jerk});
        }
        along = after(along, phase.duration_s);
        m_pieces.push_back(std::move(piece));
    }
}

void PoseMotion::addStretch(std::size_t firstRow, std::span<const double> time_s, const PoseRows& poses) {
    const std::size_t axisCount = poses.front().size();
    const std::size_t first = m_pieces.size();
    for (std::size_t axis = 0; axis < axisCount; ++axis) {
        const std::vector<Knot> knots = knotsOf(firstRow, time_s, poses, axis);
        const std::vector<double> speeds = speedsAt(knots);
        for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
            if (axis == 0) {
                // The first pose of a stretch is the row before `firstRow`.
                m_pieces.push_back(
                    {knots[i].time_s, knots[i + 1].time_s - knots[i].time_s, knots[i + 1].row - 1, {}});
            }
            m_pieces[first + i].axes.push_back(between(knots[i], speeds[i], knots[i + 1], speeds[i + 1]));
        }
    }
}

double PoseMotion::duration_s() const {
    return m_pieces.empty() ? 0.0 : m_pieces.back().from_s + m_pieces.back().duration_s;
}

TravelPoint PoseMotion::at(std::size_t axis, double time_s) const {
    if (time_s >= duration_s()) {
        return {m_end[axis], 0.0, 0.0};
    }
    const auto behind =
        std::upper_bound(m_pieces.begin(), m_pieces.end(), time_s,
                         [](double time, const MotionPiece& piece) { return time < piece.from_s; });
    const MotionPiece& piece = behind == m_pieces.begin() ? m_pieces.front() : *(behind - 1);
    return piece.at(axis, std::max(0.0, time_s - piece.from_s));
}

double PoseMotion::reach(std::size_t axis) const {
    double reach = 0.0;
    for (const MotionPiece& piece : m_pieces) {
        const PiecePeaks peaks = piece.peaks(axis);
        reach = std::max({reach, -peaks.least, peaks.most});
    }
    return reach;
}

namespace {
constexpr double TraceStep_s = 1e-3;
} // namespace

PlaneTrace::PlaneTrace(const PoseMotion& motion, std::array<std::size_t, 2> axes) {
    const auto steps = static_cast<std::size_t>(std::ceil(motion.duration_s() / TraceStep_s)) + 1;
    m_points.reserve(steps);
    for (std::size_t step = 0; step < steps; ++step) {
        std::array<double, 2> point{};
        for (std::size_t i = 0; i < axes.size(); ++i) {
            const double time_s = TraceStep_s * static_cast<double>(step);
            point[i] = axes[i] < motion.axisCount() ? motion.at(axes[i], time_s).value : 0.0;
        }
        m_points.push_back(point);
    }
}

double PlaneTrace::distanceFrom(double x, double y, double time_s) const {
    constexpr double Near_s = 0.25;
    const auto indexOf = [this](double time) {
        const double step = std::max(0.0, std::floor(time / TraceStep_s));
        return std::min(static_cast<std::size_t>(step), m_points.size() - 1);
    };
    const std::size_t first = indexOf(time_s - Near_s);
    const std::size_t last = indexOf(time_s + Near_s);
    double square = std::pow(x - m_points[first][0], 2) + std::pow(y - m_points[first][1], 2);
    for (std::size_t i = first; i < last; ++i) {
        const auto& [fromX, fromY] = m_points[i];
        const double alongX = m_points[i + 1][0] - fromX;
        const double alongY = m_points[i + 1][1] - fromY;
        const double length = alongX * alongX + alongY * alongY;
        const double share =
            length > 0.0 ? std::clamp(((x - fromX) * alongX + (y - fromY) * alongY) / length, 0.0, 1.0) : 0.0;
        const double awayX = x - fromX - share * alongX;
        const double awayY = y - fromY - share * alongY;
        square = std::min(square, awayX * awayX + awayY * awayY);
    }
    return std::sqrt(square);
}

} // namespace halbench::control
