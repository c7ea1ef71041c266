#pragma once

#include <string>

namespace halbench::widgets {
struct Theme;
}

namespace halbench::app {

/// The report's style sheet in the colours of a theme.
std::string reportStyle(const widgets::Theme& theme);

} // namespace halbench::app
