#include "app/session/connection.h"
#include "devices/open/open_device.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>

namespace halbench::app {
namespace {

constexpr auto Patience = std::chrono::seconds(20);

/// The last report of a connection, for a test that waits for one.
class Reports {
public:
    void take(const ConnectionReport& report) {
        const std::lock_guard lock(m_mutex);
        m_last = report;
        m_arrived.notify_all();
    }

    template <typename Condition>
    bool wait(Condition condition) {
        std::unique_lock lock(m_mutex);
        return m_arrived.wait_for(lock, Patience, [&] { return condition(m_last); });
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_arrived;
    ConnectionReport m_last;
};

ConnectionEvents eventsTo(
    Reports& reports, std::function<void()> onEach = [] {}) {
    ConnectionEvents events;
    events.onOpened = [](const devices::DeviceInfo&, const devices::Catalogue&) {};
    events.onRefused = [](const Error&) {};
    events.onReport = [&reports, onEach = std::move(onEach)](const ConnectionReport& report) {
        onEach();
        reports.take(report);
    };
    events.onBlock = [](const TimedBlock&) {};
    return events;
}

Result<std::unique_ptr<devices::Device>> openMotor() {
    return devices::openDevice("sim:htm", {});
}

constexpr double Short_s = 0.4; ///< four reports long

TEST(Connection, stopsAnArmedActuatorWhoseWindowHangs) {
    Reports reports;
    Connection connection(openMotor, {1.0}, eventsTo(reports), Short_s);
    connection.post([](devices::Device& device) { ASSERT_TRUE(device.arm()); });
    // Nobody says that the window is alive from here on.
    ASSERT_TRUE(reports.wait([](const ConnectionReport& last) { return last.isStoppedForSilence; }));
    EXPECT_TRUE(reports.wait(
        [](const ConnectionReport& last) { return last.board.isStopLatched && !last.board.isArmed; }));
}

TEST(Connection, tellsEverySilenceOfAnActuatorThatWasArmedAnew) {
    Reports reports;
    Connection connection(openMotor, {1.0}, eventsTo(reports), Short_s);
    const auto isTold = [](const ConnectionReport& last) { return last.isStoppedForSilence; };
    connection.post([](devices::Device& device) { ASSERT_TRUE(device.arm()); });
    ASSERT_TRUE(reports.wait(isTold));
    connection.post([&connection](devices::Device& device) {
        connection.confirmAlive();
        ASSERT_TRUE(device.clearStop());
        ASSERT_TRUE(device.arm());
    });
    ASSERT_TRUE(reports.wait([](const ConnectionReport& last) { return last.board.isArmed; }));
    ASSERT_TRUE(reports.wait([&](const ConnectionReport& last) { return !isTold(last); }));
    EXPECT_TRUE(reports.wait(isTold));
}

TEST(Connection, leavesAnActuatorArmedWhoseWindowAnswers) {
    Reports reports;
    Connection* alive = nullptr;
    Connection connection(openMotor, {1.0},
                          eventsTo(reports,
                                   [&alive] {
                                       if (alive != nullptr) {
                                           alive->confirmAlive();
                                       }
                                   }),
                          Short_s);
    connection.post([&](devices::Device& device) {
        alive = &connection; // on the connection's thread, which reads it
        ASSERT_TRUE(device.arm());
    });
    ASSERT_TRUE(reports.wait([](const ConnectionReport& last) { return last.deviceTime_s > 3.0 * Short_s; }));
    EXPECT_TRUE(reports.wait(
        [](const ConnectionReport& last) { return last.board.isArmed && !last.isStoppedForSilence; }));
}

TEST(Connection, virtualTimeNeedsNoWindow) {
    Reports reports;
    Connection connection(openMotor, {0.0}, eventsTo(reports), 0.0);
    connection.post([](devices::Device& device) { ASSERT_TRUE(device.arm()); });
    EXPECT_TRUE(reports.wait([](const ConnectionReport& last) { return last.board.isArmed; }));
}

} // namespace
} // namespace halbench::app
