#include "tests/bench/window_rig.h"

#include <QtTest/QTest>

#include <optional>

namespace halbench::bench {

std::unique_ptr<app::MainWindow> openWindow() {
    auto window = std::make_unique<app::MainWindow>(app::Preferences());
    window->furnish();
    window->resize(1600, 900);
    window->show();
    (void)QTest::qWaitForWindowExposed(window.get());
    return window;
}

bool connectMotor(app::MainWindow& window) {
    window.connectDevice("sim:htm");
    return QTest::qWaitFor([&] { return !window.bench().deviceValues().empty(); }, Patience_ms);
}

bool request(app::DeviceSession& session, std::function<Result<void>(devices::Device&)> action) {
    const auto answer = std::make_shared<std::optional<bool>>(); // outlives a wait that gave up
    session.request(std::move(action), [answer](const Result<void>& done) { *answer = done.has_value(); });
    return QTest::qWaitFor([&] { return answer->has_value(); }, Patience_ms) && **answer;
}

} // namespace halbench::bench
