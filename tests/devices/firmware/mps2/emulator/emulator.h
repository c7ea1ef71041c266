#pragma once

#include "control/base/result.h"
#include "devices/transport/descriptor.h"

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace halbench::mps2 {

/// A program on qemu's board `mps2-an386` (Cortex-M4F), instruction by instruction: each one takes
/// Instruction_ns of the board's time, so that the core's timer of 25 MHz counts 3.2 for each. The first two
/// serial ports are octet streams of this process. Ends with its owner.
class Emulator {
public:
    static constexpr double Instruction_ns = 128.0; ///< -icount shift=7
    static constexpr double TimerCount_ns = 40.0;

    enum class Port { Xcp, Plant };

    /// Errors: InvalidInput (no such program), DeviceLost (no process, no socket).
    static Result<std::unique_ptr<Emulator>> start(const std::string& program);
    Emulator(const Emulator&) = delete;
    Emulator& operator=(const Emulator&) = delete;
    ~Emulator();

    /// Errors: DeviceLost (the emulator has ended).
    Result<void> write(Port port, std::span<const std::uint8_t> octets);
    /// Waits for exactly so many octets and appends them; takes what the other port says meanwhile, too.
    /// Errors: DeviceLost (the emulator has ended, or the program says nothing for a minute).
    Result<void> read(Port port, std::size_t count, std::vector<std::uint8_t>& octets);

    /// Whole instructions from the counts of the core's timer.
    static double instructions(std::uint32_t counts);

private:
    struct Stream {
        devices::Descriptor socket;
        std::vector<std::uint8_t> received; ///< not yet read
    };

    Emulator() = default;
    Result<void> receive();
    /// What happened and what the emulator wrote about it.
    tl::unexpected<Error> lost(const std::string& event) const;

    Stream m_streams[2];
    devices::Descriptor m_messages; ///< its standard error
    pid_t m_process = -1;
};

} // namespace halbench::mps2
