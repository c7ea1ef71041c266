#pragma once

#include "devices/device.h"
#include "devices/xcp/board_description.h"
#include "devices/xcp/parameter_writer.h"
#include "devices/xcp/value_reader.h"
#include "devices/xcp/xcp_master.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace halbench::devices::xcp {

/// The safe state of a board: what it says of itself, arming with the watchdog, disarming, the emergency stop
/// and its release (resources/help/protocol.md, 3.11). All that it is given outlives it. Thread: the
/// connection's.
class SafetySession {
public:
    struct Options {
        double watchdog_s = 1.0;                           ///< of the board while it is armed
        std::function<void(const std::string&)> onMessage; ///< never empty
    };

    SafetySession(XcpMaster& master, XcpLink& link, const BoardDescription& board, ParameterWriter& writer,
                  Options options);

    /// `isConnected` is the owner's to know: here it is false.
    const DeviceState& state() const { return m_state; }
    Result<void> refreshState();
    /// The board said that its state has changed.
    void noteChange() { m_isStateStale = true; }

    Result<void> arm();
    Result<void> disarm();
    void stop() noexcept;
    Result<void> clearStop();
    /// Disarms a board that we armed and puts its watchdog back.
    void leave();

    bool isStatusDue(double now_s) const { return now_s >= m_nextStatus_s || m_isStateStale; }
    double nextStatus_s() const { return m_nextStatus_s; }
    Result<void> feedWatchdog();
    /// SafetyStop when a board that we armed has stopped.
    Result<void> checkStop() const;

private:
    double now_s() const { return m_link->transport().now_s(); }
    Result<void> awaitArmed(bool isArmed);
    Result<void> writeLive(const std::string& name, double value);
    Result<void> setWatchdog();
    Result<void> zeroSetpoints();
    Result<void> restoreWatchdog();
    Result<void> writeFormerWatchdog();
    Error safetyError() const;

    XcpMaster* m_master;
    XcpLink* m_link;
    const BoardDescription* m_board;
    ValueReader m_reader;
    ParameterWriter* m_writer;
    Options m_options;

    DeviceState m_state;
    bool m_isStateStale = false;
    bool m_expectsArmed = false; ///< armed by us and not disarmed since: losing it is a safety stop
    std::optional<double> m_formerWatchdog_ms; ///< what the board had before it was armed by us
    double m_nextStatus_s = 0.0;
};

} // namespace halbench::devices::xcp
