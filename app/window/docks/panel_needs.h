#pragma once

#include "app/window/docks/perspective.h"
#include "app/workbench/drive_ability.h"

#include <QSet>
#include <QString>
#include <QStringList>

namespace halbench::app {

/// Abilities of a device that a panel is made for.
enum class PanelNeed {
    Nothing,
    Drive,                 ///< the board is armed from here and its profile names its axes
    Recording,             ///< live data; a recording that is replayed is one already
    ControlLoop,           ///< an axis whose gains are designed
    Identification,        ///< its profile offers the procedure
    OneAxisIdentification, ///< likewise, of a device with a single axis
    Calibration,           ///< as Identification
    Picture,               ///< the signals of one of the pictures of actuators
};

/// Whether the open device meets the need. A recording that is replayed moves nothing; panels that show
/// results without a device show them beside it too.
bool isMet(PanelNeed need, const devices::DeviceInfo& info, const devices::Catalogue& catalogue);

/// Ids of the panels that this device has no use for. A board without a profile is watched, set and recorded.
QSet<QString> absentPanels(const devices::DeviceInfo& info, const devices::Catalogue& catalogue);

/// Ids of the panels that a perspective is for, of which a device has one: without any of them it has no use
/// for the perspective.
QStringList mainPanels(Perspective perspective);

} // namespace halbench::app
