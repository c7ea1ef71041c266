#include "devices/simulated/simulated_board.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace halbench::devices {

const hb_signal SimulatedBoard::TruthSignals[2] = {
    HB_SIGNAL("truth.position", "rad", HB_FLOAT64, Truth, position_rad, 1.0F, -1e6F, 1e6F, nullptr,
              "True rotor angle, known to the simulation only"),
    HB_SIGNAL("truth.speed", "rad/s", HB_FLOAT64, Truth, speed_rad_s, 1.0F, -1e3F, 1e3F, nullptr,
              "True rotor speed, known to the simulation only"),
};

Result<std::unique_ptr<SimulatedBoard>> SimulatedBoard::make(const models::HtmParameters& parameters,
                                                             std::uint64_t seed, Line line) {
    auto plant = models::HtmPlant::make(parameters, seed);
    if (!plant) {
        return failure(plant.error());
    }
    return std::unique_ptr<SimulatedBoard>(new SimulatedBoard(std::move(*plant), seed, line));
}

SimulatedBoard::SimulatedBoard(models::HtmPlant plant, std::uint64_t seed, Line line)
    : m_plant(std::move(plant)), m_identity(fmt::format("sim-htm-{}", seed)) {
    m_stored = initialCalibration();
    hb_htm_config config{};
    config.device = m_identity.c_str();
    config.transport_a2l = line.a2l;
    config.max_dto = line.maxDto;
    config.extra = {TruthSignals, 2, &m_truth};
    config.store = &SimulatedBoard::store;
    config.store_context = this;
    config.stored = &m_stored;
    hb_htm_init(&m_board, &config);
    sampleAndDrive();
    // The board starts counting turns within half a turn of its first reading; truth counts the same ones.
    const double board_rad = m_board.signals.position * (2.0 * Pi / HB_HTM_COUNTS_PER_TURN);
    m_turns_rad = 2.0 * Pi * std::round((m_truth.position_rad - board_rad) / (2.0 * Pi));
    updateTruth();
}

// The factory's settings (preset "published") with what this board was built for: its current limit, its
// computation delay, and no stray compensation in a motor that has no stray field.
hb_htm_calibration SimulatedBoard::initialCalibration() {
    hb_htm_init(&m_board, nullptr);
    hb_htm_calibration page = m_board.pages[0];
    const models::HtmParameters& p = m_plant.parameters();
    page.limit_current = static_cast<float>(p.currentLimit_A);
    page.delay_samples = static_cast<float>(p.delaySamples);
    if (p.stray_T_per_A == 0.0) {
        page.stray_coefficient = 0.0F;
    }
    return page;
}

std::uint8_t SimulatedBoard::store(void* context, const void* page) {
    static_cast<SimulatedBoard*>(context)->m_stored = *static_cast<const hb_htm_calibration*>(page);
    return 1;
}

void SimulatedBoard::updateTruth() {
    m_truth.position_rad = m_plant.truth().rotor.angle_rad - m_turns_rad;
    m_truth.speed_rad_s = m_plant.truth().rotor.speed_rad_s;
}

// A generator that is started again while it runs counts from segment 1 anew: its ticks fall back, although
// the segment may be the same.
void SimulatedBoard::redrawFrictionAtNewSegment() {
    const bool isRestarted = m_board.reference.running != 0 && m_board.reference.ticks < m_referenceTicks;
    m_referenceTicks = m_board.reference.ticks;
    if (m_board.signals.board.reference_segment != m_segment || isRestarted) {
        m_segment = m_board.signals.board.reference_segment;
        m_plant.redrawFriction();
    }
}

models::HtmDrive SimulatedBoard::driveOf(const hb_htm_outputs& outputs) const {
    models::HtmDrive drive;
    if (outputs.output_enabled != 0) {
        drive.dacCode = {static_cast<double>(outputs.dac_code[0]), static_cast<double>(outputs.dac_code[1])};
        drive.amplitude_A = static_cast<double>(outputs.current_command_A);
    }
    return drive;
}

void SimulatedBoard::sampleAndDrive() {
    updateTruth();
    models::HtmReadings readings = m_plant.read();
    readings.hallCode[0] = m_brokenHallCode.value_or(readings.hallCode[0]);
    hb_htm_inputs inputs{};
    for (std::size_t i = 0; i < 2; ++i) {
        inputs.hall_code[i] = static_cast<float>(readings.hallCode[i]);
        inputs.temperature_code[i] = static_cast<float>(readings.temperatureCode[i]);
    }
    hb_htm_outputs outputs{};
    hb_htm_fast_tick(&m_board, &inputs, &outputs);
    redrawFrictionAtNewSegment();
    m_plant.drive(driveOf(outputs));
}

void SimulatedBoard::tick() {
    constexpr int SubSteps = 4;
    m_plant.advance(SubSteps);
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
    hb_board_receive(&m_board.board, packet.data(),
                     static_cast<std::uint16_t>(std::min<std::size_t>(packet.size(), 65535)));
}

std::size_t SimulatedBoard::transmit(std::span<std::uint8_t> packet) {
    return hb_board_transmit(&m_board.board, packet.data(),
                             static_cast<std::uint16_t>(std::min<std::size_t>(packet.size(), 65535)));
}

} // namespace halbench::devices
