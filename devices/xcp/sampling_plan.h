#pragma once

#include "devices/device.h"
#include "devices/xcp/board_description.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace halbench::devices::xcp {

/// How a stream is sampled: one event, divided on the board and, where that is not enough, on the host.
struct SamplingPlan {
    std::vector<DaqEntry> entries;
    std::shared_ptr<const StreamLayout> layout;
    std::uint16_t event = 0;
    std::uint8_t prescaler = 1;
    std::uint32_t hostDivider = 1;
    double boardPeriod_s = 0.0; ///< distance of the samples the board sends
};

/// Chooses the slowest event that carries every signal and whose rate is a whole multiple of the one asked
/// for. Errors: UnknownName (signal), OutOfRange (rate, naming the nearest possible ones), Usage (no signal).
Result<SamplingPlan> planSampling(const BoardDescription& board, const DaqAbility& ability,
                                  const StreamRequest& request);

} // namespace halbench::devices::xcp
