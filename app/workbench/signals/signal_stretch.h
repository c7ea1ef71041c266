#pragma once

#include "control/history/sample_history.h"

#include <string>
#include <vector>

namespace halbench::app {

/// A copy of what one signal did, for a computation on another thread. Values are NaN where there is none.
struct SignalStretch {
    std::vector<double> time_s;
    std::vector<double> values;
    std::string unit;              ///< SI symbol
    std::vector<std::size_t> gaps; ///< rows before which the line is interrupted
};

/// The last `length_s` of the signal, at most `mostRows` rows of it: copying is the GUI thread's work.
SignalStretch lastStretch(const control::SampleHistory& history, const std::string& signal, double length_s,
                          std::size_t mostRows);

/// The stretch on a time axis of its own on which every gap is at least two usual steps long: a stream that
/// was started anew goes on between the steps of the one before.
SignalStretch withOpenGaps(SignalStretch stretch);

/// Two signals at the same moments; of rows in which one is missing, none.
struct SignalPair {
    std::vector<double> x;
    std::vector<double> y;
};
SignalPair pairUp(const SignalStretch& x, const SignalStretch& y);

} // namespace halbench::app
