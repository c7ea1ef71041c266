#include "devices/transport/hotplug.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <cstdint>

namespace halbench::devices {

namespace {

/// A plugged-in device makes a burst of events; the list is read once, after it.
constexpr double Burst_s = 0.05;

} // namespace

Hotplug::Hotplug() : m_context(udev_new()), m_wake(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
    m_monitor.reset(m_context ? udev_monitor_new_from_netlink(m_context.get(), "udev") : nullptr);
    if (!m_monitor) {
        return;
    }
    for (const char* subsystem : {"tty", "usb", "hidraw"}) {
        udev_monitor_filter_add_match_subsystem_devtype(m_monitor.get(), subsystem, nullptr);
    }
    if (udev_monitor_enable_receiving(m_monitor.get()) < 0) {
        m_monitor.reset();
    }
}

void Hotplug::wake() {
    const std::uint64_t one = 1;
    (void)!::write(m_wake.number(), &one, sizeof one);
}

void Hotplug::waitFor(double timeout_s) {
    const int events = m_monitor ? udev_monitor_get_fd(m_monitor.get()) : -1; // -1: not waited for
    std::array<pollfd, 2> entries{pollfd{m_wake.number(), POLLIN, 0}, pollfd{events, POLLIN, 0}};
    if (::poll(entries.data(), entries.size(), static_cast<int>(timeout_s * 1e3)) <= 0) {
        return;
    }
    pollfd burst{events, POLLIN, 0};
    while ((entries[0].revents & POLLIN) == 0 && ::poll(&burst, 1, static_cast<int>(Burst_s * 1e3)) > 0) {
        const UdevHandle<udev_device> device(udev_monitor_receive_device(m_monitor.get()));
        if (!device) {
            break;
        }
    }
}

} // namespace halbench::devices
