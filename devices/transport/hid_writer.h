#pragma once

#include "control/base/result.h"
#include "devices/transport/hid_port.h"

#include <hidapi.h>

#include <memory>
#include <span>
#include <string>
#include <thread>

namespace halbench::devices {

struct HidDeleter {
    void operator()(hid_device* device) const { hid_close(device); }
};
using HidHandle = std::unique_ptr<hid_device, HidDeleter>;

/// Writes reports in a thread of its own. When a device takes none, the system holds whoever writes for up to
/// five seconds, whatever the descriptor says; nobody who drives an actuator may wait so long. The thread
/// owns the handle, so that a writer that is given up need not wait for it either. Thread: the connection's.
class HidWriter {
public:
    HidWriter(HidHandle device, std::string description);
    ~HidWriter();
    HidWriter(const HidWriter&) = delete;
    HidWriter& operator=(const HidWriter&) = delete;

    /// Returns when the device has taken them all. Errors: DeviceLost (unplugged, takes no more).
    Result<void> write(std::span<const std::uint8_t> octets);

private:
    struct Shared;
    static void run(const std::shared_ptr<Shared>& shared);

    std::shared_ptr<Shared> m_shared;
    std::string m_description;
    std::thread m_thread;
};

} // namespace halbench::devices
