#include "app/procedures/move/recorded_move.h"

#include "app/procedures/base/recorded_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>

namespace halbench::app {
namespace {

constexpr double Tick_s = 1e-3;
constexpr int HalfKernel = 35; ///< of smoothing, in rows
constexpr double Shortest_s = 0.2;
constexpr double Longest_s = 120.0;

/// A recording without a sidecar has its columns by their names in the file.
std::vector<double> signal(const Recording& recording, const std::string& name, const char* unit) {
    std::vector<double> values = recording.layout ? recording.column(name) : std::vector<double>{};
    return values.empty() && recording.layout ? recording.column(name + "_" + unit) : values;
}

std::size_t startRow(const Recording& recording) {
    const std::vector<double> running = signal(recording, "reference.running", "");
    const auto first = std::find_if(running.begin(), running.end(), [](double on) { return on > 0.5; });
    return first == running.end() ? 0 : static_cast<std::size_t>(first - running.begin());
}

Result<void> checkTimes(std::span<const double> time_s) {
    constexpr double LongestGap_s = 0.025; // two periods of the loop and a row
    const double duration_s = time_s.size() < 2 ? 0.0 : time_s.back() - time_s.front();
    if (!(duration_s >= Shortest_s && duration_s <= Longest_s)) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("a recorded move of {:.3g} s cannot be replayed", duration_s),
                       fmt::format("record {} to {:.0f} s of a move", Shortest_s, Longest_s));
    }
    for (std::size_t i = 1; i < time_s.size(); ++i) {
        if (!(time_s[i] - time_s[i - 1] <= LongestGap_s && time_s[i] > time_s[i - 1])) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("rows missing at {:.3f} s: no prediction possible",
                                       time_s[i - 1] - time_s.front()),
                           "record the move again, at 100 Hz or more");
        }
    }
    return {};
}

/// One of the columns on rows 1 ms apart.
std::vector<double> resampled(std::span<const double> time_s, std::span<const double> values, bool isHeld) {
    const auto rows = static_cast<std::size_t>(std::floor((time_s.back() - time_s.front()) / Tick_s + 1e-6));
    std::vector<double> result;
    result.reserve(rows + 1);
    std::size_t before = 0;
    for (std::size_t row = 0; row <= rows; ++row) {
        const double wanted_s = time_s.front() + Tick_s * static_cast<double>(row);
        while (before + 2 < time_s.size() && time_s[before + 1] <= wanted_s + 1e-7) {
            ++before;
        }
        const double share =
            std::clamp((wanted_s - time_s[before]) / (time_s[before + 1] - time_s[before]), 0.0, 1.0);
        result.push_back(isHeld ? values[share >= 1.0 - 1e-4 ? before + 1 : before]
                                : std::lerp(values[before], values[before + 1], share));
    }
    return result;
}

Result<void> checkRest(const RecordedMove& move) {
    constexpr std::size_t Rows = 6;     // 5 ms at the largest current: 0.8 mrad
    constexpr double Still_rad = 0.004; // an angle of which one count flickers
    for (std::size_t row = 0; row < std::min(Rows, move.rows()); ++row) {
        if (std::fabs(move.position_rad[row]) > Still_rad) {
            return failure(ErrorCode::Refused, "the rotor is already moving when the recording begins",
                           "use a recording that begins with its move, as `halbench move --out` writes it");
        }
    }
    return {};
}

std::vector<double> smoothingWeights() {
    constexpr double Sigma_ms = 10.0;
    std::vector<double> weights;
    double sum = 0.0;
    for (int i = -HalfKernel; i <= HalfKernel; ++i) {
        weights.push_back(std::exp(-0.5 * i * i / (Sigma_ms * Sigma_ms)));
        sum += weights.back();
    }
    for (double& weight : weights) {
        weight /= sum;
    }
    return weights;
}

