#include "devices/xcp/safety_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace halbench::devices::xcp {

namespace {

// Names every board of ours has (3.11, 3.15).
constexpr const char* StatusName = "status";
constexpr const char* FaultName = "fault";
constexpr const char* ArmName = "hb.arm";
constexpr const char* SetpointName = "hb.setpoint";
constexpr const char* WatchdogName = "hb.watchdog_ms";

constexpr int StopTries = 3;
constexpr double StopPeriod_s = 0.010;
constexpr int RestoreTries = 3;
constexpr double StatePatience_s = 0.5;
constexpr double StatePoll_s = 0.002;
constexpr double IdleStatusPeriod_s = 0.25;

std::string wordOf(const A2lMeasurement& signal, double value) {
    const auto found = signal.conversion.words.find(static_cast<std::int64_t>(value));
    return found == signal.conversion.words.end() ? std::string() : found->second;
}

Error unknownRelease(const Error& unanswered, const std::string& state) {
    return {ErrorCode::Protocol, fmt::format("{}; {}", unanswered.message, state),
            "remove the cause, then release the stop again"};
}

} // namespace

SafetySession::SafetySession(XcpMaster& master, XcpLink& link, const BoardDescription& board,
                             ParameterWriter& writer, Options options)
    : m_master(&master), m_link(&link), m_board(&board), m_reader(master, board), m_writer(&writer),
      m_options(std::move(options)) {}

void SafetySession::leave() {
    if (m_expectsArmed && !m_link->lost()) {
        (void)disarm();
    }
    if (m_formerWatchdog_ms && (!refreshState() || !m_state.isArmed)) {
        (void)restoreWatchdog(); // of a board that was stopped, or never armed
    }
}

Result<void> SafetySession::refreshState() {
    m_isStateStale = false;
    std::vector<const A2lObject*> objects;
    const A2lMeasurement* status = m_board->measurement(StatusName);
    const A2lMeasurement* fault = m_board->measurement(FaultName);
    if (status == nullptr) {
        return {}; // a foreign board: nothing is known of its state
    }
    objects.push_back(status);
    if (fault != nullptr) {
        objects.push_back(fault);
    }
    const Result<std::vector<double>> values = m_reader.readObjects(objects);
    if (!values) {
        return failure(values.error());
    }
    const std::string word = wordOf(*status, (*values)[0]);
    m_state.isArmed = word == "armed";
    m_state.isStopLatched = word.starts_with("stopped");
    m_state.fault = 0;
    m_state.faultText.clear();
    if (fault != nullptr && (*values)[1] > 0.0) {
        m_state.fault = static_cast<std::uint32_t>((*values)[1]);
        m_state.faultText = wordOf(*fault, (*values)[1]);
    } else if (m_state.isStopLatched) {
        m_state.faultText = word;
    }
    return {};
}

Error SafetySession::safetyError() const {
    const std::string cause = m_state.faultText.empty() ? "the board stopped" : m_state.faultText;
    return {ErrorCode::SafetyStop, fmt::format("the board stopped the actuator: {}", cause),
            "find the cause, then clear the stop before arming again"};
}

Result<void> SafetySession::writeLive(const std::string& name, double value) {
    if (m_board->catalogue().findParameter(name) == nullptr) {
        return failure(ErrorCode::DeviceRefused,
                       fmt::format("this device has no '{}' and cannot be armed by this program", name),
                       "use the manufacturer's program to arm it");
    }
    const ParameterValue change{name, value};
    return m_writer->write({&change, 1});
}

/// Ours while the board is armed; what it had before is kept for restoreWatchdog().
Result<void> SafetySession::setWatchdog() {
    const std::string name = WatchdogName;
    if (!m_formerWatchdog_ms && m_board->catalogue().findParameter(name) != nullptr) {
        const Result<std::vector<double>> former = m_reader.readParameters({&name, 1});
        if (!former) {
            return failure(former.error());
        }
        m_formerWatchdog_ms = former->front();
    }
    return writeLive(name, m_options.watchdog_s * 1000.0);
}

/// The next master of a board that is not armed may say nothing for longer than we do. A value that was
/// changed meanwhile is somebody's wish and stays. What could not be restored is tried again when the device
/// is left.
Result<void> SafetySession::restoreWatchdog() {
    if (!m_formerWatchdog_ms || m_link->lost()) {
        return {};
    }
    Result<void> restored = writeFormerWatchdog();
    for (int attempt = 1; attempt < RestoreTries && !restored && !m_link->lost(); ++attempt) {
        restored = writeFormerWatchdog();
    }
    if (restored) {
        m_formerWatchdog_ms.reset();
    } else {
        m_options.onMessage(fmt::format(
            "parameter {} of the device may still be {} instead of {} ms, as before arming: {}", WatchdogName,
            1000.0 * m_options.watchdog_s, *m_formerWatchdog_ms, restored.error().message));
    }
    return restored;
}

Result<void> SafetySession::writeFormerWatchdog() {
    const std::string name = WatchdogName;
    const Result<std::vector<double>> now = m_reader.readParameters({&name, 1});
    if (!now) {
        return failure(now.error());
    }
    return now->front() == m_options.watchdog_s * 1000.0 ? writeLive(name, *m_formerWatchdog_ms)
                                                         : Result<void>();
}

