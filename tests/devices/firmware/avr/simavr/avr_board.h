#pragma once

#include "models/htm/htm_plant.h"
#include "tests/devices/firmware/avr/simavr/avr_core.h"

#include <array>
#include <memory>

namespace halbench::simavr {

/// How long the control ticks took, in processor cycles between the edges of the busy pin.
struct TickTimes {
    std::uint64_t count = 0;
    std::uint64_t worst_cycles = 0;
    std::uint64_t total_cycles = 0;
    std::uint64_t shortest_period_cycles = ~std::uint64_t{0};
    std::uint64_t longest_period_cycles = 0;
    std::uint64_t latency_cycles =
        0; ///< sum over all ticks: first Hall conversion started to last current set
};

/// The motor's controller board beside the motor: the program of boards/htm_atmega328p on its processor, Hall
/// and temperature sensors of the plant model on ADC0 to ADC3, two MCP4725 at 0x60 and 0x61 that drive it.
/// The plant follows in steps of 10 us; a conversion sees it at the instant it is started, a converter's new
/// voltage acts from the octet on that completes it. Thread: any one.
class AvrBoard {
public:
    static constexpr double PlantStep_s = 10.0e-6;

    /// Errors: InvalidInput (program), OutOfRange (parameters that make no amplifier).
    static Result<std::unique_ptr<AvrBoard>>
    make(const std::string& elf, const models::HtmParameters& parameters, std::uint64_t seed);

    double time_s() const { return static_cast<double>(m_core->cycle()) / AvrCore::Clock_Hz; }
    void advanceTo(double time_s);
    AvrCore& core() { return *m_core; }

    /// A converter falls off the bus, or comes back.
    void connectDac(int channel, bool isConnected) {
        m_isDacConnected.at(static_cast<std::size_t>(channel)) = isConnected;
    }
    int dacCode(int channel) const { return m_dacCode.at(static_cast<std::size_t>(channel)); }
    /// A sensor's wire breaks: the channel reads this code whatever the field is.
    void breakChannel(int channel, int code) { m_brokenCode.at(static_cast<std::size_t>(channel)) = code; }

    const models::HtmPlant& plant() const { return m_plant; }
    const TickTimes& ticks() const { return m_ticks; }
    double meanLatency_s() const {
        return static_cast<double>(m_ticks.latency_cycles) / static_cast<double>(m_ticks.count) /
               AvrCore::Clock_Hz;
    }
    void forgetTicks() { m_ticks = {}; }

private:
    AvrBoard(std::unique_ptr<AvrCore> core, models::HtmPlant plant);
    void advancePlant();
    int convert(int channel);
    bool takeTwiOctet(int address, int index, std::uint8_t octet);
    void pinChanged(bool isHigh);

    std::unique_ptr<AvrCore> m_core;
    models::HtmPlant m_plant;
    std::uint64_t m_plantSteps = 0;
    std::array<bool, 2> m_isDacConnected{true, true};
    std::array<int, 2> m_dacCode{2048, 2048}; ///< what an MCP4725 gives before it is written
    std::array<std::uint8_t, 2> m_dacHigh{};
    std::array<int, 4> m_brokenCode{-1, -1, -1, -1};
    std::uint64_t m_tickStart = 0;
    std::uint64_t m_sampled = 0;
    TickTimes m_ticks;
};

} // namespace halbench::simavr
