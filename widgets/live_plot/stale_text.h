#pragma once

#include "control/history/sample_history.h"

#include <QString>

#include <string>

namespace halbench::widgets {

/// Since when the latest value of a signal is old, in words; empty while it is fresh or unknown. `all`: the
/// words when no signal is updated any more. A signal of which nothing came while others went on is old too,
/// since a place on the time axis.
QString staleWords(const control::SampleHistory& history, const std::string& signal, const QString& all);

} // namespace halbench::widgets