/// One set-point, or that of each axis: hb.setpoint.x and so on.
Result<void> SafetySession::zeroSetpoints() {
    std::vector<ParameterValue> zero;
    for (const ParameterSpec& spec : m_board->catalogue().parameters) {
        if (spec.name == SetpointName || spec.name.starts_with(std::string(SetpointName) + ".")) {
            zero.push_back({spec.name, 0.0});
        }
    }
    return zero.empty() ? writeLive(SetpointName, 0.0) : m_writer->write(zero);
}

Result<void> SafetySession::arm() {
    if (Result<void> admitted = m_writer->checkFirmware(); !admitted) {
        return admitted;
    }
    if (Result<void> known = refreshState(); !known) {
        return known;
    }
    if (m_state.isStopLatched || m_state.fault != 0) {
        return failure(ErrorCode::DeviceRefused,
                       fmt::format("the board cannot be armed: {}", m_state.faultText),
                       "remove the cause, then release the stop");
    }
    if (Result<void> set = setWatchdog(); !set) {
        return set;
    }
    if (Result<void> zero = zeroSetpoints(); !zero) {
        return zero;
    }
    m_nextStatus_s = now_s() + m_options.watchdog_s / 4.0;
    m_link->limitAnswerTimeout(std::max(m_options.watchdog_s / 10.0, 4.0 * m_link->roundTripMedian_s()));
    if (Result<void> armed = writeLive(ArmName, 1.0); !armed) {
        m_link->limitAnswerTimeout(std::nullopt);
        return armed;
    }
    m_expectsArmed = true;
    return awaitArmed(true);
}

Result<void> SafetySession::disarm() {
    m_expectsArmed = false;
    m_link->limitAnswerTimeout(std::nullopt);
    if (Result<void> written = writeLive(ArmName, 0.0); !written) {
        return written;
    }
    if (Result<void> done = awaitArmed(false); !done) {
        return done;
    }
    return restoreWatchdog();
}

/// The board takes an order at its next cycle.
Result<void> SafetySession::awaitArmed(bool isArmed) {
    const double end_s = now_s() + StatePatience_s;
    for (;;) {
        if (Result<void> known = refreshState(); !known) {
            return known;
        }
        if (m_state.isArmed == isArmed) {
            return {};
        }
        if (isArmed && (m_state.isStopLatched || m_state.fault != 0)) {
            m_expectsArmed = false;
            return failure(safetyError());
        }
        if (now_s() >= end_s) {
            m_expectsArmed = false;
            return failure(ErrorCode::DeviceRefused,
                           fmt::format("the device does not {}", isArmed ? "arm" : "disarm"),
                           "use the stop switch at the actuator and check the device");
        }
        if (Result<void> pumped = m_link->pumpUntil(now_s() + StatePoll_s); !pumped) {
            return pumped;
        }
    }
}

void SafetySession::stop() noexcept {
    for (int attempt = 0; attempt < StopTries && !m_link->lost(); ++attempt) {
        const double next_s = now_s() + StopPeriod_s;
        if (!m_link->sendStop()) {
            break;
        }
        const Result<bool> answered = m_link->pumpUntilAnswer(StopPeriod_s);
        if (!answered || !m_link->pumpUntil(next_s)) {
            break;
        }
        // Without an answer the next try is due; what the board says of itself can wait.
        const bool isLast = attempt + 1 == StopTries;
        if ((*answered || isLast) && refreshState() && m_state.isStopLatched) {
            break;
        }
    }
    if (m_board->measurement(StatusName) == nullptr) {
        m_options.onMessage(
            "this device does not report whether it stopped: use the stop switch at the actuator");
    }
}

/// Whoever releases has seen what latched; what latches afterwards is for him to see first. The board says
/// what became of a release whose answer was lost: released, or still stopped, from before or anew.
Result<void> SafetySession::clearStop() {
    if (Result<void> admitted = m_writer->checkFirmware(); !admitted) {
        return admitted;
    }
    m_expectsArmed = false;
    const Result<std::optional<Error>> unanswered = m_master->releaseStop();
    if (!unanswered) {
        return failure(unanswered.error());
    }
    if (*unanswered && m_board->measurement(StatusName) == nullptr) {
        return failure(unknownRelease(**unanswered, "release state unknown"));
    }
    const double end_s = now_s() + StatePatience_s;
    for (;;) {
        if (Result<void> known = refreshState(); !known) {
            return known;
        }
        if (!m_state.isStopLatched && m_state.fault == 0) {
            return {};
        }
        if (now_s() >= end_s) {
            return *unanswered
                       ? failure(unknownRelease(**unanswered, "still stopped: " + m_state.faultText))
                       : failure(ErrorCode::DeviceRefused,
                                 fmt::format("the device does not release its stop: {}", m_state.faultText),
                                 "remove the cause first");
        }
        if (Result<void> pumped = m_link->pumpUntil(now_s() + StatePoll_s); !pumped) {
            return pumped;
        }
    }
}

/// Any command restarts the board's watchdog (3.11); reading the state tells at the same time of faults.
Result<void> SafetySession::feedWatchdog() {
    const Result<StatusResponse> status = m_master->status();
    if (!status) {
        return failure(status.error());
    }
    m_nextStatus_s = now_s() + std::min(m_options.watchdog_s / 4.0, IdleStatusPeriod_s);
    return refreshState();
}

Result<void> SafetySession::checkStop() const {
    const bool hasLatched = m_state.isStopLatched || m_state.fault != 0;
    return m_expectsArmed && !m_state.isArmed && hasLatched ? failure(safetyError()) : Result<void>();
}

} // namespace halbench::devices::xcp
