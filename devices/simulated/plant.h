#pragma once

#include "devices/firmware/board/hb_board.h"

#include <memory>
#include <span>

namespace halbench::devices {

/// The physics of an actuator between the outputs of its board and the board's inputs.
class Plant {
public:
    virtual ~Plant() = default;

    /// Samples the sensors at this instant.
    virtual void read(std::span<float> readings) = 0;
    /// Takes effect at once and holds.
    virtual void drive(std::span<const float> outputs) = 0;
    /// Lets this many sub-steps pass.
    virtual void advance(int subSteps) = 0;
    /// Signals of what no board can measure; their values are those of the last read() or drive().
    virtual hb_signal_table truth() const = 0;
    /// Parameters that a host changes while it runs, e.g. where a prescribed motion goes; read by the next
    /// advance().
    virtual hb_parameter_table settings() { return {}; }
};

/// The controller's code of an actuator, as it runs on a real board.
class Firmware {
public:
    virtual ~Firmware() = default;

    virtual const hb_board& board() const = 0;
    hb_board& board() { return const_cast<hb_board&>(static_cast<const Firmware&>(*this).board()); }
    /// One tick: from the readings of the plant to the outputs that drive it.
    virtual void tick(std::span<const float> readings, std::span<float> outputs) = 0;
};

/// Plant and firmware of one actuator.
struct SimulatedActuator {
    std::unique_ptr<Plant> plant;
    std::unique_ptr<Firmware> firmware; ///< may point into the plant
    std::size_t readingCount = 0;
    std::size_t outputCount = 0;
    int subSteps = 4; ///< of the plant in a tick
};

} // namespace halbench::devices
