#pragma once

#include "app/session/device_session.h"
#include "app/session/recorder.h"
#include "devices/formats/recording_file.h"
#include "devices/simulated/registry/simulated_device.h"
#include "devices/transport/board_server.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QElapsedTimer>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <gtest/gtest.h>
#include <poll.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace halbench::app {

/// A simulated motor's board that lives on while its cable is pulled and put back: the bytes are those of a
/// real one, the line is whatever `plug` makes. Line and board belong to a thread of their own. Where the
/// machine is too busy to serve it, the board's time stands still: its watchdog would end a session that
/// nobody left.
class PluggableBoard : private devices::ServedBoard {
public:
    using Plug = std::function<std::unique_ptr<devices::ServerPort>()>;

    explicit PluggableBoard(Plug plug, devices::SimulatedBoard::Line line = {nullptr, 0})
        : m_plug(std::move(plug)), m_board(*devices::makeSimulatedBoard(
                                       *devices::parseDeviceUri("sim:htm?imperfections=off"), {}, line)),
          m_thread([this] { run(); }) {
        setPlugged(true);
    }
    ~PluggableBoard() {
        m_isEnding = true;
        m_thread.join();
    }
    PluggableBoard(const PluggableBoard&) = delete;
    PluggableBoard& operator=(const PluggableBoard&) = delete;

    /// Returns when it is so.
    void setPlugged(bool isPlugged) {
        m_isWanted = isPlugged;
        while (m_isPlugged != isPlugged) {
            std::this_thread::yield();
        }
    }
    /// What the board itself says.
    bool isArmed() const { return m_isArmed; }

private:
    static constexpr double LongestTurn_s = 0.02;

    void run() {
        auto last = std::chrono::steady_clock::now();
        double board_s = 0.0;
        std::unique_ptr<devices::ServerPort> port;
        while (!m_isEnding) {
            if (m_isWanted != m_isPlugged) {
                port = m_isWanted ? m_plug() : nullptr;
                m_isPlugged = m_isWanted.load();
            }
            if (port) {
                port->waitForTraffic(1);
            } else {
                (void)::poll(nullptr, 0, 1); // the board's tick
            }
            const auto now = std::chrono::steady_clock::now();
            board_s += std::min(std::chrono::duration<double>(now - std::exchange(last, now)).count(),
                                LongestTurn_s);
            advanceTo(board_s);
            if (port) {
                port->exchange(*this);
            }
            m_isArmed = m_board->firmware().safety.armed != 0;
        }
    }

    void advanceTo(double time_s) override { m_board->advanceTo(time_s); }
    void receive(std::span<const std::uint8_t> packet) override { m_board->receive(packet); }
    bool transmit(std::vector<std::uint8_t>& packet, std::uint16_t& counter) override {
        constexpr std::size_t Longest = 0xFFFF;
        packet.resize(Longest);
        packet.resize(m_board->transmit(packet));
        counter = m_board->messageCounter();
        return !packet.empty();
    }

    Plug m_plug;
    std::unique_ptr<devices::SimulatedBoard> m_board;
    std::atomic<bool> m_isWanted = false;
    std::atomic<bool> m_isPlugged = false;
    std::atomic<bool> m_isEnding = false;
    std::atomic<bool> m_isArmed = false;
    std::thread m_thread;
};

/// Unplugs a board in motion again and again while it is recorded. What issue and help promise: no crash,
/// nothing hangs, the gaps are marked, the gains are intact, it is never armed when it is back.
class UnplugCycles : public testing::Test {
protected:
    static constexpr int Patience_ms = 20000;
    static constexpr double LongestHang_s = 2.0;
    static constexpr double Gain = 12.5;

    /// `address`: where the board is, once it is plugged in.
    void run(PluggableBoard& board, const std::function<std::string()>& address, int cycles) {
        begin(address());
        watchEvents();
        for (int cycle = 0; cycle < cycles && !HasFatalFailure(); ++cycle) {
            SCOPED_TRACE(cycle);
            unplugInMotion(board);
        }
        EXPECT_LT(longestPause_s, LongestHang_s) << "the window's thread";
        const auto rows = recorder->status().rows;
        ASSERT_TRUE(wait([&] { return recorder->status().rows > rows + 3; })); // behind the last gap
        finishRecording(static_cast<std::uint64_t>(cycles));
    }

    /// Nobody but the board itself can end a motion whose cable is pulled.
    void leaveUnplugged(PluggableBoard& board, const std::string& address) {
        begin(address);
        move(board);
        board.setPlugged(false);
        EXPECT_TRUE(wait([&] { return !board.isArmed(); }));
        ASSERT_TRUE(wait([&] { return session.state() == SessionState::Reconnecting; }));
        board.setPlugged(true);
        ASSERT_TRUE(wait([&] { return session.state() == SessionState::Connected; }));
        EXPECT_TRUE(wait([&] { return session.report().board.isStopLatched; })); // and says why
        EXPECT_FALSE(session.report().board.isArmed);
        const auto rows = recorder->status().rows;
        ASSERT_TRUE(wait([&] { return recorder->status().rows > rows + 3; })); // behind the gap
        finishRecording(1);
    }

private:
    void begin(const std::string& address) {
        session.setReturnTimes({0.02, 1.5, 0.1, 0.0, 3});
        session.connectDevice(QString::fromStdString(address), {1.0});
        ASSERT_TRUE(wait([&] { return session.state() == SessionState::Connected; }));
        ask([](devices::Device& device) {
            const ParameterValue gain{"gain.kp", Gain};
            return device.writeParameters({&gain, 1});
        });
        session.setLiveStream({"position", "speed"}, 100.0);
        startRecording();
    }

