#include "devices/transport/network_address.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>

namespace halbench::devices {

namespace {

constexpr int Backlog = 4;

std::uint16_t boundPort(const Descriptor& socket) {
    sockaddr_storage name{};
    socklen_t size = sizeof name;
    if (::getsockname(socket.number(), reinterpret_cast<sockaddr*>(&name), &size) != 0) {
        return 0;
    }
    return ntohs(name.ss_family == AF_INET6 ? reinterpret_cast<sockaddr_in6&>(name).sin6_port
                                            : reinterpret_cast<sockaddr_in&>(name).sin_port);
}

/// A TCP port is free again as soon as its server ended; a UDP port is never shared.
bool isBound(const Descriptor& socket, const addrinfo& entry, SocketKind kind) {
    const int on = 1;
    const bool isStream = kind == SocketKind::Stream;
    if (isStream && ::setsockopt(socket.number(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) != 0) {
        return false;
    }
    return ::bind(socket.number(), entry.ai_addr, entry.ai_addrlen) == 0 &&
           (!isStream || ::listen(socket.number(), Backlog) == 0);
}

} // namespace

std::string NetworkAddress::text() const {
    return host.find(':') == std::string::npos ? fmt::format("{}:{}", host, port)
                                               : fmt::format("[{}]:{}", host, port);
}

Result<NetworkAddress> parseNetworkAddress(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    NetworkAddress address;
    address.host = text.substr(0, colon == std::string::npos ? 0 : colon);
    if (address.host.size() > 2 && address.host.front() == '[' && address.host.back() == ']') {
        address.host = address.host.substr(1, address.host.size() - 2);
    } else if (address.host.find(':') != std::string::npos) {
        address.host.clear();
    }
    const char* begin = colon == std::string::npos ? text.data() : text.data() + colon + 1;
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(begin, end, address.port);
    if (address.host.empty() || parsed.ec != std::errc{} || parsed.ptr != end) {
        return failure(ErrorCode::InvalidInput, fmt::format("'{}' is not HOST:PORT", text),
                       "write it like 127.0.0.1:5555 or [::1]:5555, port 0 to 65535");
    }
    return address;
}

Result<NetworkAddress> parseListenAddress(const std::string& text) {
    const std::string port = text.starts_with(':') ? text.substr(1) : text;
    const bool isPortAlone =
        !port.empty() && port.find(':') == std::string::npos &&
        std::all_of(port.begin(), port.end(), [](char c) { return c >= '0' && c <= '9'; });
    return parseNetworkAddress(isPortAlone ? "127.0.0.1:" + port : text);
}

std::string uriOf(const NetworkAddress& address, SocketKind kind) {
    return (kind == SocketKind::Stream ? "tcp:" : "udp:") + address.text();
}

Result<AddressList> resolve(const NetworkAddress& address, SocketKind kind, bool isPassive) {
    addrinfo hints{};
    hints.ai_family = AF_UNSPEC;
    hints.ai_socktype = kind == SocketKind::Stream ? SOCK_STREAM : SOCK_DGRAM;
    hints.ai_flags = isPassive ? AI_PASSIVE : 0;
    addrinfo* list = nullptr;
    const int code = getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &hints, &list);
    if (code != 0 || list == nullptr) {
        return failure(ErrorCode::DeviceLost, fmt::format("{}: {}", uriOf(address, kind), gai_strerror(code)),
                       "check that the device is on and the address is correct");
    }
    return AddressList(list);
}

Descriptor makeSocket(const addrinfo& entry) {
    return Descriptor(
        ::socket(entry.ai_family, entry.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, entry.ai_protocol));
}

Result<Descriptor> bindSocket(NetworkAddress& address, SocketKind kind) {
    const Result<AddressList> list = resolve(address, kind, true);
    if (!list) {
        return failure(list.error());
    }
    int error = 0;
    for (const addrinfo* entry = list->get(); entry != nullptr; entry = entry->ai_next) {
        Descriptor socket = makeSocket(*entry);
        if (socket.isOpen() && isBound(socket, *entry, kind)) {
            address.port = boundPort(socket);
            return socket;
        }
        error = errno;
    }
    return failure(ErrorCode::InvalidInput,
                   fmt::format("cannot listen on {}: {}", uriOf(address, kind), std::strerror(error)),
                   "give an address of this machine and a free port, or port 0");
}

bool isOpenToNetwork(const Descriptor& socket) {
    sockaddr_storage name{};
    socklen_t size = sizeof name;
    if (::getsockname(socket.number(), reinterpret_cast<sockaddr*>(&name), &size) != 0) {
        return true;
    }
    if (name.ss_family == AF_INET6) {
        const in6_addr& address = reinterpret_cast<const sockaddr_in6&>(name).sin6_addr;
        const bool isMappedLoopback = IN6_IS_ADDR_V4MAPPED(&address) && address.s6_addr[12] == IN_LOOPBACKNET;
        return !IN6_IS_ADDR_LOOPBACK(&address) && !isMappedLoopback;
    }
    return ntohl(reinterpret_cast<const sockaddr_in&>(name).sin_addr.s_addr) >> 24U != IN_LOOPBACKNET;
}

} // namespace halbench::devices
