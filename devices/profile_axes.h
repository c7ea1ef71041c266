#pragma once

#include "control/base/result.h"
#include "devices/profile.h"

#include <QtCore/QJsonValue>

#include <vector>

namespace halbench::devices {

/// The axes of a profile whose roles are read already; none for an undefined value. Errors: InvalidInput,
/// whose message is the key ("axes.1.position_unit") and whose hint is what is wrong with it.
Result<std::vector<AxisSpec>> axesFrom(const QJsonValue& value, const Profile& profile);

} // namespace halbench::devices
