#pragma once

#include "control/base/result.h"

#include <cstdint>
#include <string>
#include <utility>

namespace halbench::devices {

/// Owns one socket; non-blocking, never inherited by child processes.
class TcpSocket {
public:
    TcpSocket() = default;
    explicit TcpSocket(int descriptor) : m_descriptor(descriptor) {}
    TcpSocket(TcpSocket&& other) noexcept : m_descriptor(std::exchange(other.m_descriptor, -1)) {}
    TcpSocket& operator=(TcpSocket&& other) noexcept;
    TcpSocket(const TcpSocket&) = delete;
    ~TcpSocket() { close(); }

    bool isOpen() const { return m_descriptor >= 0; }
    int descriptor() const { return m_descriptor; }
    void close() noexcept;

private:
    int m_descriptor = -1;
};

/// `HOST:PORT`, with an IPv6 host in brackets. Errors: InvalidInput.
struct TcpAddress {
    std::string host;
    std::uint16_t port = 0;
    std::string text() const;
};
Result<TcpAddress> parseTcpAddress(const std::string& text);

/// Errors: DeviceLost with the cause in words.
Result<TcpSocket> connectTcp(const TcpAddress& address, double timeout_s);
/// Port 0 picks a free one; `address` then holds it. Errors: InvalidInput (port in use, not of this machine),
/// DeviceLost (host name).
Result<TcpSocket> listenTcp(TcpAddress& address);
/// The next waiting connection; closed when there is none.
TcpSocket acceptTcp(const TcpSocket& listener);

} // namespace halbench::devices
