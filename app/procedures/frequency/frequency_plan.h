#pragma once

#include "app/procedures/excite/move_reference.h"
#include "app/procedures/frequency/frequency_procedure.h"

#include <complex>
#include <cstddef>
#include <vector>

namespace halbench::app {

/// One excitation on the board's generator, repeated for all its periods without a break.
struct FrequencyStage {
    MoveReference reference;
    std::size_t rowsPerPeriod = 0;
    std::vector<int> lines;  ///< excited multiples of the period's frequency
    double settle_s = 0.0;   ///< left out before the first period
    double measured_s = 0.0; ///< all periods
    double to_Hz = 0.0;      ///< highest frequency that is evaluated
    int sweeps = 0;          ///< of a chirp, each followed by a rest; 0: periodic
    double sweep_s = 0.0;
    double rest_s = 0.0;
};

/// The generator runs on until the next stage takes over, or the motor is disarmed: where it ends it would
/// stop the rotor.
inline constexpr double GeneratorSlack_s = 2.0;

struct FrequencyPlan {
    double turn_rad_s = 0.0; ///< signed; raised so that the turn's harmonics miss the excited lines
    double runUp_s = 0.0;
    std::vector<FrequencyStage> stages;
    double meanSquare_A2 = 0.0; ///< of one phase, expected
    double peakCurrent_A = 0.0; ///< expected, within the limit
    double duration_s() const;
};

/// Limits of the excitation of a motor: its loop, its law and roughly its plant.
struct FrequencyMargins {
    double period_s = 0.01;            ///< of the position loop
    control::SampledPositionLaw law;   ///< as it runs on the board
    control::PositionPlant plant = {}; ///< roughly; the board's own speed is watched all the same
};

/// Lines in bands of less than a factor five, evenly spread in each, or single ones half an octave apart; of
/// a chirp the bands are swept one after the other, with rests in which the loop comes to 0.2 % of its swing.
/// The amplitude of a band is the largest that does not let the reference's speed swing by more than 80 % of
/// the base speed, the rotor's by more than half of it and the current by more than 60 % of what the base
/// motion leaves of its limit, the latter two as far as they can be foreseen. Errors: NotFinite, OutOfRange,
/// naming what to change.
Result<FrequencyPlan> planFrequency(const FrequencyConfig& config, const FrequencyMargins& margins);

} // namespace halbench::app
