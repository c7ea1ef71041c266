#include "devices/simulated/simulated_device.h"

#include "devices/simulated/loopback_transport.h"
#include "devices/xcp/xcp_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

namespace halbench::devices {
namespace {

std::string knownKeys() {
    return "Known keys: " + models::htmParameterKeys() + ".";
}

Result<void> checkSimulator(const DeviceUri& uri) {
    if (uri.address == "htm") {
        return {};
    }
    const bool isPlanned = uri.address == "planar" || uri.address == "spherical";
    return failure(ErrorCode::UnknownName,
                   isPlanned ? fmt::format("the simulator 'sim:{}' is not built in this version", uri.address)
                             : fmt::format("there is no simulator 'sim:{}'", uri.address),
                   "Built simulators: sim:htm.");
}

Result<double> parseNumber(const std::string& key, const std::string& text) {
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, status] = std::from_chars(text.data(), end, value);
    if (status == std::errc::result_out_of_range && stop == end) {
        return failure(ErrorCode::OutOfRange, fmt::format("{}={} is out of range", key, text), knownKeys());
    }
    if (status != std::errc() || stop != end) {
        return failure(ErrorCode::InvalidInput, fmt::format("{}={} is not a number", key, text),
                       "Write numbers like 2e-3. " + knownKeys());
    }
    return value;
}

Result<std::uint64_t> parseSeed(const std::string& text) {
    std::uint64_t seed = 0;
    const char* end = text.data() + text.size();
    const auto [stop, status] = std::from_chars(text.data(), end, seed);
    if (status != std::errc() || stop != end) {
        return failure(ErrorCode::InvalidInput, fmt::format("seed={} is not a whole number", text),
                       "A seed is a whole number from 0 to 18446744073709551615. " + knownKeys());
    }
    return seed;
}

// One of two words; true for the second.
Result<bool> parseChoice(const DeviceUri& uri, const std::string& key, const char* usual, const char* other) {
    const std::optional<std::string> text = uri.option(key);
    if (!text || *text == usual) {
        return false;
    }
    if (*text == other) {
        return true;
    }
    return failure(ErrorCode::InvalidInput, fmt::format("{}={} is unknown", key, *text),
                   fmt::format("Allowed: {}={} and {}={}. {}", key, usual, key, other, knownKeys()));
}

Result<models::HtmParameters> parameterSet(const DeviceUri& uri) {
    const Result<bool> isOff = parseChoice(uri, "imperfections", "on", "off");
    if (!isOff) {
        return failure(isOff.error());
    }
    const Result<bool> isIdeal = parseChoice(uri, "chain", "full", "ideal");
    if (!isIdeal) {
        return failure(isIdeal.error());
    }
    models::HtmParameters parameters;
    if (*isOff) {
        parameters = withoutImperfections(parameters);
    }
    return *isIdeal ? withIdealChain(parameters) : parameters;
}

Result<void> applyOption(SimulatedSetup& setup, const std::string& key, const std::string& text) {
    if (key == "imperfections" || key == "chain") {
        return {};
    }
    if (key == "seed") {
        const Result<std::uint64_t> seed = parseSeed(text);
        if (!seed) {
            return failure(seed.error());
        }
        setup.seed = *seed;
        return {};
    }
    if (models::findHtmParameter(key) == nullptr) {
        return failure(ErrorCode::UnknownName, fmt::format("sim:htm has no override '{}'", key), knownKeys());
    }
    const Result<double> value = parseNumber(key, text);
    if (!value) {
        return failure(value.error());
    }
    return models::setHtmParameter(setup.parameters, key, *value);
}

} // namespace

Result<SimulatedSetup> parseSimulatedAddress(const DeviceUri& uri, std::optional<std::uint64_t> seed) {
    if (auto known = checkSimulator(uri); !known) {
        return failure(known.error());
    }
    const auto parameters = parameterSet(uri);
    if (!parameters) {
        return failure(parameters.error());
    }
    SimulatedSetup setup;
    setup.parameters = *parameters;
    for (const auto& [key, text] : uri.options) {
        if (auto applied = applyOption(setup, key, text); !applied) {
            return failure(applied.error());
        }
    }
    setup.seed = seed.value_or(setup.seed);
    setup.overrides = uri.options;
    std::sort(setup.overrides.begin(), setup.overrides.end());
    return setup;
}

Result<std::unique_ptr<SimulatedBoard>>
makeSimulatedBoard(const DeviceUri& uri, std::optional<std::uint64_t> seed, SimulatedBoard::Line line) {
    const auto setup = parseSimulatedAddress(uri, seed);
    if (!setup) {
        return failure(setup.error());
    }
    return SimulatedBoard::make(setup->parameters, setup->seed, line);
}

Result<std::unique_ptr<Device>> openSimulatedDevice(const DeviceUri& uri, const OpenOptions& options) {
    const auto setup = parseSimulatedAddress(uri, options.seed);
    if (!setup) {
        return failure(setup.error());
    }
    auto board = SimulatedBoard::make(setup->parameters, setup->seed);
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
    DeviceListing motor;
    motor.uri = "sim:htm";
    motor.model = "htm";
    motor.transport = "loopback";
    motor.id = "sim-htm-1";
    motor.isSimulated = true;
    motor.isAvailable = true;
    return {motor};
}

} // namespace halbench::devices
