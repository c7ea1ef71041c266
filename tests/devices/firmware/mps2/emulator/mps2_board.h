#pragma once

#include "devices/simulated/plant.h"
#include "tests/devices/firmware/mps2/emulator/emulator.h"

#include <memory>
#include <string>
#include <vector>

namespace halbench::mps2 {

/// How the values of a plant stand on the board's plant line: each reading as a code of 16 bit or as a float,
/// each output as a code of 16 bit.
struct PlantLine {
    std::size_t codes = 0;  ///< readings, first
    std::size_t floats = 0; ///< readings, behind them
    std::size_t outputs = 0;
    int subSteps = 4; ///< of the plant in a tick
};

/// How long the control ticks took on the processor.
struct TickCosts {
    std::uint64_t count = 0;
    double worst_instructions = 0.0;
    double total_instructions = 0.0;
};

/// A program of boards/mps2_an386 beside its plant, in lock-step: a tick samples the plant, runs the board's
/// tick to its end and drives the plant with what came out, which then runs for a millisecond. Between ticks
/// the board serves its serial line at once. Same octets at the same ticks give the same run. Tick 0 happens
/// in make(), as at power-on. Thread: one.
class Mps2Board {
public:
    static constexpr double Tick_s = 1e-3;

    /// Errors: those of Emulator.
    static Result<std::unique_ptr<Mps2Board>> make(const std::string& program,
                                                   std::unique_ptr<devices::Plant> plant, PlantLine line);

    double time_s() const { return static_cast<double>(m_ticks) * Tick_s; }
    /// Lets a millisecond pass, then does the tick at its end. Errors: DeviceLost.
    Result<void> tick();
    /// Octets for the board's serial line, which it obeys and answers before this returns. Errors:
    /// DeviceLost.
    Result<void> send(std::span<const std::uint8_t> octets);
    /// What the board said on its serial line since the last call.
    std::vector<std::uint8_t> take() { return std::exchange(m_said, {}); }

    devices::Plant& plant() { return *m_plant; }
    const TickCosts& costs() const { return m_costs; }
    void forgetCosts() { m_costs = {}; }

private:
    Mps2Board(std::unique_ptr<Emulator> emulator, std::unique_ptr<devices::Plant> plant, PlantLine line)
        : m_emulator(std::move(emulator)), m_plant(std::move(plant)), m_line(line) {}
    Result<void> sampleAndDrive();
    /// One order to the board and its answer, whose outputs are returned.
    Result<std::vector<std::uint8_t>> exchange(char kind, std::span<const std::uint8_t> octets);

    std::unique_ptr<Emulator> m_emulator;
    std::unique_ptr<devices::Plant> m_plant;
    PlantLine m_line;
    std::uint64_t m_ticks = 0; ///< after the one at power-on
    std::uint32_t m_sentOctets = 0;
    std::uint32_t m_saidOctets = 0;
    std::uint32_t m_counts = 0; ///< of the core's timer, of the last tick
    std::vector<std::uint8_t> m_said;
    TickCosts m_costs;
};

} // namespace halbench::mps2
