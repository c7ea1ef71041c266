#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace halbench::devices {

/// A board that lives in this process, as its server sees it.
class ServedBoard {
public:
    virtual ~ServedBoard() = default;
    /// Lets board time pass up to this one.
    virtual void advanceTo(double time_s) = 0;
    virtual void receive(std::span<const std::uint8_t> packet) = 0;
    /// The next packet for the master; false when there is none.
    virtual bool transmit(std::vector<std::uint8_t>& packet, std::uint16_t& counter) = 0;
};

/// Where masters reach a served board: a TCP port, a UDP port or a pseudo terminal. One master at a time, in
/// a network the first one (session_holder.h); the board's own watchdog decides what a lost master means.
/// Thread: the one that serves.
class ServerPort {
public:
    virtual ~ServerPort() = default;
    /// "tcp:127.0.0.1:5555", with the real port.
    virtual std::string address() const = 0;
    /// Other machines reach it, not this one alone.
    virtual bool isOpenToNetwork() const { return false; }
    /// Time passes, by which a silent master is told.
    virtual void advanceTo(double time_s) { (void)time_s; }
    /// Returns when a master said something, after `timeout_ms` at the latest.
    virtual void waitForTraffic(int timeout_ms) const = 0;
    /// Gives the board what arrived and the master what the board says; never blocks.
    virtual void exchange(ServedBoard& board) = 0;
};

/// First octet of the command that begins a session (resources/help/protocol.md 3.5).
constexpr std::uint8_t ConnectCommand = 0xFF;
/// MAX_CTO of every board.
constexpr std::size_t MaxCommandOctets = 255;

/// Serves one board, paced by the wall clock, until the flag is set (by a signal or a test).
void serveBoard(ServerPort& port, ServedBoard& board, const std::atomic<int>& interruptSignal);

} // namespace halbench::devices
