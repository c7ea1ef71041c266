#pragma once

#include "app/procedures/tune/analyse.h"
#include "widgets/figure/figures.h"

#include <string>

namespace halbench::app {

/// Every crossing of the open loop, in its Bode, Nyquist and Nichols plot: those that decide the margins with
/// their names, all others that the axes reach faint.

/// A margin is read in one panel and its crossover seen in both. Of a stable loop.
void markCrossings(widgets::BodeContent& content, const AnalysisResult& loop);
/// As crosses on the unit circle and on the negative real axis. Of a stable loop.
void appendCrossings(widgets::Panel& plane, const widgets::Axis& x, const AnalysisResult& loop);
/// As crosses at 0 dB and at -180 degrees. Of a stable loop.
void appendNicholsCrossings(widgets::Panel& panel, const widgets::Axis& x, const AnalysisResult& loop);

/// What Nyquist's criterion counts (control/analysis/nyquist.h) of the loop with these roots; nothing on the
/// limit of stability and for a loop without roots.
struct NyquistCount {
    int encirclements = 0; ///< of -1, counter-clockwise
    int unstableOpenLoopPoles = 0;
};
std::optional<NyquistCount> nyquistCount(const AnalysisResult& loop);
/// "-1, circled 0 times; unstable poles of L: 0"
std::string criticalPoint(const AnalysisResult& loop);

} // namespace halbench::app
