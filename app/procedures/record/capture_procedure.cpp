#include "app/procedures/record/capture_procedure.h"

#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/record/capture_orders.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace halbench::app {
namespace {

/// Until the board's memory is full. Only the wait for the trigger has an end of its own.
Result<void> awaitFull(devices::Device& device, const CaptureConfig& config,
                       const ProcedureObserver& observer) {
    constexpr double Piece_s = 0.05;
    double waited_s = 0.0;
    for (;;) {
        const Result<CaptureState> state = readCaptureState(device);
        if (!state) {
            return failure(state.error());
        }
        if (*state == CaptureState::Full) {
            return {};
        }
        waited_s += *state == CaptureState::Waiting ? Piece_s : 0.0;
        if (waited_s > config.patience_s) {
            return failure(ErrorCode::Refused,
                           fmt::format("the trigger did not come within {} s", config.patience_s),
                           "wait longer with --wait, or choose another --trigger");
        }
        const bool isWaiting = *state == CaptureState::Waiting;
        const char* text = isWaiting ? "waiting for the trigger" : "captures";
        if (auto waited = waitObserved(device, observer, Piece_s, 0.0, 0.0, text); !waited) {
            return waited;
        }
    }
}

/// All pieces of a full one.
Result<Recording> readAll(devices::Device& device, const ProcedureObserver& observer) {
    constexpr int MostPieces = 4096; // one row each
    for (int piece = 0; piece < MostPieces; ++piece) {
        Result<Recording> capture = device.readCapture();
        if (!capture || capture->rows() > 0) {
            return capture;
        }
        if (const Result<void> goOn = observer.checkAbort ? observer.checkAbort() : Result<void>(); !goOn) {
            return failure(goOn.error());
        }
    }
    return failure(ErrorCode::Protocol, "the device sent no data of its completed capture",
                   "another program may be using its capture; try again");
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
        return failure(ErrorCode::Usage, fmt::format("'{}' is not a trigger", text),
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
    const auto values = captureSetUp(device.catalogue(), config);
    if (!values) {
        return failure(values.error());
    }
    const auto before = captureSetUpBefore(device, *values);
    if (!before) {
        return failure(before.error());
    }
    Result<void> done = startCapture(device, *values);
    done = done ? enterState(observer, ProcedureState::Record) : done;
    done = done ? awaitFull(device, config, observer) : done;
    Result<Recording> capture =
        done ? checkCapture(readAll(device, observer), config) : Result<Recording>(failure(done.error()));
    const Result<void> ended = endCapture(device, *before);
    if (!capture) {
        return capture;
    }
    if (!ended) {
        return failure(ended.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Done); !entered) {
        return failure(entered.error());
    }
    return capture;
}

} // namespace halbench::app
