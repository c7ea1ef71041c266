#pragma once

#include "app/procedures/tune/tune_axes.h"
#include "widgets/controls/verdict_view.h"

namespace halbench::app {

/// Verdict of the loops of several axes: the worst one sets it. `isWaiting`: without a result they are still
/// computed.
void showAxesVerdict(widgets::VerdictView& view, const Result<TuneAxesResult>& result, bool isWaiting);

} // namespace halbench::app
