#include "control/identify/angle_column.h"

#include "control/base/units.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace halbench::control {
namespace {

// Sizes of the jumps that stand alone among small steps, the motion around them taken off.
std::vector<double> jumpSizes_rad(std::span<const double> angle_rad) {
    constexpr double Smallest_rad = 1.0;
    constexpr double OverNeighbours_ratio = 3.0;
    std::vector<double> sizes;
    for (std::size_t row = 2; row + 1 < angle_rad.size(); ++row) {
        const double before = angle_rad[row - 1] - angle_rad[row - 2];
        const double step = angle_rad[row] - angle_rad[row - 1];
        const double after = angle_rad[row + 1] - angle_rad[row];
        const double usual = std::max(std::fabs(before), std::fabs(after));
        if (std::fabs(step) > Smallest_rad + OverNeighbours_ratio * usual) {
            sizes.push_back(std::fabs(step - 0.5 * (before + after)));
        }
    }
    return sizes;
}

constexpr double SameSize_ratio = 0.02;

// Most wrap after half turns or whole ones; the jumps tell the span to the change of speed around them.
double roundedToTurns_rad(double period_rad) {
    constexpr double JumpError_rad = 0.05;
    const double rounded_rad = std::round(period_rad / Pi) * Pi;
    return std::fabs(rounded_rad - period_rad) < JumpError_rad ? rounded_rad : period_rad;
}

// The span after which the column starts anew.
std::optional<double> wrapPeriod_rad(std::span<const double> angle_rad) {
    std::vector<double> sizes = jumpSizes_rad(angle_rad);
    constexpr std::size_t FewestJumps = 2;
    if (sizes.size() < FewestJumps) {
        return std::nullopt;
    }
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    const double period_rad = roundedToTurns_rad(*middle);
    const auto [low, high] = std::minmax_element(angle_rad.begin(), angle_rad.end());
    const bool isWithin = *high - *low <= (1.0 + SameSize_ratio) * period_rad;
    const bool isSameSize = std::all_of(sizes.begin(), sizes.end(), [period_rad](double size) {
        return std::fabs(size / period_rad - 1.0) < SameSize_ratio;
    });
    return isWithin && isSameSize ? std::optional(period_rad) : std::nullopt;
}

// Where a plateau ends, and how much of its step is still going on in its last fifth.
struct PlateauEnd {
    double current_A = 0.0;
    double value = 0.0;
    double drift = 0.0;
};

std::vector<PlateauEnd> endsOf(std::span<const double> column, std::span<const CurrentPlateau> plateaus) {
    constexpr std::size_t FewestRows = 50;
    std::vector<PlateauEnd> ends;
    for (const CurrentPlateau& plateau : plateaus) {
        const std::size_t rows = plateau.end - plateau.begin;
        if (rows < FewestRows) {
            continue;
        }
        const std::size_t tenth = rows / 10;
        const auto meanOf = [&](std::size_t begin) {
            const auto part = column.subspan(begin, tenth);
            return std::accumulate(part.begin(), part.end(), 0.0) / static_cast<double>(tenth);
        };
        const double last = meanOf(plateau.end - tenth);
        ends.push_back({plateau.current_A, last, 2.0 * std::fabs(last - meanOf(plateau.end - 2 * tenth))});
    }
    return ends;
}

double correlation(const std::vector<PlateauEnd>& ends) {
    double current = 0.0;
    double value = 0.0;
    for (const PlateauEnd& end : ends) {
        current += end.current_A / static_cast<double>(ends.size());
        value += end.value / static_cast<double>(ends.size());
    }
    double cross = 0.0;
    double currents = 0.0;
    double values = 0.0;
    for (const PlateauEnd& end : ends) {
        cross += (end.current_A - current) * (end.value - value);
        currents += (end.current_A - current) * (end.current_A - current);
        values += (end.value - value) * (end.value - value);
    }
    return currents > 0.0 && values > 0.0 ? cross / std::sqrt(currents * values) : 0.0;
}

} // namespace

UnwrappedAngle unwrapAngle(std::span<const double> angle_rad) {
    UnwrappedAngle result;
    result.angle_rad.assign(angle_rad.begin(), angle_rad.end());
    result.period_rad = wrapPeriod_rad(angle_rad);
    if (!result.period_rad) {
        return result;
    }
    double shift_rad = 0.0;
    for (std::size_t row = 1; row < angle_rad.size(); ++row) {
        const double step = angle_rad[row] - angle_rad[row - 1];
        if (std::fabs(step) > 0.5 * *result.period_rad) {
            shift_rad -= std::copysign(*result.period_rad, step);
            ++result.wraps;
        }
        result.angle_rad[row] += shift_rad;
    }
    return result;
}

bool looksLikeSpeed(std::span<const double> column, std::span<const CurrentPlateau> plateaus) {
    constexpr std::size_t FewestSteps = 3;
    constexpr double SmallestStep_rad = 0.5;
    constexpr double StillGoing_ratio =
        0.08; // a steady motion goes on with a fifth, a lag of half its dwell 7 %
    constexpr double GoesWithCurrent = 0.9;
    const std::vector<PlateauEnd> ends = endsOf(column, plateaus);
    std::vector<double> going;
    for (std::size_t i = 1; i < ends.size(); ++i) {
        const double step = std::fabs(ends[i].value - ends[i - 1].value);
        if (step > SmallestStep_rad) {
            going.push_back(ends[i].drift / step);
        }
    }
    if (going.size() < FewestSteps) {
        return false;
    }
    const auto middle = going.begin() + static_cast<std::ptrdiff_t>(going.size() / 2);
    std::nth_element(going.begin(), middle, going.end());
    return *middle < StillGoing_ratio && std::fabs(correlation(ends)) > GoesWithCurrent;
}

} // namespace halbench::control
