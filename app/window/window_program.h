#pragma once

#include "app/window/preferences/preferences.h"

#include <atomic>
#include <memory>
#include <string>
#include <vector>

class QApplication;

namespace halbench::app {

class MainWindow;

/// Whether these arguments ask for the window: none, or only those of the window.
bool isWindowCall(const std::vector<std::string>& arguments);

/// Opens the workstation: `halbench [--project FILE] [--connect DEVICE]`. Gives the exit code; 2 with one
/// line on stderr without a display or with an option that makes no sense; 128 and the number after a signal.
int runWindow(const std::vector<std::string>& arguments);

/// Closes the window (MainWindow::closeBySignal) soon after `received` is no longer 0.
void closeBySignal(MainWindow& window, const std::atomic<int>& received);

/// Before the QApplication: everything in the window grows with the display's scale (1x to 2x and between),
/// not only its text. QT_SCALE_FACTOR multiplies it.
void followDisplayScale();

/// What the arguments of runWindow() ask of the window is done as soon as its panels are there.
void obey(MainWindow& window, const std::vector<std::string>& arguments);

/// The window as runWindow() shows it first: in the language and the theme of the preferences.
std::unique_ptr<MainWindow> makeWindow(QApplication& application, const Preferences& preferences);

} // namespace halbench::app
