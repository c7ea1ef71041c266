#include "devices/acquisition/guard.h"

#include <fmt/format.h>

namespace halbench::devices {

BlockSink Guard::watching(BlockSink next) {
    return [this, next = std::move(next)](const SampleBlockPtr& block) {
        check(*block);
        if (next) {
            next(block);
        }
    };
}

void Guard::check(const SampleBlock& block) {
    for (const GuardLimit& limit : m_limits) {
        const int column = block.layout->indexOf(limit.signal);
        for (std::size_t row = 0; column >= 0 && !m_error && row < block.rows(); ++row) {
            const double value = block.value(row, static_cast<std::size_t>(column));
            if (value >= limit.min && value <= limit.max) {
                continue;
            }
            m_device->stop();
            const std::string& unit = block.layout->columns[static_cast<std::size_t>(column)].unit;
            m_error = Error{ErrorCode::SafetyStop,
                            fmt::format("stopped: {} = {} {} at {} s is outside {} to {} {}", limit.signal,
                                        value, unit, block.time_s[row], limit.min, limit.max, unit),
                            "find the cause, then clear the stop before arming again"};
        }
    }
}

} // namespace halbench::devices
