#include "devices/transport/framed_transport.h"
#include "devices/transport/stream_codec.h"
#include "devices/transport/sxi_codec.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

using Octets = std::vector<std::uint8_t>;

/// What a test does to the port, and what the port saw.
struct PortScript {
    OctetInbox* inbox = nullptr; ///< of the open port
    Octets written;
    bool isBroken = false;
    int opened = 0;
    int closed = 0;
};

class ScriptedPort : public OctetPort {
public:
    explicit ScriptedPort(PortScript& script) : m_script(&script) {}

    Result<void> open(OctetInbox& inbox) override {
        ++m_script->opened;
        m_script->inbox = &inbox;
        return {};
    }
    void close() noexcept override { ++m_script->closed; }
    Result<void> write(std::span<const std::uint8_t> octets) override {
        if (m_script->isBroken) {
            return failure(ErrorCode::DeviceLost, "broken", "");
        }
        m_script->written.insert(m_script->written.end(), octets.begin(), octets.end());
        return {};
    }
    std::string description() const override { return "scripted"; }

private:
    PortScript* m_script;
};

FramedTransport transportOn(PortScript& script, std::vector<SxiProfile> profiles) {
    FramedTransport::Codecs codecs;
    for (const SxiProfile& profile : profiles) {
        codecs.push_back(std::make_unique<SxiCodec>(profile));
    }
    return FramedTransport(std::make_unique<ScriptedPort>(script), std::move(codecs), 2.5);
}

Octets frame(std::uint16_t counter, const Octets& packet) {
    Octets line;
    SxiCodec(SxiProfile{}).append(line, counter, packet);
    return line;
}

TEST(FramedTransport, sendsFramesAndCountsWhatTheLineLost) {
    PortScript script;
    FramedTransport transport = transportOn(script, {SxiProfile{}});
    EXPECT_DOUBLE_EQ(transport.connectPatience_s(), 2.5);
    ASSERT_TRUE(transport.open());
    ASSERT_TRUE(transport.send(Octets{0xFF, 0x00}));
    EXPECT_EQ(script.written, (Octets{0x9A, 0x02, 0x00, 0xFF, 0x00, 0x01, 0x01}));
    script.inbox->put(frame(250, {0xFF}));
    script.inbox->put(frame(250, {0xFF})); // twice: nothing is missing
    script.inbox->put(frame(4, {0xFF}));   // 251 to 255 and 0 to 3 are missing
    Octets damaged = frame(5, {0xFF, 0x12});
    damaged[3] ^= 0x01;
    script.inbox->put(damaged);
    Octets packet;
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(transport.receive(packet, 0.0).value());
    }
    EXPECT_FALSE(transport.receive(packet, 0.0).value());
    const TransportStatistics seen = transport.statistics();
    EXPECT_EQ(seen.packetsReceived, 3U);
    EXPECT_EQ(seen.packetsSent, 1U);
    EXPECT_EQ(seen.packetsLost, 9U);
    EXPECT_EQ(seen.packetsDamaged, 1U);
    EXPECT_GT(seen.octetsReceived, 20U);
}

TEST(FramedTransport, triesTheFirstFramingFiveTimesAndThenTheOthersInTurn) {
    PortScript script;
    const SxiProfile byteSum{SxiHeader::LenByte, SxiChecksum::Byte, true};
    const SxiProfile plain{SxiHeader::LenCtrWord, SxiChecksum::None, false};
    FramedTransport transport = transportOn(script, {SxiProfile{}, byteSum, plain});
    ASSERT_TRUE(transport.open());
    std::vector<std::size_t> lengths; // 7, 5 and 6 octets tell the framings apart
    for (int i = 0; i < 9; ++i) {
        script.written.clear();
        ASSERT_TRUE(transport.send(Octets{0xFF, 0x00}));
        lengths.push_back(script.written.size());
        transport.noteUnansweredConnect();
    }
    EXPECT_EQ(lengths, (std::vector<std::size_t>{7, 7, 7, 7, 7, 5, 6, 7, 7}));
}

TEST(FramedTransport, aLostPortIsClosedOnceAndCanBeOpenedAgain) {
    PortScript script;
    FramedTransport transport = transportOn(script, {SxiProfile{}});
    Octets packet;
    EXPECT_FALSE(transport.receive(packet, 0.0)) << "not open yet";
    ASSERT_TRUE(transport.open());
    script.inbox->put(frame(1, {0xFF}));
    script.inbox->fail({ErrorCode::DeviceLost, "unplugged", ""});
    EXPECT_TRUE(transport.receive(packet, 0.0).value()) << "what came before is delivered";
    const auto lost = transport.receive(packet, 0.0);
    ASSERT_FALSE(lost);
    EXPECT_EQ(lost.error().message, "unplugged");
    EXPECT_EQ(script.closed, 1);
    EXPECT_FALSE(transport.send(Octets{0xFF}));
    ASSERT_TRUE(transport.open());
    EXPECT_FALSE(transport.receive(packet, 0.0).value()) << "the old error is forgotten";
    script.isBroken = true;
    EXPECT_FALSE(transport.send(Octets{0xFF}));
    EXPECT_EQ(script.closed, 2);
}

TEST(FramedTransport, nonsenseOnAStreamEndsIt) {
    PortScript script;
    FramedTransport::Codecs codecs;
    codecs.push_back(std::make_unique<StreamCodec>());
    FramedTransport transport(std::make_unique<ScriptedPort>(script), std::move(codecs), 1.8);
    ASSERT_TRUE(transport.open());
    script.inbox->put(Octets{2, 0, 9, 0, 0xFF, 0x01});
    Octets packet;
    ASSERT_TRUE(transport.receive(packet, 0.0).value());
    EXPECT_EQ(packet, (Octets{0xFF, 0x01}));
    script.inbox->put(Octets{0, 0, 0, 0});
    const auto ended = transport.receive(packet, 0.0);
    ASSERT_FALSE(ended);
    EXPECT_EQ(ended.error().code, ErrorCode::Protocol);
    EXPECT_EQ(transport.statistics().packetsDamaged, 1U);
}

} // namespace
} // namespace halbench::devices
