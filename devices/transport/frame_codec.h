#pragma once

#include "control/base/result.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace halbench::devices {

/// One whole packet of the line.
struct Frame {
    std::optional<std::uint16_t> counter;
    std::span<const std::uint8_t> packet; ///< valid until the next call of the codec
};

/// How packets are told apart on a line of octets, in both directions. Pure; no port.
class FrameCodec {
public:
    virtual ~FrameCodec() = default;

    /// The line begins anew.
    virtual void restart() = 0;
    virtual void feed(std::span<const std::uint8_t> octets) = 0;
    /// The next whole packet; nothing when more octets are needed. Error: Protocol, nothing can follow.
    virtual Result<std::optional<Frame>> next() = 0;
    /// Nothing came for a while: what had begun will not be completed.
    virtual void noteSilence() = 0;
    virtual void append(std::vector<std::uint8_t>& line, std::uint16_t counter,
                        std::span<const std::uint8_t> packet) = 0;
    /// Frames that were dropped since the beginning.
    virtual std::uint64_t damaged() const = 0;
    /// The counter runs from 0 to this; 0: there is none.
    virtual std::uint16_t counterMask() const = 0;
};

} // namespace halbench::devices
