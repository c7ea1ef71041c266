#include "devices/device_uri.h"
#include "devices/open/port_address.h"
#include "tests/devices/firmware/avr/avr_fixture.h"
#include "tests/devices/firmware/avr/simavr/served_avr_board.h"
#include "tests/devices/firmware/line/board_time_port.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <thread>

namespace halbench::simavr {
namespace {

/// The board on a pseudo terminal, served in a thread.
class AvrSerial : public testing::Test {
protected:
    void SetUp() override {
        m_board = makeBoard(perfectMotor());
        auto line = firmware::BoardLine::open(std::make_shared<ServedAvrBoard>(m_board));
        ASSERT_TRUE(line) << line.error().message;
        m_line = std::move(*line);
        m_server = std::thread([this] { m_line->serve(m_isEnding); });
    }
    void TearDown() override {
        m_isEnding = 1;
        if (m_server.joinable()) {
            m_server.join();
        }
    }
    std::unique_ptr<devices::Device> open() {
        const auto uri = devices::parseDeviceUri("serial:" + m_line->path());
        auto port = devices::makeSerialTransport(*uri);
        EXPECT_TRUE(port) << port.error().message;
        devices::XcpDeviceOptions options;
        options.identity.uri = uri->text;
        options.identity.transport = uri->scheme;
        auto device = devices::openXcpDevice(
            std::make_unique<firmware::BoardTimePort>(*std::move(port), *m_line), options);
        EXPECT_TRUE(device) << device.error().message << " " << device.error().hint;
        return device ? std::move(*device) : nullptr;
    }
    static double read(devices::Device& device, const std::string& name) {
        const std::string names[] = {name};
        const auto values = device.readParameters(names);
        EXPECT_TRUE(values);
        return values ? values->front() : 0.0;
    }
    static void write(devices::Device& device, const std::string& name, double value) {
        const ParameterValue change[] = {{name, value}};
        const auto written = device.writeParameters(change);
        EXPECT_TRUE(written) << written.error().message;
    }

    std::shared_ptr<AvrBoard> m_board;
    std::unique_ptr<firmware::BoardLine> m_line;
    std::atomic<int> m_isEnding{0};
    std::thread m_server;
};

TEST_F(AvrSerial, theProgramOpensTheBoardLikeASerialPortAndOpeningAgainResetsIt) {
    {
        const auto device = open();
        ASSERT_TRUE(device);
        EXPECT_EQ(device->info().model, "htm");
        write(*device, "gain.kp", 12.5);
        EXPECT_EQ(read(*device, "gain.kp"), 12.5);
        write(*device, "hb.mode", static_cast<double>(devices::BoardMode::Current));
        ASSERT_TRUE(device->arm());
        write(*device, "hb.setpoint", 2.0);
        ASSERT_TRUE(device->clock().waitFor(0.3));
        const std::string names[] = {"speed"};
        EXPECT_GT(device->readSignals(names).value().front(), 0.5);
        ASSERT_TRUE(device->disarm());
        EXPECT_EQ(device->statistics().packetsDamaged, 0U);
    }
    while (m_line->isOpened()) { // a busy machine may look after it was opened again: then nothing was closed
        std::this_thread::yield();
    }
    const auto again = open();
    ASSERT_TRUE(again);
    EXPECT_EQ(read(*again, "gain.kp"), 10.0);
}

/// Virtual time of connecting, the board's start included.
double connecting_s(const std::string& cacheFolder) {
    devices::XcpDeviceOptions options;
    options.cacheFolder = cacheFolder;
    const auto device =
        devices::openXcpDevice(std::make_unique<AvrTransport>(makeBoard(perfectMotor())), std::move(options));
    EXPECT_TRUE(device) << device.error().message;
    return device ? (*device)->clock().now_s() : 0.0;
}

TEST(AvrConnecting, readsTheDescriptionOnceAndThenTakesItFromTheCache) {
    const std::string folder = testing::TempDir() + "avr-cache-" + std::to_string(::getpid());
    const double first_s = connecting_s(folder);
    const double again_s = connecting_s(folder);
    std::filesystem::remove_all(folder);
    // 16 kB of text: 1.7 s on the line at 115200 baud, the rest is the processor that renders it beside its
    // control loop.
    EXPECT_GT(first_s, 1.7);
    EXPECT_LT(first_s, 6.0);
    EXPECT_LT(again_s, 1.0) << "identity, state and values alone";
}

} // namespace
} // namespace halbench::simavr
