#pragma once

#include "app/procedures/frequency/axes_frequency.h"
#include "app/procedures/frequency/frequency_procedure.h"
#include "control/base/result.h"
#include "control/law/filtered_law.h"
#include "control/law/position_loop.h"

#include <complex>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// A plant that `identify --frequency` measured: from the current command to the measured angle.
struct MeasuredPlant {
    struct Point {
        double frequency_Hz = 0.0;
        std::complex<double> value;           ///< rad/A
        bool isUsed = false;                  ///< coherent enough
        std::optional<double> coherence = {}; ///< 0 ... 1; absent where the file does not say
    };
    std::vector<Point> points;                 ///< ascending
    double period_s = 0.01;                    ///< of the position loop that it was measured in
    std::optional<double> leastCoherence = {}; ///< from which on a point is used
};

/// Plant of a measured response; points that are no number or zero are left out.
MeasuredPlant measuredPlant(const FrequencyResult& result);

/// The plant of each axis while the loops of the others are closed, by the name of the axis: its open loop
/// over the law that ran meanwhile. Points that are no number or zero are left out.
std::map<std::string, MeasuredPlant> measuredPlants(const AxesFrequencyResult& result);

/// The open loop that other gains make of it.
struct MeasuredLoop {
    std::vector<double> frequency_Hz;
    std::vector<double> magnitude_dB;
    std::vector<double> phase_deg; ///< unwrapped along the points that are used; others lie nearest to them
    std::vector<bool> isUsed;
    std::vector<double> coherence = {}; ///< of the measurement; NaN where it is not known
    std::optional<double> leastCoherence = {};
};

/// C z^-d G at each measured frequency: no model of the motor is in it. Errors: of the gains; InvalidInput
/// when the loop that is asked for runs at another rate than the measured one.
Result<MeasuredLoop> measuredLoop(const MeasuredPlant& plant, const control::PidGains& gains,
                                  const control::LoopTiming& timing);
/// The same with the filters of a law.
Result<MeasuredLoop> measuredLoop(const MeasuredPlant& plant, const control::FilteredLaw& law,
                                  const control::LoopTiming& timing);

} // namespace halbench::app
