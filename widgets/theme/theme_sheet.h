#pragma once

#include "widgets/theme/theme.h"

#include <QString>

namespace halbench::widgets {

/// The one style sheet of the program. Heights follow the font's, so that larger letters get larger controls.
QString styleSheetOf(const Theme& theme, int fontHeight_px);

} // namespace halbench::widgets
