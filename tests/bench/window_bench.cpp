// What the user of the window feels: how soon the window is there, what it costs to idle.
#include "app/window/window_program.h"
#include "tests/bench/goal.h"
#include "tests/bench/window_rig.h"

#include <QApplication>
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

void benchIdle(Goals& goals) {
    constexpr int Idle_ms = 3000;
    const double before_s = processor_s();
    QTest::qWait(Idle_ms);
    goals.below("idle window, share of a core", (processor_s() - before_s) * 1e3 / Idle_ms, 0.03, "");
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

/// A process of its own from its start to the first paint: with our window, or with the least a Qt window
/// can be.
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
    goals.below("first paint against a minimal Qt window's", start("ours") / start("plain"), 1.5, "times");
}

int run(const std::string& self) {
    Goals goals;
    benchFirstPaint(goals, self);
    const auto window = openWindow();
    benchIdle(goals);
    return goals.exitCode();
}

} // namespace
} // namespace halbench::bench

int main(int count, char** arguments) {
    QStandardPaths::setTestModeEnabled(true);
    QApplication application(count, arguments);
    const std::string which = count > 1 ? arguments[1] : "";
    if (!which.empty()) {
        return halbench::bench::paintOnce(application, which == "ours");
    }
    return halbench::bench::run(arguments[0]);
}
