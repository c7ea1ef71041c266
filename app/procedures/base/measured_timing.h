#pragma once

#include "control/base/result.h"
#include "control/law/position_loop.h"
#include "devices/device.h"

#include <optional>
#include <span>

namespace halbench::app {

/// Sampling period and computing delay of the board that a motor was measured with, as far as they are known.
struct MeasuredTiming {
    std::optional<double> period_s = {};
    std::optional<int> delay_samples = {};

    bool operator==(const MeasuredTiming&) const = default;
};

/// Timing of the position loop from what a device says of itself: its delay is among `values`.
MeasuredTiming timingOf(const devices::Catalogue& catalogue, std::span<const ParameterValue> values);

/// Measured timing as far as it is known, else `otherwise`.
control::LoopTiming timingOr(const MeasuredTiming& measured, control::LoopTiming otherwise);

/// Equal up to the single precision of a board.
bool isSamePeriod(double one_s, double other_s);
bool isSameTiming(const control::LoopTiming& one, const control::LoopTiming& other);

/// A model is not judged for a loop that samples or waits otherwise than the one it was measured with.
/// Errors: Refused, with both.
Result<void> checkTimingOfModel(const MeasuredTiming& model, const control::LoopTiming& device);

} // namespace halbench::app
