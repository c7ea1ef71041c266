#include "devices/open/device_return.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::devices {

DeviceReturn::DeviceReturn(DeviceInfo former, Opener open, ReturnTimes times)
    : m_former(std::move(former)), m_open(std::move(open)), m_times(times) {}

Result<void> DeviceReturn::noteLost(double now_s) {
    const bool isUnsettled = m_hasReturned && now_s - m_returned_s < m_times.settled_s;
    m_unsettled = isUnsettled ? m_unsettled + 1 : 0;
    if (m_unsettled >= m_times.mostUnsettled) {
        return failure(
            ErrorCode::Refused,
            fmt::format("{} reconnected and was lost again {} times in a row", m_former.uri, m_unsettled),
            "check for another program or a loose connector, then connect again");
    }
    m_pause_s = m_times.first_s;
    m_next_s = now_s + m_pause_s;
    return {};
}

Result<std::unique_ptr<Device>> DeviceReturn::look(double now_s) {
    if (now_s < m_next_s) {
        return std::unique_ptr<Device>();
    }
    Result<std::unique_ptr<Device>> found = m_open();
    if (!found) { // a port without its rights yet, a board that is still starting: all of it may pass
        m_reason = found.error();
        m_pause_s = std::min(m_pause_s * m_times.growth_ratio, m_times.longest_s);
        m_next_s = now_s + m_pause_s;
        return std::unique_ptr<Device>();
    }
    if (const Result<void> same = checkIdentity((*found)->info()); !same) {
        return failure(same.error());
    }
    m_returned_s = now_s;
    m_hasReturned = true;
    return found;
}

Result<void> DeviceReturn::checkIdentity(const DeviceInfo& found) const {
    if (found.id != m_former.id || found.model != m_former.model) {
        return failure(ErrorCode::Refused,
                       fmt::format("another device answers at {}: {} instead of {}", m_former.uri, found.id,
                                   m_former.id),
                       "plug in the previous device, or disconnect and connect this one");
    }
    if (found.firmware != m_former.firmware) {
        return failure(ErrorCode::Refused,
                       fmt::format("{} reconnected with other firmware: {} instead of {}", m_former.id,
                                   found.firmware, m_former.firmware),
                       "signals and parameters may differ: disconnect, then connect again");
    }
    return {};
}

} // namespace halbench::devices
