#pragma once

#include "devices/xcp/board_capture.h"
#include "devices/xcp/board_description.h"
#include "devices/xcp/clock_comparison.h"
#include "devices/xcp/daq_stream.h"
#include "devices/xcp/parameter_writer.h"
#include "devices/xcp/safety_session.h"
#include "devices/xcp/value_reader.h"
#include "devices/xcp/xcp_device.h"
#include "devices/xcp/xcp_master.h"

#include <cstdint>
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

    Result<std::vector<double>> readParameters(std::span<const std::string> names) override {
        return m_values.readParameters(names);
    }
    Result<std::vector<double>> readSignals(std::span<const std::string> names) override {
        return m_values.readSignals(names);
    }
    Result<void> writeParameters(std::span<const ParameterValue> values) override {
        return m_writer.write(values);
    }
    Result<void> saveParameters() override { return m_writer.save(); }
    Result<void> startStream(const StreamRequest& request, BlockSink sink) override;
    void stopStream() noexcept override;
    Result<void> arm() override { return m_safety.arm(); }
    Result<void> disarm() override { return m_safety.disarm(); }
    void stop() noexcept override { m_safety.stop(); }
    Result<void> clearStop() override { return m_safety.clearStop(); }
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

    double now_s() const { return m_link.transport().now_s(); }
    void installHandlers();
    void onEvent(std::uint8_t code);
    Result<void> waitFor(double duration_s);
    Result<void> checkWhileWaiting();
    void reportLink() const;

    XcpDeviceOptions m_options;
    XcpLink m_link;
    XcpMaster m_master;
    DeviceClock m_clock;
    double m_opened_s = 0.0;
    bool m_isOpen = false;
    BoardDescription m_board;
    std::optional<DaqAbility> m_ability;
    ValueReader m_values;
    ParameterWriter m_writer;
    SafetySession m_safety;
    DaqStream m_stream;
    ClockComparison m_clocks;
    BoardCapture m_capture;
};

} // namespace halbench::devices::xcp
