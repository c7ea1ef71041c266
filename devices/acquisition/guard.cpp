#include "devices/acquisition/guard.h"

#include <fmt/format.h>

#include <cmath>

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
    for (GuardLimit& limit : m_limits) {
        const int index = block.layout->indexOf(limit.signal);
        for (std::size_t row = 0; index >= 0 && !m_error && row < block.rows(); ++row) {
            const auto column = static_cast<std::size_t>(index);
            checkValue(limit, block.value(row, column), block.layout->columns[column], block.time_s[row]);
        }
    }
}

void Guard::checkValue(GuardLimit& limit, double value, const StreamLayout::Column& column, double time_s) {
    if (limit.isFromStart && std::isfinite(value)) {
        limit.min += value;
        limit.max += value;
        limit.isFromStart = false;
    }
    if (value >= limit.min && value <= limit.max) {
        return;
    }
    m_device->stop();
    const std::string what = std::isfinite(value)
                                 ? fmt::format("{:.4g} {} and outside {:.4g} to {:.4g} {}", value,
                                               column.unit, limit.min, limit.max, column.unit)
                                 : std::string("not a number");
    m_error = Error{ErrorCode::SafetyStop,
                    fmt::format("stopped from here: {} was {} at {:.3f} s", limit.signal, what, time_s),
                    "find the cause, then clear the stop before arming again"};
}

} // namespace halbench::devices
