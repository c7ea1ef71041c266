#include "devices/open/port_address.h"
#include "devices/transport/stream_codec.h"
#include "devices/transport/sxi_codec.h"
#include "devices/transport/tcp_socket.h"
#include "devices/transport/tcp_transport.h"
#include "devices/transport/udp_transport.h"
#include "tests/conformance/transport/far_end.h"
#include "tests/devices/transport/pty_line.h"

#include <sys/socket.h>

#include <mutex>
#include <optional>

namespace halbench::devices {
namespace {

/// A pseudo terminal behind a link that stays while it comes and goes, as /dev/serial/by-id does.
class SerialEnd : public FarEnd {
public:
    SerialEnd() : m_link(::testing::TempDir() + "line-" + std::to_string(::getpid())) { plug(); }
    ~SerialEnd() override { ::unlink(m_link.c_str()); }
    SerialEnd(const SerialEnd&) = delete;
    SerialEnd& operator=(const SerialEnd&) = delete;

    LineTraits traits() const override {
        LineTraits traits;
        traits.hasChecksum = true;
        traits.isExclusive = true;
        traits.counterMask = 0xFF;
        return traits;
    }
    std::unique_ptr<Transport> makeTransport() override {
        auto transport =
            makeSerialTransport(*parseDeviceUri("serial:" + m_link + "?header=len_ctr_byte&checksum=word"));
        EXPECT_TRUE(transport);
        return *std::move(transport);
    }
    std::unique_ptr<FrameCodec> makeCodec() const override {
        return std::make_unique<SxiCodec>(SxiProfile{});
    }
    void deliver(const Octets& octets) override { m_line->deliver(octets); }
    Octets taken() override { return m_line->taken(1); }
    void setStalled(bool) override {} // nobody reads the line unless taken() does
    void unplug() override { m_line->unplug(); }
    void plug() override {
        m_line.emplace();
        ::unlink(m_link.c_str());
        EXPECT_EQ(::symlink(m_line->path().c_str(), m_link.c_str()), 0);
    }

private:
    std::string m_link;
    std::optional<PtyLine> m_line;
};

/// Octets that are there within the time; empty when none are.
Octets readSome(const Descriptor& socket) {
    Octets octets(65536);
    const bool isThere = socket.isOpen() && socket.isReadableWithin(Patience_s);
    const ssize_t count = isThere ? ::recv(socket.number(), octets.data(), octets.size(), 0) : 0;
    octets.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return octets;
}

class TcpEnd : public FarEnd {
public:
    TcpEnd() { plug(); }

    LineTraits traits() const override { return {}; }
    std::unique_ptr<Transport> makeTransport() override { return std::make_unique<TcpTransport>(m_address); }
    std::unique_ptr<FrameCodec> makeCodec() const override { return std::make_unique<StreamCodec>(); }
    void deliver(const Octets& octets) override {
        const std::lock_guard lock(m_mutex);
        (void)::send(m_master.number(), octets.data(), octets.size(), MSG_NOSIGNAL);
    }
    Octets taken() override {
        accept();
        return readSome(m_master);
    }
    void setStalled(bool) override {} // nobody reads unless taken() does
    void unplug() override {
        const std::lock_guard lock(m_mutex);
        m_listener.close();
        m_master.close();
    }
    void plug() override {
        auto listener = bindSocket(m_address, SocketKind::Stream);
        ASSERT_TRUE(listener) << listener.error().message;
        m_listener = *std::move(listener);
    }

private:
    /// The newest connection is the line.
    void accept() {
        const std::lock_guard lock(m_mutex);
        for (Descriptor next = acceptTcp(m_listener); next.isOpen(); next = acceptTcp(m_listener)) {
            m_master = std::move(next);
        }
    }

    std::mutex m_mutex;
    NetworkAddress m_address{"127.0.0.1", 0};
    Descriptor m_listener;
    Descriptor m_master;
};

class UdpEnd : public FarEnd {
public:
    UdpEnd() { plug(); }

    LineTraits traits() const override {
        LineTraits traits;
        traits.isDatagram = true;
        traits.tellsUnplugByItself = false;
        return traits;
    }
    std::unique_ptr<Transport> makeTransport() override { return std::make_unique<UdpTransport>(m_address); }
    std::unique_ptr<FrameCodec> makeCodec() const override { return std::make_unique<StreamCodec>(); }
    void deliver(const Octets& octets) override {
        const std::lock_guard lock(m_mutex);
        (void)::sendto(m_socket.number(), octets.data(), octets.size(), MSG_NOSIGNAL,
                       reinterpret_cast<const sockaddr*>(&m_master), m_masterSize);
    }
    Octets taken() override {
        Octets octets(65536);
        sockaddr_storage master{};
        socklen_t size = sizeof master;
        const bool isThere = m_socket.isReadableWithin(Patience_s);
        const ssize_t count = isThere ? ::recvfrom(m_socket.number(), octets.data(), octets.size(), 0,
                                                   reinterpret_cast<sockaddr*>(&master), &size)
                                      : 0;
        octets.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
        const std::lock_guard lock(m_mutex);
        m_master = master;
        m_masterSize = size;
        return octets;
    }
    void setStalled(bool) override {}
    void unplug() override { m_socket.close(); }
    void plug() override {
        auto socket = bindSocket(m_address, SocketKind::Datagram);
        ASSERT_TRUE(socket) << socket.error().message;
        m_socket = *std::move(socket);
    }

private:
    std::mutex m_mutex;
    NetworkAddress m_address{"127.0.0.1", 0};
    Descriptor m_socket;
    sockaddr_storage m_master{};
    socklen_t m_masterSize = 0;
};

const LineKind Serial{"serial", [] { return std::make_unique<SerialEnd>(); }};
const LineKind Tcp{"tcp", [] { return std::make_unique<TcpEnd>(); }};
const LineKind Udp{"udp", [] { return std::make_unique<UdpEnd>(); }};

INSTANTIATE_TEST_SUITE_P(Lines, TransportConformance, testing::Values(Serial, Tcp, Udp), lineName);
INSTANTIATE_TEST_SUITE_P(Lines, StreamConformance, testing::Values(Serial, Tcp), lineName);
INSTANTIATE_TEST_SUITE_P(Lines, DatagramConformance, testing::Values(Udp), lineName);
INSTANTIATE_TEST_SUITE_P(Lines, UncheckedStreamConformance, testing::Values(Tcp), lineName);
INSTANTIATE_TEST_SUITE_P(Lines, StallConformance, testing::Values(Serial, Tcp), lineName);

} // namespace
} // namespace halbench::devices
