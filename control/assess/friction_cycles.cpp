#include "control/assess/friction_cycles.h"

#include "control/analysis/frequency_scan.h"
#include "control/base/assert.h"
#include "control/base/units.h"
#include "control/law/board_gains.h"
#include "control/law/filtered_delta.h"
#include "control/lti/frequency_response.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace halbench::control {

namespace {

using Complex = std::complex<double>;

/// What a trial frequency demands: the amplitude whose friction gives the loop the phase of -180 degrees, and
/// how far its gain then is from one (logarithm).
struct Trial {
    double amplitude_rad = 0.0;
    double excess_log = 0.0;
};

class Balance {
public:
    Balance(const PositionPlant& plant, const DeltaSystem& controller, const LoopTiming& timing,
            double currentLimit_A)
        : m_plant(plant), m_controller(controller), m_timing(timing), m_limit_A(currentLimit_A) {}

    std::optional<Trial> at(double frequency_rad_s) const {
        const double a = m_plant.dampingRate_1_s;
        const double most_1_s = 1e3 / m_timing.period_s;
        const auto lead_rad = [&](double damping_1_s) {
            return std::arg(-loop(frequency_rad_s, damping_1_s));
        };
        if ((lead_rad(a) < 0.0) == (lead_rad(most_1_s) < 0.0)) {
            return std::nullopt;
        }
        const double damping_1_s = rootBetween(lead_rad, a, most_1_s);
        if (std::abs(lead_rad(damping_1_s)) > 0.1) {
            return std::nullopt; // the phase jumped by a turn
        }
        const double friction_rad_s2 = m_plant.accelerationGain_rad_s2_A * m_plant.breakawayCurrent_A;
        // 4 f/(pi A w) = damping - a
        const double amplitude_rad = 4.0 * friction_rad_s2 / (Pi * frequency_rad_s * (damping_1_s - a));
        const double asked_A = amplitude_rad * std::abs(m_controller.atFrequency(frequency_rad_s));
        const double gain = saturationGain(asked_A, m_limit_A);
        return Trial{amplitude_rad, std::log(gain * std::abs(loop(frequency_rad_s, damping_1_s)))};
    }

private:
    Complex loop(double frequency_rad_s, double damping_1_s) const {
        const PositionPlant damped{damping_1_s, m_plant.accelerationGain_rad_s2_A, 0.0};
        const double T = m_timing.period_s;
        return m_controller.atFrequency(frequency_rad_s) *
               sampledPlant(damped, T).atFrequency(frequency_rad_s) *
               std::polar(1.0, -frequency_rad_s * T * m_timing.delay_samples);
    }

    const PositionPlant& m_plant;
    const DeltaSystem& m_controller;
    const LoopTiming& m_timing;
    double m_limit_A;
};

} // namespace

double breakLooseTime_s(const PositionPlant& plant, const PidGains& gains, double error_rad,
                        double staticRatio) {
    const auto board = convert(gains, PidForm::Parallel, GainUnit::PerRadian);
    HB_ASSERT(board.has_value() && staticRatio >= 1.0);
    const double error = std::abs(error_rad);
    const double missing_A = staticRatio * plant.breakawayCurrent_A - board->proportional * error;
    if (missing_A <= 0.0) {
        return 0.0;
    }
    const double rate_A_s = board->integral * error;
    return rate_A_s > 0.0 ? missing_A / rate_A_s : std::numeric_limits<double>::infinity();
}

Result<std::vector<LimitCycle>> frictionCycles(const PositionPlant& plant, const PidGains& gains,
                                               const LoopTiming& timing, double currentLimit_A) {
    if (const auto valid = checkTiming(timing); !valid) {
        return failure(valid.error());
    }
    const auto board = boardGains(gains);
    if (!board) {
        return failure(board.error());
    }
    FilteredLaw law;
    law.gains = *board;
    const auto controller = deltaController(law, timing.period_s);
    return controller ? frictionCycles(plant, *controller, timing, currentLimit_A)
                      : Result<std::vector<LimitCycle>>(failure(controller.error()));
}

Result<std::vector<LimitCycle>> frictionCycles(const PositionPlant& plant, const DeltaSystem& controller,
                                               const LoopTiming& timing, double currentLimit_A) {
    for (const auto& valid : {checkPlant(plant), checkTiming(timing)}) {
        if (!valid) {
            return failure(valid.error());
        }
    }
    if (!(std::isfinite(currentLimit_A) && currentLimit_A > 0.0)) {
        return failure(
            ErrorCode::OutOfRange,
            "the limit or level of a nonlinear element must be positive, its hysteresis not negative");
    }
    const Balance balance(plant, controller, timing, currentLimit_A);
    const double nyquist_rad_s = Pi / timing.period_s;
    std::vector<LimitCycle> cycles;
    std::optional<Trial> before;
    double beforeFrequency = 0.0;
    for (const double frequency : logarithmicFrequencies(1e-3 * nyquist_rad_s, 0.999 * nyquist_rad_s, 2000)) {
        const auto here = balance.at(frequency);
        if (here && before && (here->excess_log < 0.0) != (before->excess_log < 0.0)) {
            const auto excess = [&](double w) {
                const auto trial = balance.at(w);
                return trial ? trial->excess_log : 0.0;
            };
            const double found = rootBetween(excess, beforeFrequency, frequency);
            if (const auto trial = balance.at(found); trial && std::abs(trial->excess_log) < 1e-6) {
                cycles.push_back({trial->amplitude_rad, found, false});
            }
        }
        before = here;
        beforeFrequency = frequency;
    }
    std::sort(cycles.begin(), cycles.end(),
              [](const LimitCycle& a, const LimitCycle& b) { return a.amplitude < b.amplitude; });
    // Friction stills the smallest motion and the limit bounds the largest: from threshold to cycle in turn.
    for (std::size_t i = 0; i < cycles.size(); ++i) {
        cycles[i].isStable = i % 2 == 1;
    }
    return cycles;
}

} // namespace halbench::control
