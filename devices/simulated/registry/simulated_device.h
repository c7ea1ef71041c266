#pragma once

#include "devices/device.h"
#include "devices/device_options.h"
#include "devices/device_uri.h"
#include "devices/simulated/simulated_model.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halbench::devices {

/// What `sim:NAME?KEY=VALUE&...` asks for. Source: resources/help/command-line.md.
struct SimulatedSetup {
    const SimulatedModel* model = nullptr;
    std::uint64_t seed = 1;
    Overrides overrides; ///< as written, sorted by key
};

/// `seed` (of the command line) wins over the address. Errors: UnknownName (a simulator or key that does not
/// exist; the hint lists what does), InvalidInput, NotFinite, OutOfRange.
Result<SimulatedSetup> parseSimulatedAddress(const DeviceUri& uri, std::optional<std::uint64_t> seed);

/// The board alone, for a caller that brings its own link (`serve`). Errors as above.
Result<std::unique_ptr<SimulatedBoard>> makeSimulatedBoard(const DeviceUri& uri,
                                                           std::optional<std::uint64_t> seed,
                                                           SimulatedBoard::Line line = {nullptr, 0});

/// The board behind the loopback as a Device. Errors as above, DeviceLost, Protocol.
Result<std::unique_ptr<Device>> openSimulatedDevice(const DeviceUri& uri, const OpenOptions& options);

/// One address per simulator that is built.
std::vector<DeviceListing> listSimulatedDevices();

} // namespace halbench::devices
