#include "app/window/tour/tour_steps.h"

#include <QCoreApplication>

namespace halbench::app {
namespace {

struct Row {
    const char* id;
    const char* panel;
    const char* part;
    std::optional<Perspective> perspective;
    const char* title;
    const char* text;
    bool isDoneConnected = false;
};

constexpr Row Rows[] = {
    {"connect", "devices", "device_chooser", Perspective::Monitor,
     QT_TRANSLATE_NOOP("Tour", "Connect a device"),
     QT_TRANSLATE_NOOP("Tour",
                       "Choose a simulated actuator and press Enter, or double-click it. A real device "
                       "is listed when it is plugged in."),
     true},
    {"monitor", "monitor", "", Perspective::Monitor, QT_TRANSLATE_NOOP("Tour", "Watch the signals"),
     QT_TRANSLATE_NOOP("Tour",
                       "The plots follow the device. F6 lists all signals, Space pauses the view, the "
                       "wheel zooms.")},
    {"drive", "drive", "", Perspective::Monitor, QT_TRANSLATE_NOOP("Tour", "Arm and drive"),
     QT_TRANSLATE_NOOP("Tour", "Arm, choose a reference, for example a sine, and start it. Esc or STOP stops "
                               "the actuator at any time.")},
    {"calibrate", "calibrate", "", Perspective::Identify, QT_TRANSLATE_NOOP("Tour", "Calibrate the sensors"),
     QT_TRANSLATE_NOOP("Tour", "A short motion measures the errors of the sensors; Apply corrects them. "
                               "Simulated time 20 times shortens the wait.")},
    {"identify", "identify", "", Perspective::Identify, QT_TRANSLATE_NOOP("Tour", "Identify the actuator"),
     QT_TRANSLATE_NOOP("Tour", "Start identification measures the constants of the model, each with its "
                               "95 % interval, or says why it cannot.")},
    {"tune", "tune", "", Perspective::Tune, QT_TRANSLATE_NOOP("Tour", "Tune the controller"),
     QT_TRANSLATE_NOOP("Tour",
                       "Tune designs gains for the identified model. Apply and verify compares a test "
                       "move with the prediction; Keep or Restore ends it.")},
    {"record", "record", "", Perspective::Record, QT_TRANSLATE_NOOP("Tour", "Record and compare"),
     QT_TRANSLATE_NOOP("Tour",
                       "Ctrl+R starts and ends a recording. The list of recordings opens, replays and "
                       "overlays them.")},
    {"help", "", "", std::nullopt, QT_TRANSLATE_NOOP("Tour", "Find help"),
     QT_TRANSLATE_NOOP("Tour",
                       "F1 explains the panel with the focus, Ctrl+F1 lists all keys. First steps and "
                       "this tour are in the Help menu.")},
};

} // namespace

std::vector<TourStep> tourSteps() {
    std::vector<TourStep> steps;
    for (const Row& row : Rows) {
        steps.push_back({QString::fromLatin1(row.id), QString::fromLatin1(row.panel),
                         QString::fromLatin1(row.part), row.perspective,
                         QCoreApplication::translate("Tour", row.title),
                         QCoreApplication::translate("Tour", row.text), row.isDoneConnected});
    }
    return steps;
}

} // namespace halbench::app
