#pragma once

#include "devices/link_orders.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

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

} // namespace halbench::devices
