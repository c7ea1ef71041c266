#pragma once

#include "control/base/result.h"

#include <cstdint>
#include <span>
#include <vector>

namespace halbench::firmware {

/// A board on an emulated processor whose serial line is served by this process.
class ServedBoard {
public:
    virtual ~ServedBoard() = default;

    /// A program has opened the port.
    virtual void lineOpened() = 0;
    /// Octets from the line. Errors: DeviceLost.
    virtual Result<void> send(std::span<const std::uint8_t> octets) = 0;
    /// What the board said since the last call.
    virtual std::vector<std::uint8_t> take() = 0;
    /// Of the board's own clock.
    virtual double time_s() const = 0;
    /// Errors: DeviceLost.
    virtual Result<void> advanceTo(double time_s) = 0;
};

} // namespace halbench::firmware
