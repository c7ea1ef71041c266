#pragma once

#include "devices/open/device_return.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace halbench::devices {

/// The host's time, for who waits while there is no device.
struct HostTime {
    std::function<double()> now_s;
    std::function<void(double duration_s)> sleep;
};

/// A device whose stream goes on after its link was lost and found again, for who only listens. While it is
/// away its clock goes on by the host's, and everything else answers DeviceLost. The rows after the return
/// lie on the grid of those before; how many are missing is said before the first of them. It comes back
/// disarmed. Thread: one, that of its calls.
class ReturningDevice final : public Device {
public:
    struct Events {                                                    ///< each may be empty
        std::function<void(const Error& why, double stream_s)> onLost; ///< seconds of the stream
        std::function<void(double outage_s, double stream_s)> onReturned;
    };

    ReturningDevice(std::unique_ptr<Device> device, DeviceReturn back, HostTime time);
    void setEvents(Events events) { m_events = std::move(events); }
    /// Off: a loss ends the wait like any other error, for what must not go on after one.
    void setWaiting(bool isWaiting) { m_isWaiting = isWaiting; }

    /// Why it is away.
    const std::optional<Error>& lost() const { return m_lost; }

    const DeviceInfo& info() const override { return m_info; }
    const Catalogue& catalogue() const override { return m_catalogue; }
    Clock& clock() override { return m_clock; }
    DeviceState state() const override { return m_device->state(); }
    LinkStatistics statistics() const override;
    Result<std::vector<double>> readParameters(std::span<const std::string> names) override;
    Result<std::vector<double>> readSignals(std::span<const std::string> names) override;
    Result<void> writeParameters(std::span<const ParameterValue> values) override;
    Result<void> saveParameters() override;
    Result<void> startStream(const StreamRequest& request, BlockSink sink) override;
    void stopStream() noexcept override;
    Result<void> arm() override { return m_device->arm(); }
    Result<void> disarm() override { return m_device->disarm(); }
    void stop() noexcept override { m_device->stop(); }
    Result<void> clearStop() override { return m_device->clearStop(); }
    Result<Recording> readCapture() override { return m_device->readCapture(); }

private:
    class GoingClock final : public Clock {
    public:
        explicit GoingClock(ReturningDevice& device) : m_device(&device) {}
        double now_s() const override { return m_device->now_s(); }
        Result<void> waitFor(double duration_s) override { return m_device->waitFor(duration_s); }

    private:
        ReturningDevice* m_device;
    };

    double now_s() const;
    Result<void> waitFor(double duration_s);
    Result<void> lose(const Error& error);
    Result<void> look(double longest_s);
    Result<void> takeBack(std::unique_ptr<Device> device);
    BlockSink onGrid(double shift_s);

    std::unique_ptr<Device> m_device; ///< a DisconnectedDevice while it is away
    DeviceInfo m_info;
    Catalogue m_catalogue;
    DeviceReturn m_return;
    HostTime m_time;
    Events m_events;
    GoingClock m_clock;
    bool m_isWaiting = true;
    std::optional<Error> m_lost;
    double m_start_s = 0.0;    ///< of the device's clock since the first was opened
    double m_lostHost_s = 0.0; ///< when it was lost
    LinkStatistics m_earlier;  ///< of the links before this one

    StreamRequest m_request; ///< no signals: nothing streams
    BlockSink m_sink;
    double m_streamStart_s = 0.0;
    double m_lastRow_s = 0.0;
};

} // namespace halbench::devices
