// What the user of the window feels: how soon STOP acts, how soon the window is there, what it costs to idle.
#include "app/window/main_window.h"
#include "tests/bench/goal.h"
#include "widgets/theme_style.h"

#include <QApplication>
#include <QDialog>
#include <QElapsedTimer>
#include <QStandardPaths>
#include <QtTest/QTest>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

namespace halbench::bench {
namespace {

constexpr int Patience_ms = 20000;
constexpr int Presses = 100;

double processor_s() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::unique_ptr<app::MainWindow> openWindow() {
    auto window = std::make_unique<app::MainWindow>(app::Preferences());
    window->resize(1600, 900);
    window->show();
    (void)QTest::qWaitForWindowExposed(window.get());
    return window;
}

bool connectMotor(app::MainWindow& window) {
    window.connectDevice("sim:htm");
    return QTest::qWaitFor([&] { return !window.bench().deviceValues().empty(); }, Patience_ms);
}

bool release(app::DeviceSession& session) {
    session.request([](devices::Device& device) { return device.clearStop(); }, [](const Result<void>&) {});
    return QTest::qWaitFor([&] { return !session.report().board.isStopLatched; }, Patience_ms);
}

/// From the press of Esc until the window has been told that the board has latched, so it includes more than
/// the board's zero current does. The motor runs in real time and the plots draw.
double pressToLatched_s(app::DeviceSession& session, QWidget& target) {
    QElapsedTimer timer;
    timer.start();
    QTest::keyClick(&target, Qt::Key_Escape);
    while (!session.report().board.isStopLatched && timer.elapsed() < Patience_ms) {
        QCoreApplication::processEvents(QEventLoop::AllEvents, 1);
    }
    return static_cast<double>(timer.nsecsElapsed()) * 1e-9;
}

void benchStop(Goals& goals, const std::string& name, app::MainWindow& window, QWidget& target) {
    app::DeviceSession& session = window.bench().session();
    std::vector<double> latencies_s;
    for (int press = 0; press < Presses; ++press) {
        QTest::qWait(7 + press % 40); // at every phase of the frame
        latencies_s.push_back(pressToLatched_s(session, target));
        if (!release(session)) {
            return goals.failed(name, "the stop could not be released");
        }
    }
    std::sort(latencies_s.begin(), latencies_s.end());
    goals.below(name, latencies_s[Presses - 1 - Presses / 100] * 1e3, 50.0, "ms");
}

void benchIdle(Goals& goals) {
    constexpr int Idle_ms = 3000;
    const double before_s = processor_s();
    QTest::qWait(Idle_ms);
    goals.below("idle window, share of a core", (processor_s() - before_s) * 1e3 / Idle_ms, 0.03, "");
}

/// A process of its own from its start to the first paint: with our window, or with the least a Qt window
/// can be.
int paintOnce(bool isOurs) {
    QWidget plain;
    std::unique_ptr<app::MainWindow> ours;
    if (isOurs) {
        ours = openWindow();
    } else {
        plain.resize(1600, 900);
        plain.show();
        (void)QTest::qWaitForWindowExposed(&plain);
    }
    (void)(isOurs ? ours.get() : &plain)->grab();
    return 0;
}

void benchFirstPaint(Goals& goals, const std::string& self) {
    const auto start = [&](const char* which) {
        return wallTime_s([&] { (void)std::system((self + " " + which).c_str()); }, 5);
    };
    goals.below("first paint against a minimal Qt window's", start("ours") / start("plain"), 1.5, "times");
}

int run(const std::string& self) {
    Goals goals;
    benchFirstPaint(goals, self);
    const auto window = openWindow();
    benchIdle(goals);
    if (!connectMotor(*window)) {
        goals.failed("stop", "the simulated motor could not be connected");
        return goals.exitCode();
    }
    benchStop(goals, "Esc to latched stop while plots draw, 99th percentile", *window, *window);
    QDialog dialog(window.get());
    dialog.setModal(true);
    QWidget inner(&dialog);
    dialog.show();
    benchStop(goals, "the same with a modal dialog open", *window, inner);
    return goals.exitCode();
}

} // namespace
} // namespace halbench::bench

int main(int count, char** arguments) {
    QStandardPaths::setTestModeEnabled(true);
    const QApplication application(count, arguments);
    const std::string which = count > 1 ? arguments[1] : "";
    if (!which.empty()) {
        return halbench::bench::paintOnce(which == "ours");
    }
    return halbench::bench::run(arguments[0]);
}
