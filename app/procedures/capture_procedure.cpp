#include "app/procedures/capture_procedure.h"

#include "app/procedures/procedure_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace halbench::app {
namespace {

// The board's side of it: devices/firmware/control/hb_capture.h.
constexpr std::size_t Channels = 4;
constexpr double Rows = 4096.0;
constexpr double LoopRate_Hz = 1000.0;
constexpr double LargestPrescaler = 1000.0;
constexpr double NoSignal = 255.0;
constexpr double Waiting = 2.0; // of capture.state
constexpr double Full = 4.0;
constexpr const char* StateName = "capture.state";
constexpr const char* StartName = "capture.start";

double prescalerFor(double rate_Hz) {
    return std::clamp(std::round(LoopRate_Hz / rate_Hz), 1.0, LargestPrescaler);
}

Result<void> checkNumbers(const CaptureConfig& config) {
    if (!std::isfinite(config.rate_Hz) || config.rate_Hz <= 0.0) {
        return failure(ErrorCode::OutOfRange, "the rate must be more than zero", "Give e.g. --rate 1000.");
    }
    const double divider = prescalerFor(config.rate_Hz);
    if (std::fabs(divider * config.rate_Hz - LoopRate_Hz) > 1e-6 * LoopRate_Hz) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a capture at {} Hz is not possible", config.rate_Hz),
                       fmt::format("the rate must divide that of the loop, {} Hz; the nearest is {} Hz",
                                   LoopRate_Hz, LoopRate_Hz / divider));
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
    if (catalogue.findSignal(StateName) == nullptr || catalogue.findParameter(StartName) == nullptr) {
        return failure(ErrorCode::DeviceRefused, "this board cannot capture by itself",
                       "record a stream instead");
    }
    if (config.signals.empty() || config.signals.size() > Channels) {
        return failure(ErrorCode::Usage, fmt::format("a capture takes 1 to {} signals", Channels),
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

std::vector<ParameterValue> setUp(const devices::Catalogue& catalogue, const CaptureConfig& config) {
    const CaptureTrigger& trigger = config.trigger;
    const bool isLevel = trigger.kind == CaptureTrigger::Kind::Level;
    std::vector<ParameterValue> values = {
        {"capture.trigger", static_cast<double>(trigger.kind)},
        {"capture.trigger_signal", isLevel ? handleOf(catalogue, trigger.signal) : NoSignal},
        {"capture.level", trigger.level},
        {"capture.slope", trigger.isRising ? 0.0 : 1.0},
        {"capture.pretrigger", std::floor(config.pretrigger_ratio * Rows)},
        {"capture.prescaler", prescalerFor(config.rate_Hz)}};
    for (std::size_t channel = 0; channel < Channels; ++channel) {
        values.push_back(
            {fmt::format("capture.signal_{}", channel + 1),
             channel < config.signals.size() ? handleOf(catalogue, config.signals[channel]) : NoSignal});
    }
    return values;
}

Result<void> start(devices::Device& device, double value) {
    const ParameterValue command[] = {{StartName, value}};
    return device.writeParameters(command);
}

/// What was set up before, with the same names as `values`.
Result<std::vector<ParameterValue>> readBefore(devices::Device& device, std::vector<ParameterValue> values) {
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

/// Until the board's memory is full. Only the wait for the trigger has an end of its own.
Result<void> awaitFull(devices::Device& device, const CaptureConfig& config,
                       const ProcedureObserver& observer) {
    constexpr double Piece_s = 0.05;
    const std::string name[] = {StateName};
    double waited_s = 0.0;
    for (;;) {
        const auto state = device.readSignals(name);
        if (!state) {
            return failure(state.error());
        }
        if (state->front() == Full) {
            return {};
        }
        waited_s += state->front() == Waiting ? Piece_s : 0.0;
        if (waited_s > config.patience_s) {
            return failure(ErrorCode::Refused,
                           fmt::format("the trigger did not come within {} s", config.patience_s),
                           "wait longer with --wait, or choose another --trigger");
        }
        const bool isWaiting = state->front() == Waiting;
        const char* text = isWaiting ? "waits for the trigger" : "captures";
        if (auto waited = waitObserved(device, observer, Piece_s, 0.0, 0.0, text); !waited) {
            return waited;
        }
    }
}

Result<Recording> checkCapture(Result<Recording> capture, const CaptureConfig& config) {
    if (!capture) {
        return capture;
    }
    for (std::size_t column = 0; column < config.signals.size(); ++column) {
        if (!capture->layout || capture->layout->columns.size() != config.signals.size() ||
            capture->layout->columns[column].name != config.signals[column]) {
            return failure(ErrorCode::Protocol, "the board captured other signals than it was asked for",
                           "another program may be using its capture; try again");
        }
    }
    const bool isFinite = std::all_of(capture->values.begin(), capture->values.end(),
                                      [](double value) { return std::isfinite(value); });
    return isFinite ? std::move(capture)
                    : failure(ErrorCode::NotFinite, "a captured value is not a number",
                              "The board or the link delivers damaged values; nothing was kept of them.");
}

} // namespace

Result<CaptureTrigger> parseCaptureTrigger(const std::string& text) {
    CaptureTrigger trigger;
    if (text.empty() || text == "now") {
        return trigger;
    }
    if (text == "reference") {
        trigger.kind = CaptureTrigger::Kind::Reference;
        return trigger;
    }
    const std::size_t sign = text.find_first_of("<>");
    const char* begin = text.data() + std::min(sign, text.size() - 1) + 1;
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(begin, end, trigger.level);
    if (sign == std::string::npos || sign == 0 || parsed.ec != std::errc{} || parsed.ptr != end) {
        return failure(ErrorCode::Usage, fmt::format("'{}' is no trigger", text),
                       "use now, reference, SIGNAL>LEVEL (rising) or SIGNAL<LEVEL (falling)");
    }
    if (!std::isfinite(trigger.level)) {
        return failure(ErrorCode::NotFinite, "the level of a trigger is not finite", "give a number");
    }
    trigger.kind = CaptureTrigger::Kind::Level;
    trigger.signal = text.substr(0, sign);
    trigger.isRising = text[sign] == '>';
    return trigger;
}

Result<Recording> runCapture(devices::Device& device, const CaptureConfig& config,
                             const ProcedureObserver& observer) {
    if (auto entered = enterState(observer, ProcedureState::Prepare); !entered) {
        return failure(entered.error());
    }
    Result<void> checked = checkNumbers(config);
    checked = checked ? checkSignals(device.catalogue(), config) : checked;
    if (!checked) {
        return failure(checked.error());
    }
    const std::vector<ParameterValue> values = setUp(device.catalogue(), config);
    const auto before = readBefore(device, values);
    if (!before) {
        return failure(before.error());
    }
    Result<void> done = device.writeParameters(values);
    done = done ? start(device, 1.0) : done;
    done = done ? enterState(observer, ProcedureState::Record) : done;
    done = done ? awaitFull(device, config, observer) : done;
    Result<Recording> capture =
        done ? checkCapture(device.readCapture(), config) : Result<Recording>(failure(done.error()));
    const Result<void> stopped = start(device, 0.0);
    const Result<void> restored = device.writeParameters(*before);
    if (!capture) {
        return capture;
    }
    if (!stopped || !restored) {
        return failure(stopped ? restored.error() : stopped.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Done); !entered) {
        return failure(entered.error());
    }
    return capture;
}

} // namespace halbench::app
