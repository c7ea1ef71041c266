#include "devices/open/returning_device.h"

#include "devices/open/disconnected_device.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::devices {

namespace {

constexpr double Rounding_s = 1e-9;
constexpr double LookPeriod_s = 0.02;
/// A row that is less than this share of a period off its place lies on it.
constexpr double GridRounding = 1e-6;

/// 3.45 and not 3.4499999999999997 s, where the board's rows lie on the grid at all.
double snapped(double time_s, double rate_Hz) {
    const double place = std::round(time_s * rate_Hz);
    return std::abs(time_s * rate_Hz - place) < GridRounding ? place / rate_Hz : time_s;
}

/// What was counted by several links one after the other; times are those of the last.
LinkStatistics withEarlier(LinkStatistics now, const LinkStatistics& earlier) {
    now.packetsReceived += earlier.packetsReceived;
    now.packetsSent += earlier.packetsSent;
    now.packetsLost += earlier.packetsLost;
    now.packetsLate += earlier.packetsLate;
    now.packetsDamaged += earlier.packetsDamaged;
    now.commandsRepeated += earlier.commandsRepeated;
    now.returns += earlier.returns;
    return now;
}

} // namespace

ReturningDevice::ReturningDevice(std::unique_ptr<Device> device, DeviceReturn back, HostTime time)
    : m_device(std::move(device)), m_info(m_device->info()), m_catalogue(m_device->catalogue()),
      m_return(std::move(back)), m_time(std::move(time)), m_clock(*this) {}

LinkStatistics ReturningDevice::statistics() const {
    return withEarlier(m_device->statistics(), m_earlier);
}

Result<std::vector<double>> ReturningDevice::readParameters(std::span<const std::string> names) {
    return m_device->readParameters(names);
}

Result<std::vector<double>> ReturningDevice::readSignals(std::span<const std::string> names) {
    return m_device->readSignals(names);
}

Result<void> ReturningDevice::writeParameters(std::span<const ParameterValue> values) {
    return m_device->writeParameters(values);
}

Result<void> ReturningDevice::saveParameters() {
    return m_device->saveParameters();
}

double ReturningDevice::now_s() const {
    const double away_s = m_lost ? m_time.now_s() - m_lostHost_s : 0.0;
    return m_start_s + m_device->clock().now_s() + away_s;
}

Result<void> ReturningDevice::startStream(const StreamRequest& request, BlockSink sink) {
    m_request = request;
    m_sink = std::move(sink);
    m_streamStart_s = now_s();
    m_lastRow_s = -1.0 / request.rate_Hz;
    return m_device->startStream(request, onGrid(0.0));
}

void ReturningDevice::stopStream() noexcept {
    m_device->stopStream();
    m_request.signals.clear();
    m_sink = nullptr;
}

BlockSink ReturningDevice::onGrid(double shift_s) {
    return [this, shift_s](const SampleBlockPtr& block) {
        auto moved = std::make_shared<SampleBlock>(*block);
        for (double& time_s : moved->time_s) {
            time_s = snapped(time_s + shift_s, m_request.rate_Hz);
        }
        const bool isFirst = shift_s > 0.0 && m_lastRow_s < shift_s - Rounding_s;
        if (isFirst && moved->rows() > 0) {
            const double steps = (moved->time_s.front() - m_lastRow_s) * m_request.rate_Hz;
            moved->lostRows = static_cast<std::uint64_t>(std::max(0.0, std::round(steps) - 1.0));
        }
        m_lastRow_s = moved->rows() > 0 ? moved->time_s.back() : m_lastRow_s;
        m_sink(std::move(moved));
    };
}

Result<void> ReturningDevice::waitFor(double duration_s) {
    const double end_s = now_s() + std::max(duration_s, 0.0);
    do {
        const double left_s = std::max(0.0, end_s - now_s());
        const Result<void> passed = m_lost ? look(left_s) : m_device->clock().waitFor(left_s);
        const bool isNewlyLost =
            !passed && !m_lost && m_isWaiting && passed.error().code == ErrorCode::DeviceLost;
        const Result<void> goOn = isNewlyLost ? lose(passed.error()) : passed;
        if (!goOn) {
            return goOn;
        }
    } while (now_s() < end_s - Rounding_s);
    return {};
}

/// The port is closed at once, so that it is free to be opened again.
Result<void> ReturningDevice::lose(const Error& error) {
    m_device = std::make_unique<DisconnectedDevice>(*m_device, m_device->clock().now_s(), error);
    m_lostHost_s = m_time.now_s();
    m_lost = error;
    const Result<void> goOn = m_return.noteLost(m_lostHost_s);
    if (goOn && m_events.onLost) {
        m_events.onLost(error, now_s() - m_streamStart_s);
    }
    return goOn;
}

Result<void> ReturningDevice::look(double longest_s) {
    Result<std::unique_ptr<Device>> found = m_return.look(m_time.now_s());
    if (!found) {
        return failure(found.error());
    }
    if (*found) {
        return takeBack(*std::move(found));
    }
    m_time.sleep(std::min(longest_s, LookPeriod_s));
    return {};
}

Result<void> ReturningDevice::takeBack(std::unique_ptr<Device> device) {
    if (device->state().isArmed && !device->disarm()) {
        device->stop();
    }
    const double outage_s = m_time.now_s() - m_lostHost_s;
    m_start_s = now_s() - device->clock().now_s();
    m_earlier = statistics();
    ++m_earlier.returns;
    m_device = std::move(device);
    m_lost.reset();
    const double stream_s = now_s() - m_streamStart_s;
    if (m_events.onReturned) {
        m_events.onReturned(outage_s, stream_s);
    }
    if (m_request.signals.empty()) {
        return {};
    }
    const double shift_s = std::ceil(stream_s * m_request.rate_Hz - GridRounding) / m_request.rate_Hz;
    const Result<void> started = m_device->startStream(m_request, onGrid(shift_s));
    const bool isLostAgain = !started && started.error().code == ErrorCode::DeviceLost;
    return isLostAgain ? lose(started.error()) : started;
}

} // namespace halbench::devices
