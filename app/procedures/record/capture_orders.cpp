#include "app/procedures/record/capture_orders.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

// The board's side of it: devices/firmware/control/hb_capture.h.
constexpr double LargestPrescaler = 1000.0;
constexpr double NoSignal = 255.0;
constexpr const char* StateName = "capture.state";
constexpr const char* StartName = "capture.start";

double prescalerFor(double rate_Hz) {
    return std::clamp(std::round(CaptureRate_Hz / rate_Hz), 1.0, LargestPrescaler);
}

Result<void> checkNumbers(const CaptureConfig& config) {
    if (!std::isfinite(config.rate_Hz) || config.rate_Hz <= 0.0) {
        return failure(ErrorCode::OutOfRange, "the rate must be more than zero", "Give e.g. --rate 1000.");
    }
    const double divider = prescalerFor(config.rate_Hz);
    if (std::fabs(divider * config.rate_Hz - CaptureRate_Hz) > 1e-6 * CaptureRate_Hz) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a capture at {} Hz is not possible", config.rate_Hz),
                       fmt::format("the rate must divide that of the loop, {} Hz; the nearest is {} Hz",
                                   CaptureRate_Hz, CaptureRate_Hz / divider));
    }
    if (!(config.pretrigger_ratio >= 0.0 && config.pretrigger_ratio < 1.0)) {
        return failure(ErrorCode::OutOfRange, "the share of rows before the trigger lies from 0 to below 1",
                       "Give e.g. --pre-trigger 0.25.");
    }
    if (!std::isfinite(config.patience_s) || config.patience_s <= 0.0) {
        return failure(ErrorCode::OutOfRange, "the wait for the trigger must be more than zero seconds",
                       "Give e.g. --wait 10.");
    }
    return {};
}

Result<void> checkSignals(const devices::Catalogue& catalogue, const CaptureConfig& config) {
    if (!canCapture(catalogue)) {
        return failure(ErrorCode::DeviceRefused, "this device has no capture function",
                       "record a stream instead");
    }
    if (config.signals.empty() || config.signals.size() > CaptureSignals) {
        return failure(ErrorCode::Usage, fmt::format("a capture takes 1 to {} signals", CaptureSignals),
                       "record a stream for more");
    }
    std::vector<std::string> names = config.signals;
    if (config.trigger.kind == CaptureTrigger::Kind::Level) {
        names.push_back(config.trigger.signal);
    }
    for (const std::string& name : names) {
        if (catalogue.findSignal(name) == nullptr) {
            return failure(ErrorCode::UnknownName, fmt::format("the device has no signal '{}'", name),
                           "`halbench describe` lists the signals.");
        }
        if (std::count(config.signals.begin(), config.signals.end(), name) > 1) {
            return failure(ErrorCode::Usage, fmt::format("the signal '{}' is named twice", name),
                           "Name every signal once.");
        }
    }
    return {};
}

/// Number of a signal in the board's table, which its description lists in order.
double handleOf(const devices::Catalogue& catalogue, const std::string& name) {
    return static_cast<double>(catalogue.findSignal(name) - catalogue.signals.data());
}

Result<void> order(devices::Device& device, double value) {
    const ParameterValue command[] = {{StartName, value}};
    return device.writeParameters(command);
}

} // namespace

bool canCapture(const devices::Catalogue& catalogue) {
    return catalogue.findSignal(StateName) != nullptr && catalogue.findParameter(StartName) != nullptr;
}

double captureRateFor_Hz(double length_s) {
    constexpr double Rounding = 1e-9; // 8.192 s are two loops a row, however they were computed
    const double divider = std::ceil(length_s * CaptureRate_Hz / CaptureRows - Rounding);
    return CaptureRate_Hz / std::clamp(divider, 1.0, LargestPrescaler);
}

Result<std::vector<ParameterValue>> captureSetUp(const devices::Catalogue& catalogue,
                                                 const CaptureConfig& config) {
    Result<void> checked = checkNumbers(config);
    checked = checked ? checkSignals(catalogue, config) : checked;
    if (!checked) {
        return failure(checked.error());
    }
    const CaptureTrigger& trigger = config.trigger;
    const bool isLevel = trigger.kind == CaptureTrigger::Kind::Level;
    std::vector<ParameterValue> values = {
        {"capture.trigger", static_cast<double>(trigger.kind)},
        {"capture.trigger_signal", isLevel ? handleOf(catalogue, trigger.signal) : NoSignal},
        {"capture.level", trigger.level},
        {"capture.slope", trigger.isRising ? 0.0 : 1.0},
        {"capture.pretrigger", std::floor(config.pretrigger_ratio * CaptureRows)},
        {"capture.prescaler", prescalerFor(config.rate_Hz)}};
    for (std::size_t channel = 0; channel < CaptureSignals; ++channel) {
        values.push_back(
            {fmt::format("capture.signal_{}", channel + 1),
             channel < config.signals.size() ? handleOf(catalogue, config.signals[channel]) : NoSignal});
    }
    return values;
}

Result<std::vector<ParameterValue>> captureSetUpBefore(devices::Device& device,
                                                       std::vector<ParameterValue> values) {
    std::vector<std::string> names;
    names.reserve(values.size());
    for (const ParameterValue& value : values) {
        names.push_back(value.name);
    }
    const auto read = device.readParameters(names);
    for (std::size_t i = 0; read && i < values.size(); ++i) {
        values[i].value = (*read)[i];
    }
    return read ? Result<std::vector<ParameterValue>>(std::move(values)) : failure(read.error());
}

Result<void> startCapture(devices::Device& device, const std::vector<ParameterValue>& values) {
    const Result<void> written = device.writeParameters(values);
    return written ? order(device, 1.0) : written;
}

Result<void> endCapture(devices::Device& device, const std::vector<ParameterValue>& before) {
    const Result<void> stopped = order(device, 0.0);
    const Result<void> restored = device.writeParameters(before);
    return stopped ? restored : stopped;
}

Result<CaptureState> readCaptureState(devices::Device& device) {
    const std::string name[] = {StateName};
    const auto state = device.readSignals(name);
    if (!state) {
        return failure(state.error());
    }
    const double value = state->front();
    if (!(value >= 0.0 && value <= static_cast<double>(CaptureState::Full))) {
        return failure(ErrorCode::Protocol, "unknown capture state of the device",
                       "update Halbench, or the board's firmware");
    }
    return static_cast<CaptureState>(static_cast<int>(value));
}

Result<Recording> checkCapture(Result<Recording> capture, const CaptureConfig& config) {
    if (!capture) {
        return capture;
    }
    for (std::size_t column = 0; column < config.signals.size(); ++column) {
        if (!capture->layout || capture->layout->columns.size() != config.signals.size() ||
            capture->layout->columns[column].name != config.signals[column]) {
            return failure(ErrorCode::Protocol, "the device captured other signals than requested",
                           "another program may be using its capture; try again");
        }
    }
    const bool isFinite = std::all_of(capture->values.begin(), capture->values.end(),
                                      [](double value) { return std::isfinite(value); });
    return isFinite ? std::move(capture)
                    : failure(ErrorCode::NotFinite, "a captured value is not a number",
                              "Damaged values from the device or the link; nothing was saved.");
}

} // namespace halbench::app
