#pragma once

#include "widgets/figure/figure.h"

#include <qwt_scale_div.h>
#include <qwt_scale_map.h>

namespace halbench::widgets {

/// One axis ready to draw: its ticks and whether it is logarithmic.
struct FigureScale {
    QwtScaleDiv division;
    bool isLogarithmic = false;

    /// Map onto pixels.
    QwtScaleMap map(double first_px, double last_px) const;
};

/// Extent: as given by the axis, else of all finite data and reference lines, widened a little where points
/// or line crests would touch the frame; never empty. Ticks about `tickDistance_px` apart.
FigureScale horizontalScale(const Figure& figure, double length_px);
FigureScale verticalScale(const Panel& panel, double length_px);
/// Of the panel's right axis, which it must have.
FigureScale rightScale(const Panel& panel, double length_px);

/// Widens the shorter axis of the first panel, so that a unit is as long on both when the figure is drawn so
/// wide. Both must be linear.
void makeEqualScale(Figure& figure, int width_px);

} // namespace halbench::widgets
