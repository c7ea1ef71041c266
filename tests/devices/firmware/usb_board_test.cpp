#include "devices/firmware/examples/usb_board.h"
#include "tests/devices/firmware/board_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halbench::devices::firmware {
namespace {

/// The host's side of both endpoints.
struct Host {
    Octets toBoard, fromBoard;
    std::size_t readAtOnce = 64;
    bool isInBusy = false;
    float current_A = 0.0F;

    static std::uint16_t receive(void* context, std::uint8_t* octets, std::uint16_t capacity) {
        auto& host = *static_cast<Host*>(context);
        const std::size_t count = std::min({host.readAtOnce, host.toBoard.size(), std::size_t{capacity}});
        std::copy_n(host.toBoard.begin(), count, octets);
        host.toBoard.erase(host.toBoard.begin(), host.toBoard.begin() + static_cast<std::ptrdiff_t>(count));
        return static_cast<std::uint16_t>(count);
    }
    static std::uint8_t send(void* context, const std::uint8_t* octets, std::uint16_t count) {
        auto& host = *static_cast<Host*>(context);
        if (host.isInBusy) {
            return 0;
        }
        host.fromBoard.insert(host.fromBoard.end(), octets, octets + count);
        return 1;
    }
    static float position_rad(void*) { return 0.25F; }
    static void drive_A(void* context, float current_A) {
        static_cast<Host*>(context)->current_A = current_A;
    }
};

class UsbBoard : public testing::Test {
protected:
    UsbBoard() {
        const usb_port port{&Host::receive, &Host::send, &Host::position_rad, &Host::drive_A, &m_host};
        usb_board_init(m_board.get(), &port);
    }
    void say(const Octets& packet) {
        std::uint8_t header[HB_STREAM_HEADER];
        hb_stream_header(header, static_cast<std::uint16_t>(packet.size()), m_counter++);
        m_host.toBoard.insert(m_host.toBoard.end(), header, header + HB_STREAM_HEADER);
        m_host.toBoard.insert(m_host.toBoard.end(), packet.begin(), packet.end());
    }
    Octets answerTo(const Octets& packet) {
        m_host.fromBoard.clear();
        say(packet);
        while (!m_host.toBoard.empty()) {
            usb_board_poll(m_board.get());
        }
        usb_board_poll(m_board.get());
        if (m_host.fromBoard.size() < HB_STREAM_HEADER) {
            return {};
        }
        EXPECT_EQ(m_host.fromBoard[0] + HB_STREAM_HEADER, static_cast<int>(m_host.fromBoard.size()));
        return {m_host.fromBoard.begin() + HB_STREAM_HEADER, m_host.fromBoard.end()};
    }

    Host m_host;
    std::uint16_t m_counter = 0;
    std::unique_ptr<usb_board> m_board = std::make_unique<usb_board>();
};

TEST_F(UsbBoard, answersHoweverTheTransfersAreCut) {
    for (const std::size_t piece : {1U, 3U, 64U}) {
        m_host.readAtOnce = piece;
        EXPECT_EQ(answerTo({0xFF, 0x00})[0], 0xFF) << piece;
        EXPECT_EQ(answerTo({0xFD})[0], 0xFF) << piece;
    }
}

TEST_F(UsbBoard, twoCommandsInOneTransferAreAnsweredInOne) {
    say({0xFF, 0x00});
    say({0xFD});
    usb_board_poll(m_board.get());
    // CONNECT answers 8 octets, GET_STATUS 6
    EXPECT_EQ(m_host.fromBoard.size(), 2U * HB_STREAM_HEADER + 8U + 6U);
}

TEST_F(UsbBoard, keepsAnswersWhileTheHostDoesNotCollectThem) {
    m_host.isInBusy = true;
    say({0xFF, 0x00});
    usb_board_poll(m_board.get());
    say({0xFD});
    usb_board_poll(m_board.get());
    EXPECT_TRUE(m_host.fromBoard.empty());
    m_host.isInBusy = false;
    usb_board_poll(m_board.get());
    EXPECT_EQ(m_host.fromBoard.size(), 2U * HB_STREAM_HEADER + 8U + 6U);
}

TEST_F(UsbBoard, findsTheNextCommandBehindANonsenseLength) {
    EXPECT_EQ(answerTo({0xFF, 0x00})[0], 0xFF);
    m_host.toBoard = {0xFF, 0xFF, 0x00, 0x00, 0x00}; // LEN 65535, 255, 0 and so on
    while (!m_host.toBoard.empty()) {
        usb_board_poll(m_board.get());
    }
    usb_board_connected(m_board.get()); // what a clear-halt or a new configuration does
    EXPECT_EQ(answerTo({0xFD})[0], 0xFF);
}

TEST_F(UsbBoard, theTickSensesAndDrives) {
    EXPECT_EQ(answerTo({0xFF, 0x00})[0], 0xFF);
    const auto write = [this](std::size_t offset, std::uint8_t value) {
        return answerTo({0xED, 1, 0, 0, static_cast<std::uint8_t>(offset), 0x80, 0, 0, value});
    };
    EXPECT_EQ(write(offsetof(minimal_live, mode), 2), (Octets{0xFF}));
    EXPECT_EQ(write(offsetof(minimal_live, arm), 1), (Octets{0xFF}));
    usb_board_tick(m_board.get());
    EXPECT_EQ(m_host.current_A, -0.25F); // gain 1 A/rad, set-point 0
    EXPECT_EQ(answerTo({0xF1, 0x45})[0], 0xFF);
    usb_board_tick(m_board.get());
    EXPECT_EQ(m_host.current_A, 0.0F);
}

} // namespace
} // namespace halbench::devices::firmware
