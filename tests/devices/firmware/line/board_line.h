#pragma once

#include "devices/transport/descriptor.h"
#include "tests/devices/firmware/line/served_board.h"

#include <atomic>
#include <memory>
#include <string>

namespace halbench::firmware {

/// The board's UART on a pseudo terminal, which any program opens like a serial port; the board runs at the
/// speed of the wall clock, or slower where the machine is. Nobody holds the port open in the meantime.
/// Thread: the one that serves.
class BoardLine {
public:
    /// Errors: DeviceLost (no pseudo terminal).
    static Result<std::unique_ptr<BoardLine>> open(std::shared_ptr<ServedBoard> board);

    /// "/dev/pts/5"
    const std::string& path() const { return m_path; }
    /// As seen last by the thread that serves. Any thread.
    bool isOpened() const { return m_isOpened; }
    /// Of the board, as of the slice that ended last. Any thread.
    double boardTime_s() const { return m_boardTime_s; }
    /// Runs the board until the flag is set, or the board is lost.
    void serve(const std::atomic<int>& isEnding);

private:
    BoardLine(std::shared_ptr<ServedBoard> board, devices::Descriptor line, std::string path)
        : m_board(std::move(board)), m_line(std::move(line)), m_path(std::move(path)) {}
    bool hasOpener();
    Result<void> exchange();

    std::shared_ptr<ServedBoard> m_board;
    devices::Descriptor m_line;
    std::string m_path;
    std::atomic<bool> m_isOpened{false};
    std::atomic<double> m_boardTime_s{0.0};
    std::vector<std::uint8_t> m_outgoing;
};

} // namespace halbench::firmware
