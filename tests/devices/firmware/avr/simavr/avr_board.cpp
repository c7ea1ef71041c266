#include "tests/devices/firmware/avr/simavr/avr_board.h"

#include <algorithm>
#include <cmath>

namespace halbench::simavr {
namespace {

constexpr int FirstDac = 0x60;
constexpr std::uint64_t CyclesPerPlantStep = 160; // 10 us at 16 MHz

} // namespace

Result<std::unique_ptr<AvrBoard>>
AvrBoard::make(const std::string& elf, const models::HtmParameters& parameters, std::uint64_t seed) {
    auto plant = models::HtmPlant::make(parameters, seed, PlantStep_s);
    if (!plant) {
        return failure(plant.error());
    }
    auto core = AvrCore::load(elf);
    if (!core) {
        return failure(core.error());
    }
    return std::unique_ptr<AvrBoard>(new AvrBoard(std::move(*core), std::move(*plant)));
}

AvrBoard::AvrBoard(std::unique_ptr<AvrCore> core, models::HtmPlant plant)
    : m_core(std::move(core)), m_plant(std::move(plant)) {
    m_core->onConversion = [this](int channel) { return convert(channel); };
    m_core->onTwiAddress = [this](int address) {
        const int channel = address - FirstDac;
        return channel >= 0 && channel < 2 && m_isDacConnected[static_cast<std::size_t>(channel)];
    };
    m_core->onTwiOctet = [this](int address, int index, std::uint8_t octet) {
        return takeTwiOctet(address, index, octet);
    };
    m_core->onPin = [this](bool isHigh) { pinChanged(isHigh); };
}

void AvrBoard::advanceTo(double time_s) {
    m_core->runTo(static_cast<std::uint64_t>(std::llround(time_s * AvrCore::Clock_Hz)));
}

void AvrBoard::advancePlant() {
    const std::uint64_t steps = m_core->cycle() / CyclesPerPlantStep;
    m_plant.drive({{static_cast<double>(m_dacCode[0]), static_cast<double>(m_dacCode[1])}, 0.0});
    m_plant.advance(static_cast<int>(steps - m_plantSteps));
    m_plantSteps = steps;
}

int AvrBoard::convert(int channel) {
    if (channel < 0 || channel > 3) {
        return 0;
    }
    m_sampled = channel == 0 ? m_core->cycle() : m_sampled;
    if (const int broken = m_brokenCode[static_cast<std::size_t>(channel)]; broken >= 0) {
        return broken;
    }
    advancePlant();
    const models::HtmReadings readings = m_plant.read();
    const auto pin = static_cast<std::size_t>(channel % 2);
    return static_cast<int>(channel < 2 ? readings.hallCode[pin] : readings.temperatureCode[pin]);
}

// The fast write of an MCP4725: two octets, power-down bits and the upper four bits first; the output changes
// with the second one. A powered-down output is not a voltage the amplifier may see: it counts as not there.
bool AvrBoard::takeTwiOctet(int address, int index, std::uint8_t octet) {
    const auto channel = static_cast<std::size_t>(address - FirstDac);
    if (index % 2 == 0) {
        m_dacHigh[channel] = octet;
        return (octet & 0xF0) == 0;
    }
    advancePlant();
    m_dacCode[channel] = (m_dacHigh[channel] & 0x0F) << 8 | octet;
    if (channel == 1) {
        m_ticks.latency_cycles += m_core->cycle() - m_sampled;
    }
    return true;
}

void AvrBoard::pinChanged(bool isHigh) {
    const std::uint64_t now = m_core->cycle();
    if (isHigh) {
        if (m_tickStart > 0) {
            m_ticks.shortest_period_cycles = std::min(m_ticks.shortest_period_cycles, now - m_tickStart);
            m_ticks.longest_period_cycles = std::max(m_ticks.longest_period_cycles, now - m_tickStart);
        }
        m_tickStart = now;
        return;
    }
    if (m_tickStart == 0) {
        return; // the pin becomes an output
    }
    ++m_ticks.count;
    m_ticks.total_cycles += now - m_tickStart;
    m_ticks.worst_cycles = std::max(m_ticks.worst_cycles, now - m_tickStart);
}

} // namespace halbench::simavr
