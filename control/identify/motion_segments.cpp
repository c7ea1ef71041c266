#include "control/identify/motion_segments.h"

#include "control/base/assert.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

// Half width of the window in which the local speed is taken: 0.05 s keeps the quantisation of the angle
// (0.04 deg rms) below 0.02 rad/s.
constexpr double SpeedWindow_s = 0.05;

Result<void> checkColumns(std::span<const double> time_s, std::span<const double> current_A,
                          std::span<const double> marker) {
    if (current_A.size() != time_s.size() || (!marker.empty() && marker.size() != time_s.size())) {
        return failure(ErrorCode::InvalidInput, "the columns of the recording differ in length", {});
    }
    for (std::size_t i = 0; i < time_s.size(); ++i) {
        if (!std::isfinite(time_s[i]) || !std::isfinite(current_A[i])) {
            return failure(ErrorCode::NotFinite, "the recording contains a value that is not a number",
                           "remove the damaged rows");
        }
        if (i > 0 && !(time_s[i] > time_s[i - 1])) {
            return failure(ErrorCode::InvalidInput, "the time of the recording does not increase",
                           "sort the rows and remove duplicates");
        }
    }
    return {};
}

double localSpeed(std::span<const double> time_s, std::span<const double> angle_rad, std::size_t begin,
                  std::size_t end, std::size_t at) {
    std::size_t low = at;
    std::size_t high = at;
    while (low > begin && time_s[at] - time_s[low - 1] <= SpeedWindow_s + 1e-9) {
        --low;
    }
    while (high + 1 < end && time_s[high + 1] - time_s[at] <= SpeedWindow_s + 1e-9) {
        ++high;
    }
    return high > low ? (angle_rad[high] - angle_rad[low]) / (time_s[high] - time_s[low]) : 0.0;
}

struct Run {
    std::size_t begin = 0;
    std::size_t end = 0;
    int direction = 0;
};

Run longestRun(std::span<const double> time_s, std::span<const double> angle_rad,
               const CurrentPlateau& plateau, const SegmentConfig& config) {
    std::size_t begin = plateau.begin;
    while (begin < plateau.end && time_s[begin] - time_s[plateau.begin] < config.settle_s) {
        ++begin;
    }
    Run best;
    Run open;
    for (std::size_t i = begin; i < plateau.end; ++i) {
        const double speed = localSpeed(time_s, angle_rad, begin, plateau.end, i);
        const int direction =
            std::fabs(speed) < config.slowest_rad_s ? 0 : static_cast<int>(std::copysign(1.0, speed));
        if (direction == 0 || direction != open.direction) {
            open = {i, i, direction};
        }
        open.end = i + 1;
        if (open.direction != 0 && open.end - open.begin > best.end - best.begin) {
            best = open;
        }
    }
    return best;
}

} // namespace

Result<std::vector<CurrentPlateau>> findPlateaus(std::span<const double> time_s,
                                                 std::span<const double> current_A,
                                                 std::span<const double> marker,
                                                 const SegmentConfig& config) {
    if (const auto checked = checkColumns(time_s, current_A, marker); !checked) {
        return failure(checked.error());
    }
    std::vector<CurrentPlateau> plateaus;
    for (std::size_t i = 0; i < time_s.size(); ++i) {
        const bool continues = !plateaus.empty() &&
                               std::fabs(current_A[i] - plateaus.back().current_A) <= config.sameCurrent_A &&
                               (marker.empty() || marker[i] == marker[i - 1]);
        if (!continues) {
            plateaus.push_back({i, i, current_A[i]});
        }
        plateaus.back().end = i + 1;
    }
    std::erase_if(plateaus, [&](const CurrentPlateau& plateau) {
        return time_s[plateau.end - 1] - time_s[plateau.begin] < config.shortest_s;
    });
    return plateaus;
}

std::vector<MotionSegment> findMotion(std::span<const double> time_s, std::span<const double> angle_rad,
                                      std::span<const CurrentPlateau> plateaus, const SegmentConfig& config) {
    HB_ASSERT(time_s.size() == angle_rad.size());
    std::vector<MotionSegment> segments;
    for (const CurrentPlateau& plateau : plateaus) {
        const Run run = longestRun(time_s, angle_rad, plateau, config);
        if (run.end <= run.begin + 2 || time_s[run.end - 1] - time_s[run.begin] < config.shortest_s) {
            continue;
        }
        MotionSegment segment;
        segment.time_s.assign(time_s.begin() + static_cast<std::ptrdiff_t>(run.begin),
                              time_s.begin() + static_cast<std::ptrdiff_t>(run.end));
        segment.angle_rad.assign(angle_rad.begin() + static_cast<std::ptrdiff_t>(run.begin),
                                 angle_rad.begin() + static_cast<std::ptrdiff_t>(run.end));
        segment.current_A = plateau.current_A;
        segment.direction = run.direction;
        segments.push_back(std::move(segment));
    }
    return segments;
}

} // namespace halbench::control
