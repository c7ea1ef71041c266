#pragma once

#include "app/procedures/tune/tune.h"

#include <optional>

namespace halbench::widgets {
class VerdictView;
}

namespace halbench::app {

/// Verdict of the proposed gains. One that rests on an assumption or is near the limit of stability says so
/// and does not look good. `foreign`: they are of another motor than the connected one, which makes them
/// doubtful before everything else.
void showDesignVerdict(widgets::VerdictView& view, const TuneResult& proposed,
                       const std::optional<Finding>& foreign);
/// The same where nothing can be proposed.
void showDesignProblem(widgets::VerdictView& view, const Error& problem);

} // namespace halbench::app
