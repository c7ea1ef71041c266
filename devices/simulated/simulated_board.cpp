#include "devices/simulated/simulated_board.h"

#include <algorithm>
#include <cmath>

namespace halbench::devices {
namespace {

std::uint16_t octets(std::size_t size) {
    return static_cast<std::uint16_t>(std::min<std::size_t>(size, 65535));
}

} // namespace

SimulatedBoard::SimulatedBoard(SimulatedActuator actuator)
    : m_actuator(std::move(actuator)), m_readings(m_actuator.readingCount),
      m_outputs(m_actuator.outputCount) {
    sampleAndDrive();
}

void SimulatedBoard::sampleAndDrive() {
    m_actuator.plant->read(m_readings);
    if (m_broken && m_broken->index < m_readings.size()) {
        m_readings[m_broken->index] = m_broken->value;
    }
    m_actuator.firmware->tick(m_readings, m_outputs);
    m_actuator.plant->drive(m_outputs);
}

void SimulatedBoard::tick() {
    m_actuator.plant->advance(m_actuator.subSteps);
    ++m_ticks;
    sampleAndDrive();
}

void SimulatedBoard::advanceTo(double time_s) {
    const double last =
        std::floor(time_s / Tick_s + 1e-6); // a time that is a whole tick up to rounding counts
    while (static_cast<double>(m_ticks) < last) {
        tick();
    }
}

void SimulatedBoard::receive(std::span<const std::uint8_t> packet) {
    hb_board_receive(&m_actuator.firmware->board(), packet.data(), octets(packet.size()));
}

std::size_t SimulatedBoard::transmit(std::span<std::uint8_t> packet) {
    return hb_board_transmit(&m_actuator.firmware->board(), packet.data(), octets(packet.size()));
}

} // namespace halbench::devices
