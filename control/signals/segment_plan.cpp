#include "control/signals/segment_plan.h"

#include "control/signals/segment_transform.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

constexpr std::size_t FewestRows = 8;
constexpr double LargestOverlap = 0.95;
// Eight segments half overlapping are as long as four and a half.
constexpr double SegmentsSideBySide = 4.5;

Result<void> checkConfig(const SpectrumConfig& config) {
    if (!std::isfinite(config.overlap_ratio) || !std::isfinite(config.confidence_ratio) ||
        !std::isfinite(config.segment_s.value_or(1.0))) {
        return failure(ErrorCode::NotFinite, "overlap, confidence and segment must be finite numbers",
                       "give a finite number");
    }
    if (config.overlap_ratio < 0.0 || config.overlap_ratio > LargestOverlap) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("an overlap of {} is not possible", config.overlap_ratio),
                       "give a ratio from 0 to 0.95; 0.5 is usual, 0.75 for flat-top and blackman-harris");
    }
    if (config.confidence_ratio <= 0.0 || config.confidence_ratio >= 1.0) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a confidence of {} is not between 0 and 1", config.confidence_ratio),
                       "0.95 is usual");
    }
    return {};
}

Result<std::size_t> chosenRows(std::size_t longest, bool isAveraged) {
    if (longest < FewestRows) {
        return failure(ErrorCode::Refused,
                       fmt::format("fewer than {} consecutive rows without gap or missing value", FewestRows),
                       "record for longer, or at a rate without losses");
    }
    const auto share = static_cast<std::size_t>(static_cast<double>(longest) / SegmentsSideBySide);
    return fastLength(isAveraged ? std::max(share, FewestRows) : longest, longest);
}

Result<std::size_t> askedRows(double segment_s, double period_s, std::size_t longest) {
    const double rows = std::round(segment_s / period_s);
    if (!(rows >= FewestRows)) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a segment of {} s has fewer than {} rows", segment_s, FewestRows),
                       fmt::format("give at least {:.6g} s", FewestRows * period_s));
    }
    if (rows > static_cast<double>(longest)) {
        return failure(ErrorCode::Refused,
                       fmt::format("a segment of {} s is too long: the longest part without gap or missing "
                                   "value has {} rows, {:.6g} s",
                                   segment_s, longest, static_cast<double>(longest) * period_s),
                       "give a shorter segment, or record longer");
    }
    return fastLength(static_cast<std::size_t>(rows), longest);
}

// A clock that is off by one period over a segment moves a line at half the rate by half a line.
Result<void> checkRate(const SignalView& signal, const SegmentPlan& plan) {
    const double period_s = plan.stretches.period_s;
    for (const std::size_t begin : plan.begins) {
        for (std::size_t row = 0; row < plan.rows; ++row) {
            const double due_s = signal.time_s[begin] + static_cast<double>(row) * period_s;
            if (std::fabs(signal.time_s[begin + row] - due_s) > period_s) {
                return failure(
                    ErrorCode::Refused,
                    fmt::format(
                        "the rate is not constant: {} rows from {:.6g} s on take {:.6g} s, average {:.6g} s",
                        row, signal.time_s[begin], signal.time_s[begin + row] - signal.time_s[begin],
                        due_s - signal.time_s[begin]),
                    "use a shorter segment, or a part of the recording with constant rate");
            }
        }
    }
    return {};
}

} // namespace

std::size_t SegmentPlan::usedRows() const {
    std::size_t used = 0;
    for (const Stretch& stretch : stretches.pieces) {
        const std::size_t count = segmentsIn(stretch);
        used += count == 0 ? 0 : (count - 1) * shift + rows;
    }
    return used;
}

Result<SegmentPlan> planSegments(const SignalView& signal, const SpectrumConfig& config, bool isAveraged) {
    if (const Result<void> valid = checkConfig(config); !valid) {
        return failure(valid.error());
    }
    Result<UniformSegments> stretches = findUniformSegments(signal.time_s, signal.values);
    if (!stretches) {
        return failure(stretches.error());
    }
    const Result<std::size_t> rows =
        config.segment_s ? askedRows(*config.segment_s, stretches->period_s, stretches->longest())
                         : chosenRows(stretches->longest(), isAveraged);
    if (!rows) {
        return failure(rows.error());
    }
    SegmentPlan plan{*std::move(stretches), *rows, 0, {}};
    const double shift = std::round(static_cast<double>(*rows) * (1.0 - config.overlap_ratio));
    plan.shift = std::max<std::size_t>(1, static_cast<std::size_t>(shift));
    for (const Stretch& stretch : plan.stretches.pieces) {
        for (std::size_t i = 0; i < plan.segmentsIn(stretch); ++i) {
            plan.begins.push_back(stretch.begin + i * plan.shift);
        }
    }
    if (const Result<void> even = checkRate(signal, plan); !even) {
        return failure(even.error());
    }
    return plan;
}

} // namespace halbench::control