/// Before its first row a motion is as there, `before`; after its last one it stays.
std::vector<double> smoothed(std::span<const double> values, double before) {
    const std::vector<double> weights = smoothingWeights();
    const auto half = static_cast<std::ptrdiff_t>(weights.size() / 2);
    const auto rows = static_cast<std::ptrdiff_t>(values.size());
    std::vector<double> result(values.size());
    for (std::ptrdiff_t row = 0; row < rows; ++row) {
        double sum = 0.0;
        for (std::ptrdiff_t k = -half; k <= half; ++k) {
            const std::ptrdiff_t at = row + k;
            const double value = at < 0 ? before : values[static_cast<std::size_t>(std::min(at, rows - 1))];
            sum += weights[static_cast<std::size_t>(k + half)] * value;
        }
        result[static_cast<std::size_t>(row)] = sum;
    }
    return result;
}

/// Smoothing does not see what comes after the last row: there the last whole value stays.
void keepFromEnd(std::vector<double>& values) {
    constexpr auto Unseen = static_cast<std::size_t>(HalfKernel) + 1;
    if (values.size() > Unseen) {
        std::fill(values.end() - static_cast<std::ptrdiff_t>(Unseen), values.end(),
                  values[values.size() - Unseen - 1]);
    }
}

struct Stretch {
    std::size_t begin;
    std::size_t end;
};

/// Where the angle changes by more than the flicker of a count within 24 ms; a rest shorter than 60 ms is a
/// turn.
std::vector<Stretch> livelyStretches(std::span<const double> position_rad) {
    constexpr std::ptrdiff_t Half = 12;
    constexpr std::size_t Turn = 60;
    constexpr double Still_rad = 0.005;
    const auto rows = static_cast<std::ptrdiff_t>(position_rad.size());
    const auto at = [&](std::ptrdiff_t row) {
        return position_rad.begin() + std::clamp<std::ptrdiff_t>(row, 0, rows);
    };
    std::vector<Stretch> stretches;
    for (std::ptrdiff_t row = 0; row < rows; ++row) {
        const auto [low, high] = std::minmax_element(at(row - Half), at(row + Half + 1));
        if (*high - *low <= Still_rad) {
            continue;
        }
        const auto here = static_cast<std::size_t>(row);
        if (!stretches.empty() && here < stretches.back().end + Turn) {
            stretches.back().end = here + 1;
        } else {
            stretches.push_back({here, here + 1});
        }
    }
    return stretches;
}

/// How many rows after `rows.front()` a motion began from where it was then: with a constant acceleration
/// four times the way takes twice the time. Nothing: it did not get that far.
std::optional<std::size_t> departure(std::span<const double> rows) {
    constexpr double Near_rad = 0.003; // beyond the flicker of one count
    constexpr double Far_rad = 4.0 * Near_rad;
    constexpr std::size_t MeanRows = 5;
    double rest_rad = 0.0;
    const std::size_t count = std::min(MeanRows, rows.size());
    for (std::size_t i = 0; i < count; ++i) {
        rest_rad += rows[i] / static_cast<double>(count);
    }
    std::size_t near = 0;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const double way_rad = std::fabs(rows[row] - rest_rad);
        if (way_rad > Far_rad) {
            return 2 * near > row ? 2 * near - row : 0;
        }
        near = way_rad <= Near_rad ? row + 1 : near;
    }
    return std::nullopt;
}

/// Whether the rotor moves, to a millisecond or two: friction and current count from then on.
std::vector<bool> isMoving(std::span<const double> position_rad) {
    std::vector<bool> moving(position_rad.size());
    for (const Stretch& stretch : livelyStretches(position_rad)) {
        const std::span<const double> rows = position_rad.subspan(stretch.begin, stretch.end - stretch.begin);
        const std::vector<double> backwards(rows.rbegin(), rows.rend());
        const auto first = departure(rows);
        const bool isToEnd = stretch.end == position_rad.size();
        const auto last = isToEnd ? std::optional<std::size_t>(0) : departure(backwards);
        if (first && last && *first + *last < rows.size()) {
            std::fill(moving.begin() + static_cast<std::ptrdiff_t>(stretch.begin + *first),
                      moving.begin() + static_cast<std::ptrdiff_t>(stretch.end - *last), true);
        }
    }
    return moving;
}

double rms(std::span<const double> one, std::span<const double> other) {
    double sum = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        sum += (one[i] - other[i]) * (one[i] - other[i]);
    }
    return std::sqrt(sum / static_cast<double>(one.size()));
}

