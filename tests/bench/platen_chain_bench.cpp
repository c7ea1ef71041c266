// The whole chain of the platen in virtual time with all imperfections: plant, chips, board, XCP over
// loopback. Identification against the same chain without a fit, in the same run.
#include "app/actuators/actuator.h"
#include "devices/open/open_device.h"
#include "tests/bench/goal.h"

#include <cmath>
#include <memory>
#include <variant>

namespace halbench::bench {
namespace {

constexpr double Rate_Hz = 1000.0;

/// Position control of a 1 Hz sine with all default signals streamed at the rate of the loop.
Result<std::size_t> runChain(double duration_s) {
    auto device = devices::openDevice("sim:planar", {});
    if (!device) {
        return failure(device.error());
    }
    devices::Device& platen = **device;
    std::size_t rows = 0;
    const std::vector<ParameterValue> drive = {{"hb.home", 1.0},
                                               {"hb.mode", 2.0},
                                               {"reference.x.shape", 3.0},
                                               {"reference.x.amplitude", 5e-3},
                                               {"reference.x.frequency", 1.0},
                                               {"reference.x.duration", duration_s}};
    if (const auto written = platen.writeParameters(drive); !written) {
        return failure(written.error());
    }
    if (const auto armed = platen.arm(); !armed) {
        return failure(armed.error());
    }
    const ParameterValue start[] = {{"reference.start", 1.0}};
    if (const auto written = platen.writeParameters(start); !written) {
        return failure(written.error());
    }
    const devices::StreamRequest request{platen.catalogue().defaultSignals, Rate_Hz};
    if (const auto started =
            platen.startStream(request, [&rows](SampleBlockPtr block) { rows += block->rows(); });
        !started) {
        return failure(started.error());
    }
    const auto waited = platen.clock().waitFor(duration_s);
    platen.stopStream();
    if (!waited) {
        return failure(waited.error());
    }
    return rows;
}

/// Virtual seconds that the identification of all axes took.
Result<double> runIdentification() {
    auto device = devices::openDevice("sim:planar", {});
    if (!device) {
        return failure(device.error());
    }
    app::IdentifyConfig config;
    const app::Actuator& platen = app::actuatorOf("planar");
    if (const auto given = platen.identify.setGiven(config, "m", 0.64); !given) {
        return failure(given.error());
    }
    const auto result = platen.identify.run(**device, config, {});
    if (!result) {
        return failure(result.error());
    }
    if (std::get<app::AxesIdentifyResult>(*result).quality.verdict == app::Verdict::Refused) {
        return failure(ErrorCode::Refused, "the identification was refused", "");
    }
    return (*device)->clock().now_s();
}

void benchChain(Goals& goals) {
    constexpr double Duration_s = 10.0;
    const std::string name = "whole chain of the platen at 1 kHz, all imperfections";
    const auto rows = runChain(Duration_s);
    if (!rows) {
        return goals.failed(name, rows.error().message);
    }
    if (std::abs(static_cast<double>(*rows) - Rate_Hz * Duration_s) > 2.0) {
        return goals.failed(name, "rows were lost");
    }
    const double time_s = processorTime_s([] { (void)runChain(Duration_s); }, 5);
    goals.atLeast(name, Duration_s / time_s, 50.0, "x real time on one core");
}

void benchIdentification(Goals& goals) {
    const std::string name = "identification of the platen";
    const auto virtual_s = runIdentification();
    if (!virtual_s) {
        return goals.failed(name, virtual_s.error().message);
    }
    constexpr int Rounds = 5;
    const double wall_s = wallTime_s([] { (void)runIdentification(); }, Rounds);
    const double whole_s = processorTime_s([] { (void)runIdentification(); }, Rounds);
    const double chain_s = processorTime_s([&] { (void)runChain(*virtual_s); }, Rounds);
    goals.below(name, wall_s, 15.0, "s");
    // Whatever the machine: calibration of the chips and fit take three times the motion that they are made
    // from (measured: 4.2 together), and must not grow to twice that.
    goals.below("identification of the platen over the same time of its chain alone", whole_s / chain_s, 8.0,
                "times");
}

} // namespace
} // namespace halbench::bench

int main() {
    halbench::bench::Goals goals;
    halbench::bench::benchChain(goals);
    halbench::bench::benchIdentification(goals);
    return goals.exitCode();
}
