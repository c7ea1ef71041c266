#pragma once

#include "devices/simulated/loopback_transport.h"
#include "devices/simulated/planar/simulated_planar.h"
#include "devices/simulated/registry/simulated_device.h"
#include "devices/xcp/xcp_device.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace halbench::devices {

/// The positioner with the force constant that its windings really have.
inline constexpr double WindingsForce_N_per_A = -3.52301;

class Positioner {
public:
    explicit Positioner(const std::string& query) {
        auto board = makeSimulatedBoard(*parseDeviceUri("sim:planar?" + query), {});
        EXPECT_TRUE(board) << board.error().message;
        m_board = std::move(*board);
        XcpDeviceOptions options;
        options.identity.isSimulated = true;
        auto device = openXcpDevice(std::make_unique<LoopbackTransport>(m_board, false), std::move(options));
        EXPECT_TRUE(device) << device.error().message;
        m_device = std::move(*device);
    }

    Device& device() { return *m_device; }
    SimulatedBoard& board() { return *m_board; }
    const hb_planar& firmware() const { return planarFirmware(*m_board); }
    const models::PlanarTruth& truth() const { return planarTruth(*m_board); }

    void set(const std::string& name, double value) {
        const ParameterValue change[] = {{name, value}};
        const auto written = m_device->writeParameters(change);
        ASSERT_TRUE(written) << name << ": " << written.error().message;
    }
    bool canSet(const std::string& name, double value) {
        const ParameterValue change[] = {{name, value}};
        return m_device->writeParameters(change).has_value();
    }
    void arm(int mode) {
        set("hb.mode", mode);
        const auto armed = m_device->arm();
        ASSERT_TRUE(armed) << armed.error().message;
    }
    void wait(double duration_s) {
        const auto waited = m_device->clock().waitFor(duration_s);
        ASSERT_TRUE(waited) << waited.error().message;
    }
    double signal(const std::string& name) {
        const std::string names[] = {name};
        const auto values = m_device->readSignals(names);
        EXPECT_TRUE(values) << name;
        return values ? values->front() : NAN;
    }
    /// A signal at 1 kHz.
    std::vector<double> samples(const std::string& name, double duration_s) {
        std::vector<double> values;
        EXPECT_TRUE(m_device->startStream({{name}, 1000.0}, [&](const SampleBlockPtr& block) {
            values.insert(values.end(), block->values.begin(), block->values.end());
        }));
        wait(duration_s);
        m_device->stopStream();
        EXPECT_FALSE(values.empty());
        return values;
    }

private:
    std::shared_ptr<SimulatedBoard> m_board;
    std::unique_ptr<Device> m_device;
};

} // namespace halbench::devices