    template <typename Condition>
    static bool wait(Condition condition) {
        return QTest::qWaitFor(condition, Patience_ms);
    }

    template <typename Function>
    void ask(Function function) {
        std::optional<Result<void>> answer;
        session.request(function, [&](const Result<void>& done) { answer = done; });
        ASSERT_TRUE(wait([&] { return answer.has_value(); }));
        ASSERT_TRUE(*answer) << answer->error().message;
    }

    double value(const std::string& name) {
        std::optional<Result<std::vector<double>>> values;
        session.request(
            [name](devices::Device& device) {
                return device.readParameters({&name, 1});
            },
            [&](const Result<std::vector<double>>& read) { values = read; });
        EXPECT_TRUE(wait([&] { return values.has_value(); }));
        return values && *values ? (*values)->front() : -1.0;
    }

    void move(PluggableBoard& board) {
        const auto rows = recorder->status().rows;
        ask([](devices::Device& device) -> Result<void> { // turns on the spot
            const ParameterValue mode{"hb.mode", 1.0};
            Result<void> done = device.writeParameters({&mode, 1});
            done = done ? device.arm() : done;
            const ParameterValue current{"hb.setpoint", 0.5};
            return done ? device.writeParameters({&current, 1}) : done;
        });
        ASSERT_TRUE(wait([&] { return recorder->status().rows > rows + 3; }));
        ASSERT_TRUE(board.isArmed());
    }

    void unplugInMotion(PluggableBoard& board) {
        move(board);
        QElapsedTimer timer;
        timer.start();
        board.setPlugged(false);
        ASSERT_TRUE(wait([&] { return session.state() == SessionState::Reconnecting; }));
        EXPECT_LT(1e-3 * static_cast<double>(timer.elapsed()), LongestHang_s + 0.5) << "told";
        const std::uint64_t returns = session.returns();
        board.setPlugged(true);
        ASSERT_TRUE(wait([&] { return session.returns() == returns + 1; }));
        EXPECT_EQ(session.state(), SessionState::Connected);
        EXPECT_FALSE(session.report().board.isArmed);
        EXPECT_EQ(value("hb.arm"), 0.0);
        EXPECT_FALSE(board.isArmed());
        EXPECT_EQ(value("gain.kp"), Gain);
        std::optional<bool> isReleased; // a watchdog that ran out meanwhile is released on purpose
        session.request([](devices::Device& device) -> Result<void> { return device.clearStop(); },
                        [&](const Result<void>& done) { isReleased = done.has_value(); });
        ASSERT_TRUE(wait([&] { return isReleased.has_value(); }));
    }

    void startRecording() {
        RecorderConfig config;
        config.path = path();
        config.layout.period_s = 0.01;
        config.layout.columns = {{"position", "rad"}, {"speed", "rad/s"}};
        recorder = std::make_shared<Recorder>(config);
        session.setBlockSink([kept = recorder](const TimedBlock& block) { kept->push(block); });
    }

    void finishRecording(std::uint64_t cycles) {
        session.setBlockSink({});
        recorder->finish();
        ASSERT_TRUE(wait([&] { return recorder->status().state == RecorderStatus::State::Done; }));
        EXPECT_GE(recorder->status().gaps, cycles); // a loss that is longer than a row is a gap
        const auto file = devices::readRecordingFile(path());
        ASSERT_TRUE(file) << file.error().message;
        EXPECT_EQ(file->meta.gaps.size(), recorder->status().gaps);
        EXPECT_TRUE(std::is_sorted(file->recording.time_s.begin(), file->recording.time_s.end()));
    }

    /// The longest time for which this thread did not turn its events.
    void watchEvents() {
        lastTurn.start();
        QObject::connect(&turns, &QTimer::timeout, &turns, [this] {
            longestPause_s = std::max(longestPause_s, 1e-3 * static_cast<double>(lastTurn.restart()));
        });
        turns.start(10);
    }

    std::string path() const { return folder.filePath("run.csv").toStdString(); }

    int m_argumentCount = 1;
    char m_name[5] = "test";
    char* m_arguments[2] = {m_name, nullptr};
    QCoreApplication application{m_argumentCount, m_arguments};
    QTemporaryDir folder;
    std::shared_ptr<Recorder> recorder;
    QTimer turns;
    QElapsedTimer lastTurn;
    double longestPause_s = 0.0;

protected:
    DeviceSession session; ///< ends first
};

} // namespace halbench::app
