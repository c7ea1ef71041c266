#pragma once

#include "widgets/live_plot/live_plot_spec.h"

#include <functional>

class QMenu;
class QWidget;

namespace halbench::widgets {

/// The units that a curve can be shown in, the present one checked; `choose` gets the key of the one that is
/// picked. Owned by `parent`. Null where there is nothing to choose.
QMenu* unitMenu(const PlotCurve& curve, QWidget& parent,
                const std::function<void(const std::string&)>& choose);

} // namespace halbench::widgets
