// What the user of the window feels: how soon the window is there, what it costs to idle.
#include "app/window/docks/dock_layout.h"
#include "app/window/main_window.h"
#include "app/window/window_application.h"
#include "app/window/window_program.h"
#include "tests/bench/goal.h"
#include "tests/bench/window_rig.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QAction>
#include <QApplication>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTimer>
#include <QtTest/QTest>

#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>

namespace halbench::bench {
namespace {

double processor_s() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double idleShare_ratio() {
    constexpr int Idle_ms = 3000;
    const double before_s = processor_s();
    QTest::qWait(Idle_ms);
    return (processor_s() - before_s) * 1e3 / Idle_ms;
}

void benchIdle(Goals& goals, app::MainWindow& window) {
    goals.below("idle window, share of a core", idleShare_ratio(), 0.03, "");
    // The simulated board computes its motor in this process; what is watched moves 30 times a second.
    constexpr const char* Connected = "window that watches the simulated motor, share of a core";
    if (!connectMotor(window)) {
        goals.failed(Connected, "the simulated motor does not connect");
        return;
    }
    QTest::qWait(2000); // what follows the connection
    goals.below(Connected, idleShare_ratio(), 0.15, "");
}

/// A board that a process of its own simulates, so that only the window's work is counted.
class ServedMotor {
public:
    ServedMotor() {
        m_program.start(QStringLiteral(HALBENCH_PROGRAM),
                        {QStringLiteral("serve"), QStringLiteral("sim:htm"), QStringLiteral("--tcp"),
                         QStringLiteral("127.0.0.1:0")});
        while (m_address.isEmpty() && m_program.waitForReadyRead(Patience_ms)) {
            const QRegularExpression address(QStringLiteral("tcp:127\\.0\\.0\\.1:\\d+"));
            m_address = address.match(QString::fromUtf8(m_program.readAll())).captured();
        }
    }
    ~ServedMotor() {
        m_program.terminate();
        m_program.waitForFinished();
    }
    const QString& address() const { return m_address; }

private:
    QProcess m_program;
    QString m_address;
};

/// The goals of resources/help/monitor.md: live plots that follow, plots that are paused, a window that
/// nobody sees.
void benchWatching(Goals& goals, app::MainWindow& window) {
    constexpr const char* Following = "live plots of a served board at 1920x1200, share of a core";
    const ServedMotor motor;
    window.resize(1920, 1200);
    window.connectDevice(motor.address());
    const auto isConnected = [&] { return !window.bench().deviceValues().empty(); };
    if (motor.address().isEmpty() || !QTest::qWaitFor(isConnected, Patience_ms)) {
        return goals.failed(Following, "the served motor does not connect");
    }
    QTest::qWait(12000); // until the plots scroll
    goals.below(Following, idleShare_ratio(), 0.12, "");
    auto* plots = window.docks().panel("monitor")->findChild<widgets::LivePlotStack*>();
    plots->action(widgets::LivePlotStack::Command::Pause)->trigger();
    QTest::qWait(1000);
    goals.below("the same, paused", idleShare_ratio(), 0.04, "");
    plots->action(widgets::LivePlotStack::Command::Pause)->trigger();
    window.showMinimized();
    QTest::qWait(1000);
    goals.below("the same, minimised", idleShare_ratio(), 0.02, "");
}

/// Ends the process when the event loop comes back from the first paint of a window: what the user waits for.
class EndAtFirstPaint : public QObject {
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::Paint) {
            QTimer::singleShot(0, this, [] { std::_Exit(0); });
        }
        return false;
    }
};

/// A process of its own from its start to the first paint: with our window and all its panels, or with the
/// least a Qt window can be.
int paintOnce(QApplication& application, bool isOurs) {
    const std::unique_ptr<QWidget> window =
        isOurs ? app::makeWindow(application, app::Preferences()) : std::make_unique<QWidget>();
    window->installEventFilter(new EndAtFirstPaint(window.get()));
    window->resize(1600, 900);
    window->show();
    return QApplication::exec();
}

void benchFirstPaint(Goals& goals, const std::string& self) {
    const auto start = [&](const char* which) {
        return wallTime_s([&] { (void)std::system((self + " " + which).c_str()); }, 10);
    };
    const double plain_s = start("plain");
    const double ours_s = start("ours");
    goals.below("first paint, of the complete window", ours_s, 0.6, "s");
    goals.below("first paint against a minimal Qt window's", ours_s / plain_s, 5.0, "times");
}

int run(const std::string& self) {
    Goals goals;
    benchFirstPaint(goals, self);
    benchIdle(goals, *openWindow()); // gone before the next one, whose share is counted
    benchWatching(goals, *openWindow());
    return goals.exitCode();
}

} // namespace
} // namespace halbench::bench

int main(int count, char** arguments) {
    QStandardPaths::setTestModeEnabled(true);
    halbench::app::followDisplayScale();
    halbench::app::WindowApplication application(count, arguments);
    const std::string which = count > 1 ? arguments[1] : "";
    if (!which.empty()) {
        return halbench::bench::paintOnce(application, which == "ours");
    }
    return halbench::bench::run(arguments[0]);
}
