#include "devices/open/device_watcher.h"

#include "devices/transport/hotplug.h"

#include <atomic>
#include <optional>
#include <thread>

namespace halbench::devices {

class DeviceWatcher::Thread {
public:
    Thread(Listener listener, Lister lister, double rescan_s)
        : m_listener(std::move(listener)), m_lister(std::move(lister)), m_rescan_s(rescan_s),
          m_thread([this] { run(); }) {}
    ~Thread() {
        m_isEnding = true;
        m_hotplug.wake();
        m_thread.join();
    }
    Thread(const Thread&) = delete;
    Thread& operator=(const Thread&) = delete;

private:
    void run() {
        std::optional<std::vector<DeviceListing>> known;
        while (!m_isEnding) {
            std::vector<DeviceListing> found = m_lister();
            if (found != known && !m_isEnding) {
                known = std::move(found);
                m_listener(*known);
            }
            m_hotplug.waitFor(m_rescan_s);
        }
    }

    Listener m_listener;
    Lister m_lister;
    double m_rescan_s;
    Hotplug m_hotplug;
    std::atomic<bool> m_isEnding{false};
    std::thread m_thread;
};

DeviceWatcher::DeviceWatcher(Listener listener, Lister lister, double rescan_s)
    : m_thread(std::make_unique<Thread>(std::move(listener), std::move(lister), rescan_s)) {}

DeviceWatcher::~DeviceWatcher() = default;

} // namespace halbench::devices
