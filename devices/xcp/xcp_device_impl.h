#pragma once

#include "devices/xcp/board_capture.h"
#include "devices/xcp/board_description.h"
#include "devices/xcp/clock_fit.h"
#include "devices/xcp/description_cache.h"
#include "devices/xcp/stream_assembler.h"
#include "devices/xcp/xcp_device.h"
#include "devices/xcp/xcp_master.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace halbench::devices::xcp {

/// A board behind an XCP link as a Device; see xcp_device.h. Thread: the connection's.
class XcpDevice final : public Device {
public:
    XcpDevice(std::unique_ptr<Transport> transport, XcpDeviceOptions options);
    ~XcpDevice() override;
    XcpDevice(const XcpDevice&) = delete;
    XcpDevice& operator=(const XcpDevice&) = delete;

    /// Connects and reads everything the board says of itself.
    Result<void> open();

    const DeviceInfo& info() const override { return m_options.identity; }
    const Catalogue& catalogue() const override { return m_board.catalogue(); }
    Clock& clock() override { return m_clock; }
    DeviceState state() const override;
    LinkStatistics statistics() const override;

    Result<std::vector<double>> readParameters(std::span<const std::string> names) override;
    Result<std::vector<double>> readSignals(std::span<const std::string> names) override;
    Result<void> writeParameters(std::span<const ParameterValue> values) override;
    Result<void> saveParameters() override;
    Result<void> startStream(const StreamRequest& request, BlockSink sink) override;
    void stopStream() noexcept override;
    Result<void> arm() override;
    Result<void> disarm() override;
    void stop() noexcept override;
    Result<void> clearStop() override;
    Result<Recording> readCapture() override;

private:
    class DeviceClock final : public Clock {
    public:
        explicit DeviceClock(XcpDevice& device) : m_device(&device) {}
        double now_s() const override { return m_device->now_s() - m_device->m_opened_s; }
        Result<void> waitFor(double duration_s) override { return m_device->waitFor(duration_s); }

    private:
        XcpDevice* m_device;
    };

    /// A parameter to be written, in octets.
    struct RawChange {
        const A2lCharacteristic* target = nullptr;
        Packet octets;
        std::optional<XcpMaster::Repetition> command; ///< the write is an act
    };

    double now_s() const { return m_link.transport().now_s(); }
    void message(const std::string& text) const;

    // opening (xcp_device.cpp)
    Result<void> readIdentity();
    Result<void> readDescription();
    Result<A2lDescription> givenOrUploaded();
    Result<A2lDescription> cachedOrUploaded();
    Result<void> compareFirmware(const A2lDescription& description);
    Result<void> findFirmware(const A2lDescription& description);
    Result<void> readLongerFirmware(std::uint32_t address);
    Result<void> choosePages();
    Result<void> readDefaults();
    Result<void> readWhatCanBeRead(const std::vector<std::string>& names);
    void useProfile();
    void installHandlers();

    // values (xcp_device_values.cpp)
    Result<std::vector<double>> readObjects(const std::vector<const A2lObject*>& objects);
    Result<std::vector<RawChange>> checkedChanges(std::span<const ParameterValue> values);
    double nextOrder();
    Result<void> writeSegment(const A2lSegment& segment, const std::vector<RawChange>& changes);
    Result<void> writePlain(const std::vector<RawChange>& changes);
    Result<bool> writeAdjacent(const std::vector<RawChange>& changes);
    Result<void> commandOnce(const RawChange& change);
    Result<void> writeOneByOne(const std::vector<RawChange>& changes);
    Result<void> readBack(const std::vector<RawChange>& changes);
    Result<void> checkFirmware() const;

    // streams and time (xcp_device_stream.cpp)
    Result<void> waitFor(double duration_s);
    Result<void> checkWhileWaiting();
    void deliverBlocks();
    Result<void> feedWatchdog();
    Result<void> checkHeartbeat();
    void remarkOnStream(const SamplingPlan& sampling, const DaqPlan& plan) const;
    void feedStream(Octets packet);
    Result<void> compareClocks();
    void reportLink() const;

    // state, arming, stopping (xcp_device_state.cpp)
    Result<void> refreshState();
    Result<void> awaitArmed(bool isArmed);
    Result<void> writeLive(const std::string& name, double value);
    Result<void> setWatchdog();
    Result<void> zeroSetpoints();
    Result<void> restoreWatchdog();
    Result<void> writeFormerWatchdog();
    void onEvent(std::uint8_t code);
    Error safetyError() const;

    XcpDeviceOptions m_options;
    XcpLink m_link;
    XcpMaster m_master;
    DeviceClock m_clock;
    double m_opened_s = 0.0;
    BoardDescription m_board;
    std::optional<DaqAbility> m_ability;

    DeviceState m_state;
    double m_lastOrder = 1.0; ///< number of the last start sent to a board that knows repetitions by it
    bool m_isStateStale = false;
    bool m_expectsArmed = false; ///< armed by us and not disarmed since: losing it is a safety stop
    std::optional<double> m_formerWatchdog_ms; ///< what the board had before it was armed by us
    bool m_hasWarnedOneByOne = false;
    double m_nextStatus_s = 0.0;

    std::unique_ptr<StreamAssembler> m_stream;
    BlockSink m_sink;
    double m_streamStarted_s = 0.0;
    std::optional<TickUnwrapper> m_boardClock; ///< absent: not asked for
    ClockFit m_clockFit;
    double m_nextClock_s = 0.0;
    BoardCapture m_capture;
    std::uint64_t m_droppedSamples = 0;    ///< incomplete or misplaced, of streams that ended
    std::uint64_t m_incompleteSamples = 0; ///< of these
};

} // namespace halbench::devices::xcp
