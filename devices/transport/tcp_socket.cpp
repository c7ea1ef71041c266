#include "devices/transport/tcp_socket.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <memory>

namespace halbench::devices {

namespace {

constexpr int Backlog = 4;

struct AddressListDeleter {
    void operator()(addrinfo* list) const { freeaddrinfo(list); }
};
using AddressList = std::unique_ptr<addrinfo, AddressListDeleter>;

tl::unexpected<Error> lost(const TcpAddress& address, const std::string& what) {
    return failure(ErrorCode::DeviceLost, fmt::format("tcp:{}: {}", address.text(), what),
                   "check that the board is on and the address is right");
}

Result<AddressList> resolve(const TcpAddress& address, bool isPassive) {
    addrinfo hints{};
    hints.ai_family = AF_UNSPEC;
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = isPassive ? AI_PASSIVE : 0;
    addrinfo* list = nullptr;
    const int code = getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &hints, &list);
    if (code != 0 || list == nullptr) {
        return lost(address, gai_strerror(code));
    }
    return AddressList(list);
}

TcpSocket makeSocket(const addrinfo& entry) {
    return TcpSocket(
        ::socket(entry.ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, entry.ai_protocol));
}

void sendAtOnce(const TcpSocket& socket) {
    const int on = 1;
    (void)::setsockopt(socket.descriptor(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

/// errno of a connect() under way once it is decided; ETIMEDOUT when it takes too long.
int awaitConnected(const TcpSocket& socket, double timeout_s) {
    pollfd entry{socket.descriptor(), POLLOUT, 0};
    const int ready = ::poll(&entry, 1, static_cast<int>(timeout_s * 1000.0));
    if (ready <= 0) {
        return ready == 0 ? ETIMEDOUT : errno;
    }
    int error = 0;
    socklen_t size = sizeof error;
    return ::getsockopt(socket.descriptor(), SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

std::uint16_t boundPort(const TcpSocket& socket) {
    sockaddr_storage name{};
    socklen_t size = sizeof name;
    if (::getsockname(socket.descriptor(), reinterpret_cast<sockaddr*>(&name), &size) != 0) {
        return 0;
    }
    return ntohs(name.ss_family == AF_INET6 ? reinterpret_cast<sockaddr_in6&>(name).sin6_port
                                            : reinterpret_cast<sockaddr_in&>(name).sin_port);
}

} // namespace

TcpSocket& TcpSocket::operator=(TcpSocket&& other) noexcept {
    close();
    m_descriptor = std::exchange(other.m_descriptor, -1);
    return *this;
}

void TcpSocket::close() noexcept {
    if (m_descriptor >= 0) {
        ::close(m_descriptor);
        m_descriptor = -1;
    }
}

std::string TcpAddress::text() const {
    return host.find(':') == std::string::npos ? fmt::format("{}:{}", host, port)
                                               : fmt::format("[{}]:{}", host, port);
}

Result<TcpAddress> parseTcpAddress(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    TcpAddress address;
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

Result<TcpSocket> connectTcp(const TcpAddress& address, double timeout_s) {
    const Result<AddressList> list = resolve(address, false);
    if (!list) {
        return failure(list.error());
    }
    int error = 0;
    for (const addrinfo* entry = list->get(); entry != nullptr; entry = entry->ai_next) {
        TcpSocket socket = makeSocket(*entry);
        if (!socket.isOpen()) {
            error = errno;
            continue;
        }
        error = ::connect(socket.descriptor(), entry->ai_addr, entry->ai_addrlen) == 0 ? 0 : errno;
        if (error == EINPROGRESS || error == EINTR) {
            error = awaitConnected(socket, timeout_s);
        }
        if (error == 0) {
            sendAtOnce(socket);
            return socket;
        }
    }
    return lost(address, std::strerror(error));
}

Result<TcpSocket> listenTcp(TcpAddress& address) {
    const Result<AddressList> list = resolve(address, true);
    if (!list) {
        return failure(list.error());
    }
    int error = 0;
    for (const addrinfo* entry = list->get(); entry != nullptr; entry = entry->ai_next) {
        TcpSocket socket = makeSocket(*entry);
        const int on = 1;
        if (socket.isOpen() &&
            ::setsockopt(socket.descriptor(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) == 0 &&
            ::bind(socket.descriptor(), entry->ai_addr, entry->ai_addrlen) == 0 &&
            ::listen(socket.descriptor(), Backlog) == 0) {
            address.port = boundPort(socket);
            return socket;
        }
        error = errno;
    }
    return failure(ErrorCode::InvalidInput,
                   fmt::format("cannot listen on tcp:{}: {}", address.text(), std::strerror(error)),
                   "give an address of this machine and a free port, or port 0");
}

TcpSocket acceptTcp(const TcpSocket& listener) {
    TcpSocket socket(::accept4(listener.descriptor(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (socket.isOpen()) {
        sendAtOnce(socket);
    }
    return socket;
}

} // namespace halbench::devices
