// The board's set-up of its capture on every way out. Of a board that lives on: a simulated one is new each
// time.
#include "app/workbench/signals/loop_capture.h"
#include "devices/transport/tcp_server.h"
#include "tests/app/session/unplug_cycles.h"

namespace halbench::app {
namespace {

class LoopCaptureTest : public testing::Test {
protected:
    static constexpr int Patience_ms = 120000;
    static constexpr double Own = 3.0; ///< of the board before anything is captured

    void SetUp() override {
        board.emplace([this]() -> std::unique_ptr<devices::ServerPort> {
            auto server = devices::TcpServer::listen(address);
            EXPECT_TRUE(server) << server.error().message;
            uri = server->address();
            address = *devices::parseNetworkAddress(uri.substr(4));
            return std::make_unique<devices::TcpServer>(*std::move(server));
        });
        connectBoard();
        write("capture.prescaler", Own);
        wait([this] { return value("capture.prescaler") == Own; });
    }
    void TearDown() override { disconnectBoard(); }

    void connectBoard() {
        session.setReturnTimes({0.02, 1.5, 0.1, 0.0, 3});
        session.connectDevice(QString::fromStdString(uri), {1.0});
        ASSERT_TRUE(wait([&] { return session.state() == SessionState::Connected; }));
    }
    void disconnectBoard() {
        session.disconnectDevice();
        ASSERT_TRUE(wait([&] { return session.state() == SessionState::Disconnected; }));
    }
    /// For a level that never comes.
    void awaitForEver(LoopCapture& capture) {
        CaptureConfig config;
        config.signals = {"hall.a"};
        config.rate_Hz = 500.0;
        config.trigger = {CaptureTrigger::Kind::Level, "hall.a", 1.0, true};
        capture.start(config);
        ASSERT_TRUE(wait([&] { return capture.state() == LoopCapture::State::Waiting; }));
    }
    void write(const std::string& name, double number) {
        bool isDone = false;
        session.request(
            [=](devices::Device& device) {
                const ParameterValue value{name, number};
                return device.writeParameters({&value, 1});
            },
            [&](const Result<void>& done) { isDone = done.has_value(); });
        ASSERT_TRUE(wait([&] { return isDone; }));
    }
    double value(const std::string& name) {
        std::optional<double> found;
        session.request(
            [name](devices::Device& device) {
                return device.readParameters({&name, 1});
            },
            [&](const Result<std::vector<double>>& read) { found = read ? read->front() : -1.0; });
        EXPECT_TRUE(wait([&] { return found.has_value(); }));
        return found.value_or(-1.0);
    }
    template <typename Condition>
    static bool wait(Condition condition) {
        return QTest::qWaitFor(condition, Patience_ms);
    }

    int argumentCount = 1;
    char program[5] = "test";
    char* arguments[2] = {program, nullptr};
    QCoreApplication application{argumentCount, arguments};
    devices::NetworkAddress address{"127.0.0.1", 0}; ///< the first time any port, then the same
    std::string uri;
    std::optional<PluggableBoard> board;
    DeviceSession session;
};

TEST_F(LoopCaptureTest, aDisconnectWhileItWaitsPutsTheBoardsSetUpBack) {
    LoopCapture capture(session);
    awaitForEver(capture);
    EXPECT_EQ(value("capture.prescaler"), 2.0);
    disconnectBoard();
    capture.stop(); // as the Monitor does with its device
    connectBoard();
    EXPECT_EQ(value("capture.prescaler"), Own);
    EXPECT_EQ(value("capture.signal_1"), 255.0);
    EXPECT_EQ(value("capture.start"), 0.0);
}

/// The board kept the capture's set-up; what is put back is what there was before the loss, not before the
/// second start.
TEST_F(LoopCaptureTest, whatWasLostOverItIsPutBackAfterTheReturn) {
    LoopCapture capture(session);
    awaitForEver(capture);
    board->setPlugged(false);
    ASSERT_TRUE(wait([&] { return session.state() == SessionState::Reconnecting; }));
    board->setPlugged(true);
    ASSERT_TRUE(wait([&] { return capture.state() == LoopCapture::State::Waiting; }));
    EXPECT_EQ(value("capture.prescaler"), 2.0);
    capture.stop();
    EXPECT_TRUE(wait([&] { return value("capture.prescaler") == Own; }));
    EXPECT_EQ(value("capture.signal_1"), 255.0);
}

TEST_F(LoopCaptureTest, whatWasEndedWhileTheBoardWasAwayIsPutBackOnceItIsThere) {
    LoopCapture capture(session);
    awaitForEver(capture);
    board->setPlugged(false);
    ASSERT_TRUE(wait([&] { return session.state() == SessionState::Reconnecting; }));
    capture.stop();
    board->setPlugged(true);
    ASSERT_TRUE(wait([&] { return session.state() == SessionState::Connected; }));
    EXPECT_TRUE(wait([&] { return value("capture.prescaler") == Own; }));
}

/// It is not ours to put back any more.
TEST_F(LoopCaptureTest, whatSomebodyElseSetMeanwhileStays) {
    LoopCapture capture(session);
    awaitForEver(capture);
    write("capture.prescaler", 7.0);
    capture.stop();
    disconnectBoard();
    connectBoard();
    EXPECT_EQ(value("capture.prescaler"), 7.0);
    EXPECT_EQ(value("capture.signal_1"), 255.0) << "the rest was ours";
}

TEST_F(LoopCaptureTest, aDeviceThatIsGivenUpIsSaid) {
    LoopCapture capture(session);
    QString said;
    QObject::connect(&session, &DeviceSession::message, &capture,
                     [&](MessageLevel level, const QString&, const QString& text) {
                         said += level == MessageLevel::Warning ? text : QString();
                     });
    awaitForEver(capture);
    board->setPlugged(false);
    ASSERT_TRUE(wait([&] { return session.state() == SessionState::Reconnecting; }));
    disconnectBoard();
    EXPECT_TRUE(said.contains("capture settings")) << said.toStdString();
    board->setPlugged(true);
}

} // namespace
} // namespace halbench::app
