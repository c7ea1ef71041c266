#pragma once

#include <QString>

namespace halbench::widgets {

/// Names of angles as the window writes them: "alpha" becomes α, and so beta, gamma, theta and phi. Other
/// words that contain one of these stay.
QString greekAngles(QString text);

} // namespace halbench::widgets
