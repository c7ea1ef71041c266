#pragma once

#include "devices/transport/descriptor.h"
#include "devices/transport/udev_handle.h"

namespace halbench::devices {

/// Tells when ports come and go, where the system does. Thread: the one that waits; wake() from any.
class Hotplug {
public:
    Hotplug();

    /// Returns after an event, wake() or this time. A system without udev tells of no events: look anyway.
    void waitFor(double timeout_s);
    void wake();

private:
    UdevHandle<udev> m_context;
    UdevHandle<udev_monitor> m_monitor;
    Descriptor m_wake; ///< an eventfd
};

} // namespace halbench::devices
