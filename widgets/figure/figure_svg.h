#pragma once

#include "control/base/result.h"
#include "widgets/figure/figure.h"
#include "widgets/theme/theme.h"

#include <string>

namespace halbench::widgets {

/// Errors: InvalidInput, for a figure without a panel and a curve with more x than y or fewer.
Result<void> checkFigure(const Figure& figure);

/// The figure as one `<svg>` element of the given width: curves decimated to two points per half pixel
/// column, text as text with its length fixed (the same picture with other fonts), title as its accessible
/// name. Equal figures give equal bytes. Needs a QApplication (OffscreenApplication). Errors: InvalidInput
/// when a curve's x and y differ in number or the figure has no panel.
Result<std::string> figureSvg(const Figure& figure, const Theme& theme, int width_px = 880);

} // namespace halbench::widgets
