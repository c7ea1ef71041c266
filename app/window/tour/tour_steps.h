#pragma once

#include "app/window/docks/perspective.h"

#include <QString>

#include <optional>
#include <vector>

namespace halbench::app {

/// One card of the tour.
struct TourStep {
    QString id;
    QString panel; ///< of DockLayout, which the step points at; empty: the Help menu
    QString part;  ///< object name of the part of the panel that is framed; empty: its dock area
    std::optional<Perspective> perspective; ///< in which the panel is shown; none: in any
    QString title;
    QString text;
    bool isDoneConnected = false; ///< there is nothing to do while a device is connected

    bool operator==(const TourStep&) const = default;
};

/// All steps, in their order. Those whose panel the device does not have are skipped.
std::vector<TourStep> tourSteps();

} // namespace halbench::app
