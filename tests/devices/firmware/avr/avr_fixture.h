#pragma once

#include "devices/xcp/xcp_device.h"
#include "tests/devices/firmware/avr/simavr/avr_transport.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace halbench::simavr {

/// A program beside the test, built with it.
inline std::string boardProgram(const std::string& name = "htm_atmega328p.elf") {
    const auto test = std::filesystem::read_symlink("/proc/self/exe");
    return test.parent_path().parent_path() / "firmware" / name;
}

/// The board on its processor with its motor, and the master that talks to it over the serial line.
struct AvrBench {
    std::shared_ptr<AvrBoard> board;
    std::unique_ptr<devices::Device> device;

    void wait(double time_s) {
        const auto waited = device->clock().waitFor(time_s);
        ASSERT_TRUE(waited) << waited.error().message;
    }
    Result<void> write(const std::string& name, double value) {
        const ParameterValue change[] = {{name, value}};
        return device->writeParameters(change);
    }
    double read(const std::string& name) {
        const std::string names[] = {name};
        const auto values = device->catalogue().findSignal(name) != nullptr ? device->readSignals(names)
                                                                            : device->readParameters(names);
        EXPECT_TRUE(values) << name << ": " << values.error().message;
        return values ? values->front() : 0.0;
    }
};

/// No imperfection but the stray field, which the board compensates by default.
inline models::HtmParameters perfectMotor() {
    models::HtmParameters motor = models::withoutImperfections({});
    motor.stray_T_per_A = models::HtmParameters{}.stray_T_per_A;
    return motor;
}

inline std::shared_ptr<AvrBoard> makeBoard(const models::HtmParameters& parameters, std::uint64_t seed = 1,
                                           const std::string& program = boardProgram()) {
    auto board = AvrBoard::make(program, parameters, seed);
    EXPECT_TRUE(board) << board.error().message;
    return board ? std::shared_ptr<AvrBoard>(std::move(*board)) : nullptr;
}

inline AvrBench connect(std::shared_ptr<AvrBoard> board) {
    devices::XcpDeviceOptions options;
    options.identity.uri = "simavr";
    auto device = devices::openXcpDevice(std::make_unique<AvrTransport>(board), std::move(options));
    EXPECT_TRUE(device) << device.error().message;
    return {std::move(board), device ? std::move(*device) : nullptr};
}

inline AvrBench openBench(const models::HtmParameters& parameters = perfectMotor(), std::uint64_t seed = 1) {
    return connect(makeBoard(parameters, seed));
}

} // namespace halbench::simavr
