#pragma once

#include "app/session/connection.h"
#include "devices/device.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>

namespace halbench::app {

/// The device of a connection as a procedure's own: every call is carried out by the connection thread, which
/// goes on serving link, watchdog and stop while the procedure computes. Blocks reach the sink on the
/// procedure's thread, inside clock().waitFor(). Thread: the procedure's. The connection must outlive it.
class SharedDevice final : public devices::Device {
public:
    /// `returns`: of the connection, so far; a procedure does not go on with a device that came back later.
    SharedDevice(Connection& connection, std::uint64_t returns, devices::DeviceInfo info,
                 devices::Catalogue catalogue);

    const devices::DeviceInfo& info() const override { return m_info; }
    const devices::Catalogue& catalogue() const override { return m_catalogue; }
    devices::Clock& clock() override { return m_clock; }
    devices::DeviceState state() const override;
    devices::LinkStatistics statistics() const override;

    Result<std::vector<double>> readParameters(std::span<const std::string> names) override;
    Result<std::vector<double>> readSignals(std::span<const std::string> names) override;
    Result<void> writeParameters(std::span<const ParameterValue> values) override;
    Result<void> saveParameters() override;
    Result<void> startStream(const devices::StreamRequest& request, devices::BlockSink sink) override;
    /// Hands over what came since the last wait before it returns.
    void stopStream() noexcept override;
    Result<void> arm() override;
    Result<void> disarm() override;
    void stop() noexcept override;
    Result<void> clearStop() override;
    Result<Recording> readCapture() override;

private:
    class SharedClock final : public devices::Clock {
    public:
        explicit SharedClock(SharedDevice& device) : m_device(&device) {}
        double now_s() const override;
        Result<void> waitFor(double duration_s) override { return m_device->waitFor(duration_s); }

    private:
        SharedDevice* m_device;
    };

    template <typename Function>
    auto call(Function function) const;
    Result<void> waitFor(double duration_s);

    bool takeBlock();

    Connection* m_connection;
    std::uint64_t m_returns;
    devices::DeviceInfo m_info;
    devices::Catalogue m_catalogue;
    SharedClock m_clock;
    devices::BlockSink m_sink;

    std::mutex m_mutex; ///< guards what the connection thread hands over
    std::condition_variable m_arrived;
    std::deque<SampleBlockPtr> m_blocks;
    std::optional<Result<void>> m_waited;
};

} // namespace halbench::app
