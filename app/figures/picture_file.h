#pragma once

#include "control/base/result.h"
#include "widgets/figure/figure.h"

#include <string>

namespace halbench::app {

/// The content of a picture file of that name (.svg, .pdf, else PNG) for print, in the light theme. Equal
/// figures give equal files. Errors: InvalidInput (of the figure); Internal when nothing can be drawn here.
Result<std::string> figurePicture(widgets::Figure figure, const std::string& path);

} // namespace halbench::app
