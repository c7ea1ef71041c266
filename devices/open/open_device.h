#pragma once

#include "devices/device.h"
#include "devices/link_orders.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace halbench::devices {

/// What a command or window knows when it opens a device.
struct OpenOptions {
    std::optional<std::uint64_t> seed; ///< `--seed`: wins over `?seed=`
    bool isRealtime = false;           ///< `--realtime`: a simulated device is paced by the wall clock
    const std::atomic<int>* interruptSignal = nullptr; ///< becomes the signal that ends the program
    std::shared_ptr<const LinkOrders> orders;          ///< of other threads; may be empty
    std::function<void(const std::string&)> onMessage; ///< log lines of board and link; may be empty
    std::function<void(double)> onProgress; ///< share of a recording that is read by now; may be empty
    /// Where descriptions of boards in the network are kept between connections; empty: nowhere.
    std::string cacheFolder;
};

/// The user's folder for descriptions, e.g. ~/.cache/halbench/boards (XDG_CACHE_HOME).
std::string userCacheFolder();

/// Opens any device by its address and reads its catalogue.
/// Errors: InvalidInput, UnknownName, OutOfRange (address), DeviceLost, Protocol.
Result<std::unique_ptr<Device>> openDevice(const std::string& uri, const OpenOptions& options);

/// One line of `halbench devices`.
struct DeviceListing {
    std::string uri;
    std::string model;
    std::string transport;
    std::string id;   ///< serial number
    std::string name; ///< maker and product, as the hardware says; empty otherwise
    bool isSimulated = false;
    bool isAvailable = false;
    std::string reason; ///< why it cannot be opened
    std::string hint;

    bool operator==(const DeviceListing&) const = default;
};

/// Simulated devices and the ports that are plugged in; opens none of them. Not for the window's thread: it
/// reads many small files of the system.
std::vector<DeviceListing> listDevices();

} // namespace halbench::devices
