#pragma once

#include "devices/device.h"

namespace halbench::devices {

/// What is left of a device whose link is gone: who it was, and the same error for whatever is asked of it.
/// Its clock stands still. Thread: that of its calls.
class DisconnectedDevice final : public Device {
public:
    DisconnectedDevice(const Device& former, double now_s, Error lost);

    const DeviceInfo& info() const override { return m_info; }
    const Catalogue& catalogue() const override { return m_catalogue; }
    Clock& clock() override { return m_clock; }
    DeviceState state() const override { return m_state; }
    LinkStatistics statistics() const override { return m_statistics; }
    const Error& lost() const { return m_lost; }

    Result<std::vector<double>> readParameters(std::span<const std::string>) override { return gone(); }
    Result<std::vector<double>> readSignals(std::span<const std::string>) override { return gone(); }
    Result<void> writeParameters(std::span<const ParameterValue>) override { return gone(); }
    Result<void> saveParameters() override { return gone(); }
    Result<void> startStream(const StreamRequest&, BlockSink) override { return gone(); }
    void stopStream() noexcept override {}
    Result<void> arm() override { return gone(); }
    Result<void> disarm() override { return gone(); }
    void stop() noexcept override {}
    Result<void> clearStop() override { return gone(); }
    Result<Recording> readCapture() override { return gone(); }

private:
    class StoppedClock final : public Clock {
    public:
        StoppedClock(const DisconnectedDevice& device, double now_s) : m_device(&device), m_now_s(now_s) {}
        double now_s() const override { return m_now_s; }
        Result<void> waitFor(double) override { return m_device->gone(); }

    private:
        const DisconnectedDevice* m_device;
        double m_now_s;
    };

    tl::unexpected<Error> gone() const { return failure(m_lost); }

    DeviceInfo m_info;
    Catalogue m_catalogue;
    DeviceState m_state;
    LinkStatistics m_statistics;
    Error m_lost;
    StoppedClock m_clock;
};

} // namespace halbench::devices
