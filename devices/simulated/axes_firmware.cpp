#include "devices/simulated/axes_firmware.h"

#include <algorithm>
#include <utility>

namespace halbench::devices {

AxesFirmware::AxesFirmware(const hb_actuator& actuator, std::string identity, const Plant& plant,
                           SimulatedBoard::Line line)
    : m_identity(std::move(identity)) {
    hb_board_config config{};
    config.device = m_identity.c_str();
    config.transport_a2l = line.a2l;
    config.max_dto = line.maxDto;
    config.extra = plant.truth();
    hb_axes_init(&m_axes, &actuator, &config);
}

void AxesFirmware::tick(std::span<const float> readings, std::span<float> outputs) {
    float positions[HB_AXES_MOST] = {};
    std::copy_n(readings.begin(), std::min<std::size_t>(readings.size(), HB_AXES_MOST), positions);
    hb_board_tick(&m_axes.board, positions);
    std::copy_n(m_axes.signals.output, outputs.size(), outputs.begin());
}

} // namespace halbench::devices
