#pragma once

#include "control/base/result.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

struct avr_t;
struct avr_irq_t;

namespace halbench::simavr {

/// What the program occupies, from its ELF file.
struct AvrSizes {
    std::uint32_t flash = 0; ///< code, constants and initial values
    std::uint32_t ram = 0;   ///< variables; the stack comes on top
};

/// An ATmega328P at 16 MHz that executes a program instruction by instruction (simavr). Time is its cycle
/// counter and passes in runTo() only, so that a run is the same to the bit every time. Thread: any one.
class AvrCore {
public:
    static constexpr double Clock_Hz = 16.0e6;

    /// Errors: InvalidInput (no such program).
    static Result<std::unique_ptr<AvrCore>> load(const std::string& elf);
    ~AvrCore();
    AvrCore(const AvrCore&) = delete;
    AvrCore& operator=(const AvrCore&) = delete;

    std::uint64_t cycle() const;
    void runTo(std::uint64_t cycle);
    /// The reset button: RAM stays, the program begins anew. Octets on the line are lost.
    void reset();
    /// False once the program ran off its code or stopped with interrupts off.
    bool isRunning() const;

    /// Octets for the board's UART, which arrive one after the other at the speed of the line.
    void send(std::span<const std::uint8_t> octets);
    /// What the board sent since the last call.
    std::vector<std::uint8_t> take();

    /// Code 0..1023 that the converter gives for a channel at this instant.
    std::function<int(int channel)> onConversion;
    /// An octet written to a device on the I2C bus, `index` 0, 1, ... since its address; false: nobody
    /// acknowledges.
    std::function<bool(int address, int index, std::uint8_t octet)> onTwiOctet;
    std::function<bool(int address)> onTwiAddress;
    /// Port B pin 5 changed (it is high while the program is in its control tick).
    std::function<void(bool isHigh)> onPin;

    AvrSizes sizes() const { return m_sizes; }
    /// The program's variables where they lie in RAM, without its stack.
    std::span<std::uint8_t> variables();
    /// Octets of RAM between variables and stack that were never written since load().
    std::uint32_t untouchedRam() const;

private:
    AvrCore() = default;
    void connect();
    void scheduleOctet();
    void deliverOctet();
    void twiMessage(std::uint32_t value);

    avr_t* m_avr = nullptr;
    AvrSizes m_sizes;
    std::deque<std::uint8_t> m_toBoard;
    std::vector<std::uint8_t> m_fromBoard;
    bool m_isOctetScheduled = false;
    int m_twiAddress = -1;
    int m_twiIndex = 0;

    friend struct AvrCallbacks;
};

} // namespace halbench::simavr
