#include "devices/simulated/registry/simulated_device.h"

#include "devices/simulated/loopback_transport.h"
#include "devices/simulated/registry/simulated_models.h"
#include "devices/xcp/xcp_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

namespace halbench::devices {
namespace {

std::string addressOf(const SimulatedModel& model) {
    return "sim:" + model.name;
}

Result<const SimulatedModel*> modelOf(const DeviceUri& uri) {
    if (const SimulatedModel* model = findSimulatedModel(uri.address)) {
        return model;
    }
    std::vector<std::string> built;
    for (const SimulatedModel& model : simulatedModels()) {
        built.push_back(addressOf(model));
    }
    return failure(ErrorCode::UnknownName, fmt::format("there is no simulator 'sim:{}'", uri.address),
                   fmt::format("Built simulators: {}.", fmt::join(built, ", ")));
}

Result<std::uint64_t> parseSeed(const std::string& text, const SimulatedModel& model) {
    std::uint64_t seed = 0;
    const char* end = text.data() + text.size();
    const auto [stop, status] = std::from_chars(text.data(), end, seed);
    if (status != std::errc() || stop != end) {
        return failure(ErrorCode::InvalidInput, fmt::format("seed={} is not a whole number", text),
                       fmt::format("A seed is a whole number from 0 to 18446744073709551615. Known keys: {}.",
                                   model.overrides));
    }
    return seed;
}

} // namespace

Result<SimulatedSetup> parseSimulatedAddress(const DeviceUri& uri, std::optional<std::uint64_t> seed) {
    const Result<const SimulatedModel*> model = modelOf(uri);
    if (!model) {
        return failure(model.error());
    }
    SimulatedSetup setup;
    setup.model = *model;
    setup.overrides = uri.options;
    if (const Result<void> checked = setup.model->check(setup.overrides); !checked) {
        return failure(checked.error());
    }
    if (const std::optional<std::string> text = uri.option("seed")) {
        const Result<std::uint64_t> given = parseSeed(*text, *setup.model);
        if (!given) {
            return failure(given.error());
        }
        setup.seed = *given;
    }
    setup.seed = seed.value_or(setup.seed);
    std::sort(setup.overrides.begin(), setup.overrides.end());
    return setup;
}

Result<std::unique_ptr<SimulatedBoard>>
makeSimulatedBoard(const DeviceUri& uri, std::optional<std::uint64_t> seed, SimulatedBoard::Line line) {
    const auto setup = parseSimulatedAddress(uri, seed);
    if (!setup) {
        return failure(setup.error());
    }
    return setup->model->make(setup->overrides, setup->seed, line);
}

Result<std::unique_ptr<Device>> openSimulatedDevice(const DeviceUri& uri, const OpenOptions& options) {
    const auto setup = parseSimulatedAddress(uri, options.seed);
    if (!setup) {
        return failure(setup.error());
    }
    auto board = setup->model->make(setup->overrides, setup->seed, {});
    if (!board) {
        return failure(board.error());
    }
    XcpDeviceOptions device;
    device.identity.uri = uri.text;
    device.identity.model = uri.address;
    device.identity.id = fmt::format("sim-{}-{}", uri.address, setup->seed);
    device.identity.transport = "loopback";
    device.identity.isSimulated = true;
    device.identity.overrides = setup->overrides;
    device.interruptSignal = options.interruptSignal;
    device.orders = options.orders;
    device.onMessage = options.onMessage;
    return openXcpDevice(std::make_unique<LoopbackTransport>(std::move(*board), options.isRealtime),
                         std::move(device));
}

std::vector<DeviceListing> listSimulatedDevices() {
    std::vector<DeviceListing> devices;
    for (const SimulatedModel& model : simulatedModels()) {
        DeviceListing listing;
        listing.uri = addressOf(model);
        listing.model = model.name;
        listing.transport = "loopback";
        listing.id = fmt::format("sim-{}-1", model.name);
        listing.isSimulated = true;
        listing.isAvailable = true;
        devices.push_back(listing);
    }
    return devices;
}

} // namespace halbench::devices
