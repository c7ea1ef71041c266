#pragma once

#include "app/procedures/move/move_procedure.h"

#include <string>
#include <vector>

namespace halbench::app {

/// Each row of a table of poses that the recording reaches, for one of its axes; nothing of other references
/// and of an axis without a column.
std::vector<RowFigures> measureRows(const MoveResponse& response, const MoveConfig& config,
                                    const std::string& axis);

} // namespace halbench::app
