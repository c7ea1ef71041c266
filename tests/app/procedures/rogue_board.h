#pragma once

#include "devices/device.h"

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace halbench::app {

/// A board that does not do what it is told: `alter` changes what is written before it arrives, an empty
/// result swallows it. Everything else goes through.
class RogueBoard : public devices::Device {
public:
    using Alter = std::function<std::vector<ParameterValue>(std::vector<ParameterValue>)>;
    RogueBoard(std::unique_ptr<devices::Device> device, Alter alter)
        : m_device(std::move(device)), m_alter(std::move(alter)) {}

    const devices::DeviceInfo& info() const override { return m_device->info(); }
    const devices::Catalogue& catalogue() const override { return m_device->catalogue(); }
    devices::Clock& clock() override { return m_device->clock(); }
    devices::DeviceState state() const override { return m_device->state(); }
    devices::LinkStatistics statistics() const override { return m_device->statistics(); }
    Result<std::vector<double>> readParameters(std::span<const std::string> names) override {
        return m_device->readParameters(names);
    }
    Result<std::vector<double>> readSignals(std::span<const std::string> names) override {
        return m_device->readSignals(names);
    }
    Result<void> writeParameters(std::span<const ParameterValue> values) override {
        const auto altered = m_alter({values.begin(), values.end()});
        return altered.empty() ? Result<void>() : m_device->writeParameters(altered);
    }
    Result<void> saveParameters() override { return m_device->saveParameters(); }
    Result<void> startStream(const devices::StreamRequest& request, devices::BlockSink sink) override {
        return m_device->startStream(request, std::move(sink));
    }
    void stopStream() noexcept override { m_device->stopStream(); }
    Result<void> arm() override { return m_device->arm(); }
    Result<void> disarm() override { return m_device->disarm(); }
    void stop() noexcept override {
        ++m_stops;
        m_device->stop();
    }
    Result<void> clearStop() override { return m_device->clearStop(); }
    Result<Recording> readCapture() override { return m_device->readCapture(); }

    int stops() const { return m_stops; }

private:
    std::unique_ptr<devices::Device> m_device;
    Alter m_alter;
    int m_stops = 0;
};

} // namespace halbench::app
