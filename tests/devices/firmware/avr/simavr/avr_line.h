#pragma once

#include "devices/transport/descriptor.h"
#include "tests/devices/firmware/avr/simavr/avr_board.h"

#include <atomic>
#include <memory>
#include <string>

namespace halbench::simavr {

/// The board's UART on a pseudo terminal, which any program opens like a serial port; the board runs at the
/// speed of the wall clock, or slower where the machine is. Opening the port resets the board, as the DTR
/// line of an Arduino does; nobody holds the port open in the meantime. Thread: the one that serves.
class AvrLine {
public:
    /// Errors: DeviceLost (no pseudo terminal).
    static Result<std::unique_ptr<AvrLine>> open(std::shared_ptr<AvrBoard> board);

    /// "/dev/pts/5"
    const std::string& path() const { return m_path; }
    /// As seen last by the thread that serves. Any thread.
    bool isOpened() const { return m_isOpened; }
    /// Runs the board until the flag is set.
    void serve(const std::atomic<int>& isEnding);

private:
    AvrLine(std::shared_ptr<AvrBoard> board, devices::Descriptor line, std::string path)
        : m_board(std::move(board)), m_line(std::move(line)), m_path(std::move(path)) {}
    bool hasOpener();
    void exchange();

    std::shared_ptr<AvrBoard> m_board;
    devices::Descriptor m_line;
    std::string m_path;
    std::atomic<bool> m_isOpened{false};
    std::vector<std::uint8_t> m_outgoing;
};

} // namespace halbench::simavr
