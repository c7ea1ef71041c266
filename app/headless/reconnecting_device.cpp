#include "app/headless/reconnecting_device.h"

#include "devices/open/remembered_port.h"
#include "devices/transport/hotplug.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

namespace halbench::app {

namespace {

/// Something that is plugged in ends a wait early.
devices::HostTime hostTime() {
    using HostClock = std::chrono::steady_clock;
    return {[] { return std::chrono::duration<double>(HostClock::now().time_since_epoch()).count(); },
            [hotplug = std::make_shared<devices::Hotplug>()](double duration_s) {
                hotplug->waitFor(duration_s);
            }};
}

} // namespace

std::unique_ptr<devices::ReturningDevice> reconnectingDevice(CommandContext& context, const std::string& uri,
                                                             std::unique_ptr<devices::Device> device) {
    const devices::RememberedPort port = devices::rememberPort(uri, devices::listDevices());
    const auto open = [port,
                       options = openOptionsFor(context)]() -> Result<std::unique_ptr<devices::Device>> {
        const Result<std::string> now = devices::addressNow(port, devices::listDevices());
        return now ? devices::openDevice(*now, options) : failure(now.error());
    };
    devices::DeviceReturn back(device->info(), open);
    return std::make_unique<devices::ReturningDevice>(std::move(device), std::move(back), hostTime());
}

devices::ReturningDevice::Events eventsTo(WarningSink warn, RecordingOutput& output) {
    devices::ReturningDevice::Events events;
    events.onLost = [warn, &output](const Error& why, double stream_s) {
        output.addMarker(stream_s, "connection lost");
        warn(why.message + "; waiting for the device");
    };
    events.onReturned = [warn = std::move(warn), &output](double outage_s, double stream_s) {
        output.addMarker(stream_s, "connection back");
        warn(fmt::format("reconnected after {:.3g} s, recording continues", outage_s));
    };
    return events;
}

} // namespace halbench::app
