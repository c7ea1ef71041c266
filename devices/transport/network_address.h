#pragma once

#include "control/base/result.h"
#include "devices/transport/descriptor.h"

#include <netdb.h>

#include <cstdint>
#include <memory>
#include <string>

namespace halbench::devices {

/// `HOST:PORT`, with an IPv6 host in brackets.
struct NetworkAddress {
    std::string host;
    std::uint16_t port = 0;
    std::string text() const;
};
/// Errors: InvalidInput.
Result<NetworkAddress> parseNetworkAddress(const std::string& text);

/// Where to listen: `HOST:PORT`, or `PORT` and `:PORT` for this machine alone (127.0.0.1). Errors:
/// InvalidInput.
Result<NetworkAddress> parseListenAddress(const std::string& text);

/// TCP or UDP.
enum class SocketKind { Stream, Datagram };
/// "tcp:HOST:PORT" or "udp:HOST:PORT".
std::string uriOf(const NetworkAddress& address, SocketKind kind);

struct AddressListDeleter {
    void operator()(addrinfo* list) const { freeaddrinfo(list); }
};
using AddressList = std::unique_ptr<addrinfo, AddressListDeleter>;
/// What the host name stands for. Errors: DeviceLost with the cause in words.
Result<AddressList> resolve(const NetworkAddress& address, SocketKind kind, bool isPassive);

/// A socket of this family; non-blocking, never inherited by child processes. Closed on failure (errno).
Descriptor makeSocket(const addrinfo& entry);
/// Binds to the address; port 0 picks a free one, and `address` then holds it. Errors: InvalidInput (port in
/// use, not of this machine), DeviceLost (host name).
Result<Descriptor> bindSocket(NetworkAddress& address, SocketKind kind);
/// True when a bound socket is reached from other machines as well.
bool isOpenToNetwork(const Descriptor& socket);

} // namespace halbench::devices
