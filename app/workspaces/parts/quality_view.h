#pragma once

#include "app/procedures/base/procedure.h"
#include "widgets/controls/verdict_view.h"

#include <vector>

namespace halbench::app {

/// Level of a verdict in the view of verdicts.
widgets::VerdictLevel verdictLevel(Verdict verdict);
/// Remarks of the view of verdicts: each finding with its hint, in the language of the window.
std::vector<widgets::Remark> remarksOf(const std::vector<Finding>& findings);

} // namespace halbench::app
