#include "devices/open/disconnected_device.h"

#include <utility>

namespace halbench::devices {

DisconnectedDevice::DisconnectedDevice(const Device& former, double now_s, Error lost)
    : m_info(former.info()), m_catalogue(former.catalogue()), m_state(former.state()),
      m_statistics(former.statistics()), m_lost(std::move(lost)), m_clock(*this, now_s) {
    m_state.isConnected = false;
    m_state.isArmed = false; // its watchdog has seen to that, or soon will
}

} // namespace halbench::devices
