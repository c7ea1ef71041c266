#include "devices/device_uri.h"
#include "devices/open/port_address.h"
#include "tests/devices/firmware/line/board_time_port.h"
#include "tests/devices/firmware/mps2/emulator/served_mps2_board.h"
#include "tests/devices/firmware/mps2/planar_bench.h"

#include <thread>

namespace halbench::mps2 {
namespace {

/// The board on a pseudo terminal, served in a thread.
class Mps2PlanarSerial : public testing::Test {
protected:
    void SetUp() override {
        auto board = Mps2Board::make(boardProgram("planar"), platenPlant(), PlanarLine);
        ASSERT_TRUE(board) << board.error().message;
        auto line = firmware::BoardLine::open(
            std::make_shared<ServedMps2Board>(std::shared_ptr<Mps2Board>(std::move(*board))));
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
    Bench open() {
        const auto uri = devices::parseDeviceUri("serial:" + m_line->path());
        auto port = devices::makeSerialTransport(*uri);
        EXPECT_TRUE(port) << port.error().message;
        return port ? connect(std::make_unique<firmware::BoardTimePort>(*std::move(port), *m_line), nullptr)
                    : Bench{};
    }

    std::unique_ptr<firmware::BoardLine> m_line;
    std::atomic<int> m_isEnding{0};
    std::thread m_server;
};

TEST_F(Mps2PlanarSerial, theProgramOpensItLikeASerialPortHomesMovesAndStopsIt) {
    Bench bench = open();
    ASSERT_TRUE(bench.device);
    EXPECT_EQ(bench.device->info().model, "planar");
    bench.write({{"hb.home", 1.0}});
    bench.wait(0.02);
    EXPECT_EQ(bench.signal("homed"), 1.0);
    bench.write({{"hb.mode", static_cast<double>(HB_PLANAR_POSITION)}});
    ASSERT_TRUE(bench.device->arm());
    bench.wait(0.01);
    const double start_m = bench.signal("reference.x"); // without current it glides until it is armed
    bench.write({{"reference.x.shape", static_cast<double>(HB_PLANAR_TRAPEZOID)},
                 {"reference.x.amplitude", 1e-3},
                 {"reference.x.rate", 0.02},
                 {"reference.x.acceleration", 1.0},
                 {"reference.start", 1.0}});
    bench.wait(0.5); // the travel takes 0.07 s
    // The noise of a pose is some micrometres; the loop's integral is still taking up the cable's force.
    EXPECT_NEAR(bench.signal("position.x") - start_m, 1e-3, 1e-4);
    bench.device->stop();
    const double rest_s = m_line->boardTime_s() + 0.35; // braking takes 0.3 s at most
    while (m_line->boardTime_s() < rest_s) {
        (void)bench.signal("status");
    }
    for (const char* coil : {"current.coil1", "current.coil2", "current.coil5", "current.coil6"}) {
        EXPECT_EQ(bench.signal(coil), 0.0) << coil;
    }
    EXPECT_FALSE(bench.device->arm()) << "a stop is latched";
    EXPECT_EQ(bench.device->statistics().packetsDamaged, 0U);
    EXPECT_EQ(bench.device->statistics().packetsLost, 0U);
}

} // namespace
} // namespace halbench::mps2