/// At rest what smoothing takes off is noise; while it moves a bend too.
double resolution_rad(const RecordedMove& move, std::span<const double> smooth_rad,
                      const std::vector<bool>& moving) {
    constexpr double Least_rad = 7e-4; // a board of 10 bits: 0.041 degrees rms (htm-theory.md 7.4)
    std::vector<double> seen;
    std::vector<double> smooth;
    for (std::size_t row = 0; row < move.rows(); ++row) {
        if (!moving[row]) {
            seen.push_back(move.position_rad[row]);
            smooth.push_back(smooth_rad[row]);
        }
    }
    return std::max(Least_rad, seen.empty() ? 0.0 : rms(seen, smooth));
}

} // namespace

Result<RecordedMove> recordedMove(const Recording& recording) {
    const std::vector<double> position = signal(recording, "position", "rad");
    const std::vector<double> reference = signal(recording, "reference", "rad");
    const std::vector<double> current = signal(recording, "current_command", "A");
    if (position.empty() || reference.empty() || current.empty()) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("the recording has no {}", position.empty()    ? "position"
                                                              : reference.empty() ? "reference"
                                                                                  : "current_command"),
                       "a replay needs position, reference and current_command");
    }
    const std::size_t start = startRow(recording);
    const auto from = [start](const std::vector<double>& values) {
        return std::span<const double>(values).subspan(start);
    };
    const std::span<const double> time_s = from(recording.time_s);
    if (auto timed = checkTimes(time_s); !timed) {
        return failure(timed.error());
    }
    for (const auto& checked : {checkRecordedValues(recording, "position", position, start),
                                checkRecordedValues(recording, "reference", reference, start),
                                checkRecordedValues(recording, "current_command", current, start)}) {
        if (!checked) {
            return failure(checked.error());
        }
    }
    RecordedMove move{resampled(time_s, from(reference), true), resampled(time_s, from(position), false),
                      resampled(time_s, from(current), true)};
    const double origin_rad = move.position_rad.front();
    for (std::vector<double>* angles : {&move.reference_rad, &move.position_rad}) {
        for (double& angle_rad : *angles) {
            angle_rad -= origin_rad;
        }
    }
    if (auto resting = checkRest(move); !resting) {
        return failure(resting.error());
    }
    return move;
}

MotionRemainder remainderOf(const RecordedMove& move) {
    const std::vector<double> smooth_rad = smoothed(move.position_rad, move.position_rad.front());
    const std::vector<bool> moving = isMoving(move.position_rad);
    const std::size_t rows = move.rows();
    MotionRemainder result;
    result.acceleration_rad_s2.assign(rows, 0.0);
    result.speed_rad_s.assign(rows, 0.0);
    std::vector<double> direction(rows, 0.0);
    std::vector<double> current_A(rows, 0.0);
    std::vector<double> isMovingNow(rows, 0.0);
    for (std::size_t row = 1; row + 1 < rows; ++row) {
        const double before = smooth_rad[row - 1];
        const double after = smooth_rad[row + 1];
        result.speed_rad_s[row] = (after - before) / (2.0 * Tick_s);
        result.acceleration_rad_s2[row] = (after - 2.0 * smooth_rad[row] + before) / (Tick_s * Tick_s);
        if (moving[row]) { // the current of an interval acts between its rows
            isMovingNow[row] = 1.0;
            direction[row] = std::copysign(1.0, result.speed_rad_s[row]);
            current_A[row] = 0.5 * (move.current_A[row - 1] + move.current_A[row]);
        }
    }
    result.direction_ratio = smoothed(direction, 0.0);
    result.current_A = smoothed(current_A, 0.0);
    result.moving_ratio = smoothed(isMovingNow, 0.0);
    result.resolution_rad = resolution_rad(move, smooth_rad, moving);
    for (std::vector<double>* values : {&result.acceleration_rad_s2, &result.speed_rad_s,
                                        &result.direction_ratio, &result.current_A, &result.moving_ratio}) {
        keepFromEnd(*values);
    }
    return result;
}

} // namespace halbench::app
