// The whole chain in virtual time: motor, sensing, board, XCP over loopback, streaming into memory.
#include "devices/open/open_device.h"
#include "tests/bench/goal.h"

#include <cmath>

namespace halbench::bench {
namespace {

constexpr double Duration_s = 30.0;

/// Position control of a 1 Hz sine with every default signal streamed at 100 Hz.
Result<std::size_t> runChain() {
    auto device = devices::openDevice("sim:htm", {});
    if (!device) {
        return failure(device.error());
    }
    devices::Device& motor = **device;
    std::size_t rows = 0;
    if (const auto armed = motor.arm(); !armed) {
        return failure(armed.error());
    }
    const std::vector<ParameterValue> drive = {{"hb.mode", 2.0},
                                               {"reference.shape", 3.0},
                                               {"reference.amplitude", 0.8},
                                               {"reference.frequency", 1.0},
                                               {"reference.start", 1.0}};
    if (const auto written = motor.writeParameters(drive); !written) {
        return failure(written.error());
    }
    const devices::StreamRequest request{motor.catalogue().defaultSignals, 100.0};
    if (const auto started =
            motor.startStream(request, [&rows](SampleBlockPtr block) { rows += block->rows(); });
        !started) {
        return failure(started.error());
    }
    const auto waited = motor.clock().waitFor(Duration_s);
    motor.stopStream();
    if (!waited) {
        return failure(waited.error());
    }
    if (const auto disarmed = motor.disarm(); !disarmed) {
        return failure(disarmed.error());
    }
    return rows;
}

void benchChain(Goals& goals) {
    const std::string name = "whole chain through the loopback";
    const auto rows = runChain();
    if (!rows) {
        return goals.failed(name, rows.error().message);
    }
    if (std::abs(static_cast<double>(*rows) - 100.0 * Duration_s) > 2.0) {
        return goals.failed(name, "rows were lost");
    }
    const double time_s = processorTime_s([] { (void)runChain(); }, 5);
    goals.atLeast(name, Duration_s / time_s, 200.0, "x real time on one core");
}

} // namespace
} // namespace halbench::bench

int main() {
    halbench::bench::Goals goals;
    halbench::bench::benchChain(goals);
    return goals.exitCode();
}
