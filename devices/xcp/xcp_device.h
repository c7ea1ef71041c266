#pragma once

#include "devices/device.h"
#include "devices/link_orders.h"
#include "devices/profile.h"
#include "devices/transport/transport.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace halbench::devices {

/// What whoever opens a board knows or wants beyond the bytes.
struct XcpDeviceOptions {
    /// `uri`, `transport`, `isSimulated` and `overrides` are taken as given. An empty `model` becomes the
    /// board's own name (GET_ID 1), an empty `id` its identity text (GET_ID 0); `firmware` is always the
    /// board's EPK.
    DeviceInfo identity;
    /// Roles, procedures and known constants; without it the profile of the model is looked up among the
    /// shipped ones, and without that the board works by the names of its own description.
    std::optional<Profile> profile;
    /// Becomes the signal that ends the program: clock().waitFor() then returns Interrupted or Terminated.
    const std::atomic<int>* interruptSignal = nullptr;
    /// Orders of other threads; may be empty.
    std::shared_ptr<const LinkOrders> orders;
    /// Log lines of the board and remarks of the link ("values change one by one"); may be empty.
    std::function<void(const std::string&)> onMessage;
    /// Watchdog the board gets when it is armed; a status request is sent every quarter of it.
    double watchdog_s = 1.0;
    /// Folder where descriptions of boards are kept, so that the next connection need not read them; empty:
    /// none.
    std::string cacheFolder;
    /// Description (A2L) of a board that holds none, or another one than its own; empty: the board is asked.
    std::string description;
    /// Asks the board for its clock once a second while streaming, to tell its drift (3.9). Not for a board
    /// on a virtual clock: its clock is the host's.
    bool measuresClock = false;
    /// Brackets downloads by USER_CMD 01/02 where no page can be switched (vendor extension, never assumed).
    bool useVendorBrackets = false;
};

/// Opens the transport, connects, reads the board's description and gives the board as a `Device`.
/// Single threaded: whatever arrives is taken in while a command waits for its answer or clock().waitFor()
/// runs; sinks are called in waitFor() only. stop() may be called from a sink, other calls may not. Protocol:
/// resources/help/protocol.md, sections 3.5 to 3.15. Errors: DeviceLost (no answer), Protocol (answers that
/// make no sense), InvalidInput (description unreadable).
Result<std::unique_ptr<Device>> openXcpDevice(std::unique_ptr<Transport> transport, XcpDeviceOptions options);

} // namespace halbench::devices
