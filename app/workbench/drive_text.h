#pragma once

#include "app/workbench/drive_control.h"

#include <QString>

namespace halbench::app {

/// What an armed actuator is doing by hand: "sine on current", "jogging"; empty while nothing runs.
QString drivenWords(const DriveControl& control);

} // namespace halbench::app
