#include "devices/transport/tcp_socket.h"

#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>

namespace halbench::devices {

namespace {

void sendAtOnce(const Descriptor& socket) {
    const int on = 1;
    (void)::setsockopt(socket.number(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

/// errno of a connect() under way once it is decided; ETIMEDOUT when it takes too long.
int awaitConnected(const Descriptor& socket, double timeout_s) {
    pollfd entry{socket.number(), POLLOUT, 0};
    const int ready = ::poll(&entry, 1, static_cast<int>(timeout_s * 1000.0));
    if (ready <= 0) {
        return ready == 0 ? ETIMEDOUT : errno;
    }
    int error = 0;
    socklen_t size = sizeof error;
    return ::getsockopt(socket.number(), SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

} // namespace

Result<Descriptor> connectTcp(const NetworkAddress& address, double timeout_s) {
    const Result<AddressList> list = resolve(address, SocketKind::Stream, false);
    if (!list) {
        return failure(list.error());
    }
    int error = 0;
    for (const addrinfo* entry = list->get(); entry != nullptr; entry = entry->ai_next) {
        Descriptor socket = makeSocket(*entry);
        if (!socket.isOpen()) {
            error = errno;
            continue;
        }
        error = ::connect(socket.number(), entry->ai_addr, entry->ai_addrlen) == 0 ? 0 : errno;
        if (error == EINPROGRESS || error == EINTR) {
            error = awaitConnected(socket, timeout_s);
        }
        if (error == 0) {
            sendAtOnce(socket);
            return socket;
        }
    }
    return failure(ErrorCode::DeviceLost,
                   fmt::format("{}: {}", uriOf(address, SocketKind::Stream), std::strerror(error)),
                   "check that the device is on and the address is correct");
}

Descriptor acceptTcp(const Descriptor& listener) {
    Descriptor socket(::accept4(listener.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (socket.isOpen()) {
        sendAtOnce(socket);
    }
    return socket;
}

} // namespace halbench::devices
