#include "devices/transport/octet_inbox.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace halbench::devices {

void OctetInbox::put(std::span<const std::uint8_t> octets) {
    {
        const std::lock_guard lock(m_mutex);
        m_received += octets.size();
        if (m_error) {
            return; // nothing follows the end
        }
        if (m_waiting.size() + octets.size() > MaxWaiting) {
            keepFirst({ErrorCode::DeviceLost,
                       fmt::format("{} MB from the device were not processed in time", MaxWaiting >> 20),
                       "the computer was too busy or in standby: connect again, with fewer signals or a "
                       "lower rate"});
        } else {
            m_waiting.insert(m_waiting.end(), octets.begin(), octets.end());
        }
    }
    m_changed.notify_one();
}

void OctetInbox::fail(Error error) {
    {
        const std::lock_guard lock(m_mutex);
        keepFirst(std::move(error));
    }
    m_changed.notify_one();
}

void OctetInbox::keepFirst(Error error) {
    if (!m_error) {
        m_error = std::move(error);
    }
}

void OctetInbox::clear() {
    const std::lock_guard lock(m_mutex);
    m_waiting.clear();
    m_error.reset();
}

Result<bool> OctetInbox::take(std::vector<std::uint8_t>& octets, double timeout_s) {
    octets.clear();
    std::unique_lock lock(m_mutex);
    const auto hasNews = [this] { return !m_waiting.empty() || m_error; };
    if (timeout_s > 0.0) {
        m_changed.wait_for(lock, std::chrono::duration<double>(std::min(timeout_s, 3600.0)), hasNews);
    }
    if (!m_waiting.empty()) {
        octets.swap(m_waiting);
        return true;
    }
    if (m_error) {
        return failure(*m_error);
    }
    return false;
}

std::uint64_t OctetInbox::received() const {
    const std::lock_guard lock(m_mutex);
    return m_received;
}

} // namespace halbench::devices
