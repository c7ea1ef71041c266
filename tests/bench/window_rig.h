#pragma once

#include "app/window/main_window.h"

#include <memory>
#include <string>
#include <vector>

namespace halbench::bench {

constexpr int Patience_ms = 20000;

/// The window at the size that the speed goals are stated for, exposed; with preferences of its own.
std::unique_ptr<app::MainWindow> openWindow();

/// Connects the simulated motor, in real time; false when it does not come.
bool connectMotor(app::MainWindow& window);

/// Does it on the connection thread and waits while the window lives on; false when the device refused.
bool request(app::DeviceSession& session, std::function<Result<void>(devices::Device&)> action);

} // namespace halbench::bench
