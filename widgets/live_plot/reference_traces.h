#pragma once

#include "control/history/sample_history.h"

#include <QString>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace halbench::widgets {

/// Signals as they once were, to lay under those that are shown now: the trigger's event of one over that of
/// the other, or, where one of them has none, the first moment of one over the first of the other.
struct ReferenceTraces {
    QString name; ///< what they are of, in words
    double begin_s = 0.0;
    std::optional<double> event_s;
    std::map<std::string, std::shared_ptr<const control::SampleHistory>> samples; ///< by signal
};

using ReferencePtr = std::shared_ptr<const ReferenceTraces>;

/// What a stretch of the history holds of these signals: all samples, or of more than a million the extremes
/// of a quarter of a million columns.
ReferenceTraces keptTraces(const control::SampleHistory& history, const std::set<std::string>& signalNames,
                           control::TimeRange range);
/// All of a recording.
ReferenceTraces tracesOf(const Recording& recording);

/// How much later they are drawn than they were, in a view that begins there.
double shiftOf(const ReferenceTraces& traces, double begin_s, const std::optional<double>& event_s);

} // namespace halbench::widgets
