#pragma once

#include "devices/simulated/plant.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace halbench::devices {

/// A simulated actuator: its plant and the controller board's own code on one virtual clock.
/// Tick k happens at t = k ms: the board samples the sensors, computes and drives; then the plant runs to
/// (k + 1) ms. Tick 0 happens at power-on, in the constructor, so that every signal is valid from the start.
/// The board serves XCP packets between ticks at once. The plant's truth is measured like any other signal.
/// Thread: any one; nothing is shared between boards.
class SimulatedBoard {
public:
    /// The line the board is told it hangs on: the A2L block that describes it, and the longest measurement
    /// packet it carries.
    struct Line {
        const char* a2l = nullptr; ///< outlives the board; nullptr: TCP
        std::uint16_t maxDto = 0;  ///< 0: the board's own limit
    };

    explicit SimulatedBoard(SimulatedActuator actuator);
    SimulatedBoard(const SimulatedBoard&) = delete;
    SimulatedBoard& operator=(const SimulatedBoard&) = delete;

    static constexpr double Tick_s = 1e-3;

    /// Time of the tick done last.
    double time_s() const { return static_cast<double>(m_ticks) * Tick_s; }
    /// Lets a millisecond pass, then does the tick at its end.
    void tick();
    /// Runs all ticks up to `time_s`; does nothing when it is already past it.
    void advanceTo(double time_s);

    void receive(std::span<const std::uint8_t> packet);
    /// Octets of the next packet for the master, put into `packet`; 0 if there is none.
    std::size_t transmit(std::span<std::uint8_t> packet);
    /// Message counter of the packet transmitted last.
    std::uint16_t messageCounter() const { return hb_board_counter(&firmware()); }

    /// From now on reading `index` of the plant is this, whatever the plant does: a broken sensor, for tests.
    void breakReading(std::size_t index, double value) { m_broken = {index, static_cast<float>(value)}; }

    /// The physics, for tests: to look at it and to break something in it.
    const Plant& plant() const { return *m_actuator.plant; }
    Plant& plant() { return *m_actuator.plant; }
    /// What the board holds, for tests.
    const hb_board& firmware() const { return std::as_const(*m_actuator.firmware).board(); }

private:
    struct BrokenReading {
        std::size_t index;
        float value;
    };

    void sampleAndDrive();

    SimulatedActuator m_actuator;
    std::vector<float> m_readings;
    std::vector<float> m_outputs;
    std::uint64_t m_ticks = 0; ///< after the one at power-on
    std::optional<BrokenReading> m_broken;
};

} // namespace halbench::devices
