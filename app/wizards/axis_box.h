#pragma once

#include "devices/device.h"

#include <QString>

class QComboBox;

namespace halbench::app {

/// Fills a box with the axes of a device, their ids as data, and before them `all` with the data "all". Says
/// nothing of the change.
void fillAxisBox(QComboBox& box, const devices::Catalogue& catalogue, const QString& all);

} // namespace halbench::app
