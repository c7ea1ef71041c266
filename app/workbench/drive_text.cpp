#include "app/workbench/drive_text.h"

#include <QCoreApplication>

#include <array>

namespace halbench::app {

namespace {

constexpr char Context[] = "halbench::app::DriveWords";

/// By the board's code of a shape, then the paths as MoveReference counts them; 0: it is not known which.
constexpr std::array Shapes = {
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "reference"),
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "step"),
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "ramp"),
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "sine"),
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "staircase"),
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "chirp"),
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "multisine"),
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "plateaus"),
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "trapezoid"),
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "s-curve"),
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "circle"),
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "raster"),
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "arc"),
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "line"),
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "table of poses"),
};

/// By devices::BoardMode.
constexpr std::array Modes = {
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "idle"),
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "current"),
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "position"),
    QT_TRANSLATE_NOOP("halbench::app::DriveWords", "d-axis"),
};

QString say(const char* text) {
    return QCoreApplication::translate(Context, text);
}

} // namespace

QString drivenWords(const DriveControl& control) {
    if (control.isJogging()) {
        return say(QT_TRANSLATE_NOOP("halbench::app::DriveWords", "jogging"));
    }
    if (!control.isRunning()) {
        return {};
    }
    const std::size_t shape = control.runningShape();
    return say(QT_TRANSLATE_NOOP("halbench::app::DriveWords", "%1, %2 mode"))
        .arg(say(Shapes[shape < Shapes.size() ? shape : 0]),
             say(Modes[static_cast<std::size_t>(control.mode())]));
}

} // namespace halbench::app
