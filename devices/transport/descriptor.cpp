#include "devices/transport/descriptor.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace halbench::devices {

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
    if (this != &other) {
        close();
        m_number = std::exchange(other.m_number, -1);
    }
    return *this;
}

bool Descriptor::isReadableWithin(double timeout_s) const {
    const double bounded_s = std::clamp(timeout_s, 0.0, 3600.0);
    const double whole_s = std::floor(bounded_s);
    const timespec timeout{static_cast<time_t>(whole_s), static_cast<long>((bounded_s - whole_s) * 1e9)};
    pollfd entry{m_number, POLLIN, 0};
    return ::ppoll(&entry, 1, &timeout, nullptr) > 0;
}

void Descriptor::close() noexcept {
    if (m_number >= 0) {
        ::close(m_number);
        m_number = -1;
    }
}

} // namespace halbench::devices
