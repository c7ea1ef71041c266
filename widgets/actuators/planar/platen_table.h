#pragma once

#include "widgets/actuators/planar/platen_state.h"
#include "widgets/theme/theme.h"

#include <QFontMetricsF>
#include <QRectF>

class QPainter;

namespace halbench::widgets {

/// Numbers beside the picture of the platen.
struct PlatenNumbers {
    const PlatenSettings& settings;
    const PlatenReadings& readings;
    std::optional<PlatenForces> forces;
    std::optional<PlatenReach> reach; ///< none: where the mode began is not known
    bool isStale = false;
};

/// Width of one column of groups, and height of a column with all of them.
double platenTableWidth_px(const QFontMetricsF& metrics);
double platenTableHeight_px(const QFontMetricsF& metrics);

/// Pose with its error, current and heat of each coil against its limit, residuals of the chips, forces and
/// the reach that is left; in as many columns as the place is wide. Groups that find no room are left out.
void drawPlatenTable(QPainter& painter, const Theme& theme, const QRectF& place,
                     const PlatenNumbers& numbers);

} // namespace halbench::widgets
