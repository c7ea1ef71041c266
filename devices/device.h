#pragma once

#include "control/base/parameter_spec.h"
#include "control/base/result.h"
#include "control/base/sample_block.h"
#include "devices/axis_spec.h"
#include "devices/clock.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace halbench::devices {

/// Who the device is. Nothing outside `devices/simulated` branches on `isSimulated`, except banner and
/// consent.
struct DeviceInfo {
    std::string uri;
    std::string model;     ///< "htm"; empty for a board without a profile
    std::string id;        ///< stable identity, e.g. "sim-htm-1" or a serial number
    std::string firmware;  ///< EPK of the board
    std::string transport; ///< "loopback", "tcp", ...
    bool isSimulated = false;
    std::vector<std::pair<std::string, std::string>> overrides; ///< as written in the URI, sorted by key
    std::string otherFirmware = {}; ///< what its description is of, when not of its own: nothing is written
};

/// Everything that can be measured and tuned, from the board's own description plus the profile's roles.
struct Catalogue {
    std::vector<SignalSpec> signals;
    std::vector<ParameterSpec> parameters;
    std::vector<std::string> procedures;          ///< names of the procedures that apply
    std::map<std::string, double> knownConstants; ///< from the profile, e.g. "I_max"
    std::vector<std::string> defaultSignals;      ///< what `record` takes when nothing is said
    std::vector<AxisSpec> axes; ///< from the profile; empty: it senses only, or nothing is known of it

    const SignalSpec* findSignal(const std::string& name) const;
    const ParameterSpec* findParameter(const std::string& name) const;
    const AxisSpec* findAxis(const std::string& id) const;
    /// Name of the signal or parameter that plays a role ("coil_temperature.a"); empty if none does.
    std::string signalForRole(const std::string& role) const;
    std::string parameterForRole(const std::string& role) const;
    bool hasProcedure(const std::string& name) const;
};

enum class BoardMode { Idle = 0, Current = 1, Position = 2, DAxis = 3 };

/// What the board last said of itself.
struct DeviceState {
    bool isConnected = false;
    bool isArmed = false;
    bool isStopLatched = false;
    std::uint32_t fault = 0; ///< 0 = none; code of the board's fault table
    std::string faultText;   ///< in words, e.g. "coil temperature above its limit"
};

/// How fast a board's clock runs against the host's.
struct ClockDrift {
    double drift_ppm = 0.0;       ///< positive: the board's clock gains
    double uncertainty_ppm = 0.0; ///< half of the 95 % interval
};

struct LinkStatistics {
    std::uint64_t packetsReceived = 0;
    std::uint64_t packetsSent = 0;
    std::uint64_t packetsLost = 0; ///< counter gaps
    std::uint64_t packetsLate = 0; ///< of those, what came behind a later one and was dropped
    std::uint64_t packetsDamaged = 0;
    std::uint64_t commandsRepeated = 0;
    std::uint64_t returns = 0; ///< how often the device was lost and came back; the counts go on over it
    double roundTripMedian_s = 0.0;
    double roundTripWorst_s = 0.0;
    std::optional<ClockDrift> clockDrift; ///< absent on a simulation's own clock and before some seconds
};

struct StreamRequest {
    std::vector<std::string> signals;
    double rate_Hz = 100.0; ///< must divide the event rate of every signal
};

/// Called on the thread that waits on the clock; must not call the device.
using BlockSink = std::function<void(SampleBlockPtr)>;

/// One open device, simulated or real: what procedures, batch and windows use.
/// All calls are made from one thread. A call never throws; a lost link shows as DeviceLost.
class Device {
public:
    virtual ~Device() = default;

    virtual const DeviceInfo& info() const = 0;
    virtual const Catalogue& catalogue() const = 0;
    virtual Clock& clock() = 0;
    virtual DeviceState state() const = 0;
    virtual LinkStatistics statistics() const = 0;

    /// Values on the device, in the order of the names.
    virtual Result<std::vector<double>> readParameters(std::span<const std::string> names) = 0;
    virtual Result<std::vector<double>> readSignals(std::span<const std::string> names) = 0;

    /// Writes a set of parameters and reads it back. Transactional parameters are written to the inactive
    /// calibration page, verified by checksum and switched together, so that all change in one control cycle;
    /// the others are written one by one after them in the given order. Every value is checked against its
    /// specification before the first byte is sent; nothing is written when one is refused.
    virtual Result<void> writeParameters(std::span<const ParameterValue> values) = 0;

    /// Stores the active values in the board's non-volatile memory; a separate act from writing them.
    virtual Result<void> saveParameters() = 0;

    /// At most one stream runs. The sink gets blocks while clock().waitFor() or stopStream() runs.
    virtual Result<void> startStream(const StreamRequest& request, BlockSink sink) = 0;
    /// After it returns, the sink is not called again.
    virtual void stopStream() noexcept = 0;

    /// Sets the watchdog, arms; set-points start at zero. `disarm` puts every output and set-point to zero.
    virtual Result<void> arm() = 0;
    virtual Result<void> disarm() = 0;

    /// Emergency stop: sent at once, whatever else is going on, latched until clearStop().
    virtual void stop() noexcept = 0;
    virtual Result<void> clearStop() = 0;

    /// The board's own capture at loop rate (up to 4 signals x 4096 samples), as a recording; empty until it
    /// is full and read. A call reads a piece of it, so that the link stays free: call again once it is full.
    virtual Result<Recording> readCapture() = 0;
};

} // namespace halbench::devices
