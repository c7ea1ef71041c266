#pragma once

#include "devices/device.h"

#include <optional>
#include <string>
#include <vector>

namespace halbench::devices {

/// An interval a signal has to stay in while something moves.
struct GuardLimit {
    std::string signal;
    double min = 0.0;
    double max = 0.0;
    bool isFromStart = false; ///< counts from the first value that is seen
};

/// Watches a stream on the connection side, before recorder and display: at the first value outside its
/// interval, or that is no number, it stops the device and only then remembers why. The board's own limits
/// stay; this is the host's, e.g. a predicted excursion. Thread: the one that waits on the clock.
class Guard {
public:
    Guard(Device& device, std::vector<GuardLimit> limits) : m_device(&device), m_limits(std::move(limits)) {}

    /// A sink for startStream() that guards and passes every block on. The guard must outlive the stream.
    BlockSink watching(BlockSink next);

    /// Why it stopped the device: SafetyStop with signal, value, interval and time.
    const std::optional<Error>& tripped() const { return m_error; }

private:
    void check(const SampleBlock& block);
    void checkValue(GuardLimit& limit, double value, const StreamLayout::Column& column, double time_s);

    Device* m_device;
    std::vector<GuardLimit> m_limits;
    std::optional<Error> m_error;
};

} // namespace halbench::devices
