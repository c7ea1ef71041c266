#pragma once

#include "app/workbench/display_quantity.h"
#include "widgets/figure/figure.h"

namespace halbench::widgets {
class FigureView;
} // namespace halbench::widgets

namespace halbench::app {

/// The picture with the angles and speeds of its vertical axes as the user prefers to read them: axis,
/// curves, reference lines. What else it shows stays.
widgets::Figure inUnits(widgets::Figure figure, const DisplayUnits& units);

/// What a frequency in Hz is multiplied by to be shown.
double frequencyFactor(FrequencyUnit unit);
/// The picture with the frequencies of its horizontal axis, or those that its curves run along, in this unit:
/// axis, curves, reference lines. A picture over anything else stays.
widgets::Figure inFrequencyUnit(widgets::Figure figure, FrequencyUnit unit);
/// The same in a view, whose numbers are saved in Hz, as every file has them.
void showInFrequencyUnit(widgets::FigureView& view, const widgets::Figure& figure, FrequencyUnit unit);

} // namespace halbench::app
