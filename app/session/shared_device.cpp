#include "app/session/shared_device.h"

#include <future>
#include <utility>

namespace halbench::app {

SharedDevice::SharedDevice(Connection& connection, std::uint64_t returns, devices::DeviceInfo info,
                           devices::Catalogue catalogue)
    : m_connection(&connection), m_returns(returns), m_info(std::move(info)),
      m_catalogue(std::move(catalogue)), m_clock(*this) {}

template <typename Function>
auto SharedDevice::call(Function function) const {
    using Answer = decltype(function(std::declval<devices::Device&>()));
    std::promise<Answer> answer;
    std::future<Answer> future = answer.get_future();
    m_connection->post(
        [&](devices::Device& device) {
            if constexpr (std::is_void_v<Answer>) {
                function(device);
                answer.set_value();
            } else {
                answer.set_value(function(device));
            }
        },
        m_returns);
    return future.get();
}

double SharedDevice::SharedClock::now_s() const {
    return m_device->call([](devices::Device& device) { return device.clock().now_s(); });
}

devices::DeviceState SharedDevice::state() const {
    return call([](devices::Device& device) { return device.state(); });
}

devices::LinkStatistics SharedDevice::statistics() const {
    return call([](devices::Device& device) { return device.statistics(); });
}

Result<std::vector<double>> SharedDevice::readParameters(std::span<const std::string> names) {
    return call([names](devices::Device& device) { return device.readParameters(names); });
}

Result<std::vector<double>> SharedDevice::readSignals(std::span<const std::string> names) {
    return call([names](devices::Device& device) { return device.readSignals(names); });
}

Result<void> SharedDevice::writeParameters(std::span<const ParameterValue> values) {
    return call([values](devices::Device& device) { return device.writeParameters(values); });
}

Result<void> SharedDevice::saveParameters() {
    return call([](devices::Device& device) { return device.saveParameters(); });
}

Result<void> SharedDevice::startStream(const devices::StreamRequest& request, devices::BlockSink sink) {
    m_sink = std::move(sink);
    const devices::BlockSink handOver = [this](SampleBlockPtr block) {
        const std::lock_guard lock(m_mutex);
        m_blocks.push_back(std::move(block));
        m_arrived.notify_one();
    };
    return call([&](devices::Device& device) {
        return m_connection->startProcedureStream(device, request, handOver);
    });
}

void SharedDevice::stopStream() noexcept {
    call([this](devices::Device& device) { m_connection->stopProcedureStream(device); });
    while (takeBlock()) { // what came since the last wait: at a high speed of simulated time seconds of it
    }
    m_sink = nullptr;
}

/// Whether there was one.
bool SharedDevice::takeBlock() {
    std::unique_lock lock(m_mutex);
    if (m_blocks.empty()) {
        return false;
    }
    const SampleBlockPtr block = std::move(m_blocks.front());
    m_blocks.pop_front();
    lock.unlock();
    if (m_sink) {
        m_sink(block);
    }
    return true;
}

Result<void> SharedDevice::arm() {
    return call([](devices::Device& device) { return device.arm(); });
}

Result<void> SharedDevice::disarm() {
    return call([](devices::Device& device) { return device.disarm(); });
}

void SharedDevice::stop() noexcept {
    call([](devices::Device& device) { device.stop(); });
}

Result<void> SharedDevice::clearStop() {
    return call([](devices::Device& device) { return device.clearStop(); });
}

Result<Recording> SharedDevice::readCapture() {
    return call([](devices::Device& device) { return device.readCapture(); });
}

Result<void> SharedDevice::waitFor(double duration_s) {
    m_connection->post(
        [this, duration_s](devices::Device& device) {
            m_connection->beginWait(device, duration_s, [this](Result<void> result) {
                const std::lock_guard lock(
                    m_mutex); // held while notifying: afterwards the waiter may be gone
                m_waited = std::move(result);
                m_arrived.notify_one();
            });
        },
        m_returns);
    for (;;) {
        {
            std::unique_lock lock(m_mutex);
            m_arrived.wait(lock, [this] { return m_waited.has_value() || !m_blocks.empty(); });
            if (m_blocks.empty()) {
                return *std::exchange(m_waited, std::nullopt);
            }
        }
        takeBlock();
    }
}

} // namespace halbench::app
