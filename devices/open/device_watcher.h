#pragma once

#include "devices/open/open_device.h"

#include <functional>
#include <memory>
#include <vector>

namespace halbench::devices {

/// Keeps the list of what can be connected up to date in a thread of its own: at events of the system, and by
/// looking every few seconds where there are none (no udev). Opens nothing.
class DeviceWatcher {
public:
    using Lister = std::function<std::vector<DeviceListing>()>;
    using Listener = std::function<void(const std::vector<DeviceListing>&)>;
    static constexpr double Rescan_s = 3.0;

    /// `listener` gets the list at the beginning and whenever it changed, in the watcher's thread.
    explicit DeviceWatcher(Listener listener, Lister lister = listDevices, double rescan_s = Rescan_s);
    /// The listener is not called any more afterwards.
    ~DeviceWatcher();
    DeviceWatcher(const DeviceWatcher&) = delete;
    DeviceWatcher& operator=(const DeviceWatcher&) = delete;

private:
    class Thread;
    std::unique_ptr<Thread> m_thread;
};

} // namespace halbench::devices
