#include "devices/open/open_device.h"
#include "devices/open/port_address.h"
#include "devices/transport/framed_transport.h"
#include "tests/devices/transport/pty_line.h"
#include "tests/devices/transport/served_board.h"

#include <gtest/gtest.h>

#include <thread>

namespace halbench::devices {
namespace {

/// "pty:/dev/pts/N" as the address of a client.
std::string serialUri(const BoardServer& server, const std::string& options = "") {
    return "serial:" + server.uri().substr(4) + options;
}

std::unique_ptr<Device> open(const std::string& uri) {
    Result<std::unique_ptr<Device>> device = openDevice(uri, {});
    if (!device) {
        ADD_FAILURE() << device.error().message;
        return nullptr;
    }
    return *std::move(device);
}

Result<SerialAddress> parsed(const std::string& text) {
    return parseSerialAddress(*parseDeviceUri(text));
}

void expectGainIsKept(Device& device) {
    const ParameterValue gain{"gain.kp", 12.5};
    ASSERT_TRUE(device.writeParameters({&gain, 1}));
    EXPECT_DOUBLE_EQ((*device.readParameters({&gain.name, 1}))[0], gain.value);
}

/// 0.3 s at 200 Hz.
Recording streamed(Device& device) {
    Recording recording;
    EXPECT_TRUE(device.startStream({{"position", "speed"}, 200.0},
                                   [&](const SampleBlockPtr& block) { recording.append(*block); }));
    EXPECT_TRUE(device.clock().waitFor(0.3));
    device.stopStream();
    return recording;
}

TEST(SerialDevice, worksLikeTheEmbeddedBoard) {
    const BoardServer server(ServedLine::Pty);
    const auto device = open(serialUri(server, "?baud=1000000"));
    ASSERT_TRUE(device);
    EXPECT_EQ(device->info().model, "htm");
    EXPECT_EQ(device->info().transport, "serial");
    EXPECT_FALSE(device->info().isSimulated) << "what is behind a line may move: it needs consent";
    expectGainIsKept(*device);
    const Recording recording = streamed(*device);
    EXPECT_EQ(recording.lostRows, 0U);
    EXPECT_EQ(device->statistics().packetsLost, 0U);
    EXPECT_EQ(device->statistics().packetsDamaged, 0U);
    ASSERT_GT(recording.rows(), 20U);
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        EXPECT_DOUBLE_EQ(recording.time_s[row], static_cast<double>(row) / 200.0);
    }
}

/// What tools without framing speak (resources/help/protocol.md 3.6), and a line of long headers.
const std::vector<std::pair<std::string, SxiProfile>> PlainLines = {
    {"?framing=off", {SxiHeader::LenCtrByte, SxiChecksum::Word, false}},
    {"?framing=off&header=len_ctr_word&checksum=none", {SxiHeader::LenCtrWord, SxiChecksum::None, false}},
    {"?framing=off&header=len_fill_word&checksum=byte", {SxiHeader::LenFillWord, SxiChecksum::Byte, false}}};

TEST(SerialDevice, worksWithABoardThatIsServedWithoutFraming) {
    for (const auto& [options, profile] : PlainLines) {
        SCOPED_TRACE(options);
        const BoardServer server(ServedLine::Pty, {}, profile);
        const auto device = open(serialUri(server, options));
        ASSERT_TRUE(device);
        EXPECT_EQ(device->info().model, "htm");
        expectGainIsKept(*device);
        const Recording recording = streamed(*device);
        device->stop();
        EXPECT_TRUE(device->state().isStopLatched);
        EXPECT_EQ(recording.lostRows, 0U);
        EXPECT_EQ(device->statistics().packetsDamaged, 0U);
        EXPECT_GT(recording.rows(), 20U);
    }
}

TEST(SerialDevice, findsOutByItselfThatABoardIsServedWithoutFraming) {
    const BoardServer server(ServedLine::Pty, {}, PlainLines[0].second);
    const auto device = open(serialUri(server));
    ASSERT_TRUE(device);
    EXPECT_TRUE(device->readSignals(std::vector<std::string>{"position"}));
}

TEST(SerialDevice, sendsAStopWhileStreamingAndSeesTheLatch) {
    const BoardServer server(ServedLine::Pty);
    const auto device = open(serialUri(server));
    ASSERT_TRUE(device);
    ASSERT_TRUE(device->startStream({{"position"}, 200.0}, [](const SampleBlockPtr&) {}));
    ASSERT_TRUE(device->arm());
    ASSERT_TRUE(device->clock().waitFor(0.05));
    device->stop();
    EXPECT_TRUE(device->state().isStopLatched);
}

TEST(SerialDevice, boardThatDiesIsADeviceLostWithinTwoSeconds) {
    BoardServer server(ServedLine::Pty);
    const auto device = open(serialUri(server));
    ASSERT_TRUE(device);
    ASSERT_TRUE(device->startStream({{"position"}, 100.0}, [](const SampleBlockPtr&) {}));
    server.end();
    const auto waited = device->clock().waitFor(5.0);
    ASSERT_FALSE(waited);
    EXPECT_EQ(waited.error().code, ErrorCode::DeviceLost);
    EXPECT_LT(device->clock().now_s(), 2.5) << "nobody waits longer than 2 s for a dead board";
    device->stop();
    device->stopStream();
}

TEST(SerialDevice, reopensTheSamePortAgainAndAgain) {
    const BoardServer server(ServedLine::Pty);
    for (int i = 0; i < 5; ++i) {
        const auto device = open(serialUri(server));
        ASSERT_TRUE(device);
        EXPECT_TRUE(device->readSignals(std::vector<std::string>{"position"}));
    }
}

TEST(SerialDevice, aLineWithAnotherProtocolIsNotCalledSilent) {
    PtyLine line;
    std::atomic<bool> hasEnded{false};
    std::thread chatter([&] {
        const std::string text = "$GPGGA,123519,4807.038,N*47\r\n";
        while (!hasEnded) {
            (void)line.taken(1);
            line.deliver({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
        }
    });
    const auto device = openDevice("serial:" + line.path(), {});
    hasEnded = true;
    chatter.join();
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().code, ErrorCode::Protocol);
    EXPECT_NE(device.error().message.find("not in this protocol"), std::string::npos)
        << device.error().message;
}

TEST(SerialDevice, aSilentLineIsADeviceLost) {
    PtyLine line;
    const auto device = openDevice("serial:" + line.path(), {});
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().code, ErrorCode::DeviceLost);
    EXPECT_NE(device.error().message.find("does not answer"), std::string::npos);
}

/// Answers CONNECT in one framing only, as often as it comes.
void answerConnects(PtyLine& line, const SxiProfile& profile, const std::atomic<bool>& hasEnded) {
    SxiCodec codec(profile);
    while (!hasEnded) {
        const auto command = line.taken(1);
        codec.noteSilence(); // what came in another framing
        codec.feed(command);
        const auto frame = codec.next();
        if (frame && *frame && (*frame)->packet[0] == 0xFF) {
            std::vector<std::uint8_t> answer;
            codec.append(answer, 7,
                         std::vector<std::uint8_t>{0xFF, 0x05, 0x00, 0x20, 0x20, 0x00, 0x01, 0x01});
            line.deliver(answer);
        }
    }
}

TEST(SerialDevice, findsTheFramingOfTheBoard) {
    const auto address = parsed("serial:x");
    ASSERT_TRUE(address);
    ASSERT_EQ(address->profiles.size(), 4U);
    for (const SxiProfile& profile : address->profiles) {
        SCOPED_TRACE(describe(profile));
        PtyLine line;
        std::atomic<bool> hasEnded{false};
        std::thread board([&] { answerConnects(line, profile, hasEnded); });
        const auto transport = makeSerialTransport(*parseDeviceUri("serial:" + line.path()));
        ASSERT_TRUE(transport);
        ASSERT_TRUE((*transport)->open());
        bool hasAnswered = false;
        const std::vector<std::uint8_t> connect{0xFF, 0x00};
        constexpr int MostTries = 400; // a busy machine may answer after its turn
        for (int i = 0; i < MostTries && !hasAnswered; ++i) {
            ASSERT_TRUE((*transport)->send(connect));
            std::vector<std::uint8_t> packet;
            hasAnswered = (*transport)->receive(packet, 0.1).value_or(false) && packet[0] == 0xFF;
            if (!hasAnswered) {
                (*transport)->noteUnansweredConnect();
            }
        }
        hasEnded = true;
        EXPECT_TRUE((*transport)->send(connect)); // the board is waiting for one
        board.join();
        EXPECT_TRUE(hasAnswered);
    }
}

TEST(SerialAddress, readsEveryOption) {
    const auto address =
        parsed("serial:/dev/ttyUSB0?baud=250000&dtr=off&low_latency=off&framing=off&header=len_word"
               "&checksum=byte&sync=AA&escape=ab");
    ASSERT_TRUE(address) << address.error().message;
    EXPECT_EQ(address->settings.device, "/dev/ttyUSB0");
    EXPECT_EQ(address->settings.baud, 250000);
    EXPECT_EQ(address->settings.isDtrOn, std::optional<bool>(false));
    EXPECT_FALSE(address->settings.isLowLatency);
    const SxiProfile expected{SxiHeader::LenWord, SxiChecksum::Byte, false, 0xAA, 0xAB};
    EXPECT_EQ(address->profiles, std::vector{expected});
}

TEST(SerialAddress, refusesWhatItDoesNotKnowAndSaysWhatItDoes) {
    const std::vector<std::pair<std::string, std::string>> wrong = {{"speed=9600", "known are baud"},
                                                                    {"baud=9600x", "whole number"},
                                                                    {"baud=10", "300"},
                                                                    {"dtr=yes", "off, on"},
                                                                    {"header=byte", "len_ctr_byte"},
                                                                    {"checksum=crc", "none, byte, word"},
                                                                    {"sync=XY", "hexadecimal"},
                                                                    {"sync=100", "hexadecimal"},
                                                                    {"sync=9B", "two different"}};
    for (const auto& [option, hint] : wrong) {
        const auto address = parsed("serial:/dev/ttyUSB0?" + option);
        ASSERT_FALSE(address) << option;
        EXPECT_NE(address.error().hint.find(hint), std::string::npos)
            << option << ": " << address.error().hint;
    }
}

} // namespace
} // namespace halbench::devices
