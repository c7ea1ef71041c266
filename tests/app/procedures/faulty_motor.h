#pragma once

#include "devices/simulated/fault_transport.h"
#include "devices/simulated/htm/simulated_htm.h"
#include "devices/simulated/loopback_transport.h"
#include "devices/simulated/registry/simulated_device.h"
#include "devices/xcp/xcp_device.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace halbench::app {

/// A simulated board that outlives its masters, and a link to it that can be broken at any moment.
class FaultyMotor {
public:
    explicit FaultyMotor(const std::string& query, std::uint64_t seed = 1)
        : m_faults(std::make_shared<devices::LinkFaults>()), m_seed(seed) {
        const auto uri = devices::parseDeviceUri("sim:htm?" + query);
        EXPECT_TRUE(uri);
        auto board = devices::makeSimulatedBoard(*uri, {});
        EXPECT_TRUE(board);
        m_board = std::move(*board);
    }

    /// A new master; the one before must be gone.
    std::unique_ptr<devices::Device> connect() {
        auto loopback = std::make_unique<devices::LoopbackTransport>(m_board, false);
        auto link = std::make_unique<devices::FaultTransport>(std::move(loopback), m_faults, m_seed);
        devices::XcpDeviceOptions options;
        options.identity.isSimulated = true;
        auto device = devices::openXcpDevice(std::move(link), std::move(options));
        EXPECT_TRUE(device) << device.error().message;
        return device ? std::move(*device) : nullptr;
    }

    /// The link works again, for whoever looks at what is left.
    void repair() { *m_faults = {}; }

    devices::LinkFaults& faults() { return *m_faults; }
    devices::SimulatedBoard& board() { return *m_board; }

    bool isArmed() const { return m_board->firmware().safety.armed != 0; }
    double commandedCurrent_A() const {
        return static_cast<double>(devices::htmFirmware(*m_board).signals.current_command_A);
    }

private:
    std::shared_ptr<devices::LinkFaults> m_faults;
    std::uint64_t m_seed; ///< of what the link loses
    std::shared_ptr<devices::SimulatedBoard> m_board;
};

} // namespace halbench::app
