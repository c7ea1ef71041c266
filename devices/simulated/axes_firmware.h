#pragma once

#include "devices/firmware/axes/hb_axes.h"
#include "devices/simulated/simulated_board.h"

#include <string>

namespace halbench::devices {

/// The controller's code of an actuator on hb_axes.h: readings of the plant are the positions, outputs what
/// the actuator's own tables say.
class AxesFirmware final : public Firmware {
public:
    /// `actuator` outlives it, and so does the plant, whose truth is measured like the board's signals.
    AxesFirmware(const hb_actuator& actuator, std::string identity, const Plant& plant,
                 SimulatedBoard::Line line);
    AxesFirmware(const AxesFirmware&) = delete;
    AxesFirmware& operator=(const AxesFirmware&) = delete;

    const hb_board& board() const override { return m_axes.board; }
    void tick(std::span<const float> readings, std::span<float> outputs) override;

private:
    std::string m_identity;
    hb_axes m_axes{};
};

} // namespace halbench::devices
