#pragma once

#include "control/base/result.h"

#include <QColor>

#include <array>
#include <string>

namespace halbench::widgets {

/// The colours by role; nothing else in the program names a colour. Files: resources/themes/*.json.
struct Theme {
    std::string name;
    QColor window, panel, raised;
    QColor text, muted, disabled;
    QColor line, accent;
    QColor plotBackground, plotGrid, plotAxis;
    QColor good, warn, bad;
    QColor simulated, armed, stop, stopText;
    std::array<QColor, 8> curves;
};

/// "light" or "dark". Errors: UnknownName.
Result<Theme> loadTheme(const std::string& name);

/// Errors: InvalidInput for text that is not JSON, a missing role or a colour that is not one.
Result<Theme> parseTheme(const std::string& json);

} // namespace halbench::widgets
