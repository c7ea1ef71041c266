#pragma once

#include "widgets/live_plot/history_curve.h"
#include "widgets/theme/theme.h"

#include <functional>
#include <optional>

class QMenu;
class QWidget;

namespace halbench::widgets {

/// Colours of the theme for a curve of that one. `choose` gets the place of the chosen one among them;
/// none: automatic.
QMenu* colourMenu(const HistoryCurve& curve, const Theme& theme, QWidget& parent,
                  const std::function<void(std::optional<int>)>& choose);

/// Patterns for a curve of that one.
QMenu* lineMenu(const HistoryCurve& curve, const Theme& theme, QWidget& parent,
                const std::function<void(LinePattern)>& choose);

} // namespace halbench::widgets
