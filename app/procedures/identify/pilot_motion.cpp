#include "app/procedures/identify/pilot_motion.h"

#include "app/procedures/identify/identify_estimate.h"

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double FirstPulse_s = 0.02;   // 2000 rad/s^2 stay below the published window of 40 rad/s
constexpr double LongestPulse_s = 0.16; // slower than what is fitted, or shorter than it has to be
constexpr double RunUp_s = 1.0;
constexpr double ShownShare = 0.12; // of the speed limit: enough to see, the next pulse stays far below it
constexpr double CalmShare = 0.75;  // of the speed limit that a calm motor reaches in a run-up, at most
constexpr double EndShare = 0.5;    // of the speed limit at which a run-up is ended
constexpr double FastShare = 0.4;   // of the speed limit: the next run-up could leave the window
constexpr double GoodEnough = 0.08; // of c/J, on which the dwell hangs

bool isGood(const std::optional<PilotEstimate>& estimate) {
    return estimate && estimate->dampingError_per_s < GoodEnough * estimate->damping_per_s;
}

} // namespace

PilotMotion::PilotMotion(devices::Device& device, const ProcedureObserver& observer,
                         const IdentifyConfig& config)
    : m_device(device), m_config(config),
      m_observer(observer), m_heat{config.pauseTemperature_degC, config.refuseTemperature_degC},
      m_sign(config.directions == SweepDirections::Reverse ? -1.0 : 1.0) {}

void PilotMotion::take(const SampleBlock& block) {
    m_watch.take(block);
    const int column = block.layout->indexOf("speed");
    if (column >= 0 && block.rows() > 0) {
        m_last_rad_s = std::fabs(block.value(block.rows() - 1, static_cast<std::size_t>(column)));
    }
    m_recording.append(block);
}

// From near rest: a rotor with little friction is given time to slow down.
Result<void> PilotMotion::drive(PlateauRun run) {
    constexpr double SlowShare = 0.05; // of the speed limit
    constexpr double GuardShare = 0.9;
    run.neverAbove_rad_s = GuardShare * m_config.speedLimit_rad_s;
    constexpr double Longest_s = 4.0;
    constexpr double Piece_s = 0.1;
    for (double waited_s = 0.0; m_last_rad_s > SlowShare * m_config.speedLimit_rad_s && waited_s < Longest_s;
         waited_s += Piece_s) {
        if (auto waited = waitObserved(m_device, m_observer, Piece_s, 0.0, 0.0, run.text); !waited) {
            return waited;
        }
    }
    m_start_rad_s = m_last_rad_s;
    const auto done = runPlateaus(m_device, m_observer, run, m_heat, m_watch);
    m_fastest_rad_s = std::max(m_fastest_rad_s, m_watch.highest_rad_s());
    return done ? Result<void>() : failure(done.error());
}

// Mean acceleration of the first pulse that shows it well, or of the longest; 0 at rest.
Result<double> PilotMotion::pulsedAcceleration_rad_s2(double current_A) {
    constexpr double Noise_rad_s = 0.3; // of the board's speed at rest
    double acceleration_rad_s2 = 0.0;
    for (double pulse_s = FirstPulse_s; pulse_s <= LongestPulse_s; pulse_s *= 2.0) {
        const PlateauRun pulse{
            {m_sign * current_A, 0.0, 0.0}, pulse_s, EndShare * m_config.speedLimit_rad_s, "first motion"};
        if (auto done = drive(pulse); !done) {
            return failure(done.error());
        }
        const double gained_rad_s = m_watch.highest_rad_s() - m_start_rad_s;
        acceleration_rad_s2 = gained_rad_s > Noise_rad_s ? gained_rad_s / pulse_s : 0.0;
        if (gained_rad_s > ShownShare * m_config.speedLimit_rad_s) {
            break;
        }
    }
    return acceleration_rad_s2;
}

std::optional<PilotEstimate> PilotMotion::estimate() const {
    const auto fits = fitRecording(m_recording, m_config);
    if (!fits || !fits->plainMotion || !fits->plainBalance || !fits->plainBalance->torque_rad_s2_A ||
        !(*fits->plainBalance->torque_rad_s2_A > 0.0)) {
        return std::nullopt;
    }
    return PilotEstimate{std::max(fits->plainMotion->damping_per_s, 0.0),
                         std::max(fits->plainBalance->friction_rad_s2.value_or(0.0), 0.0),
                         *fits->plainBalance->torque_rad_s2_A, fits->plainMotion->dampingError_per_s};
}

Result<std::optional<PilotEstimate>> PilotMotion::find(const std::vector<double>& currents_A) {
    const double first_A = currents_A.front() + 0.3 * (currents_A.back() - currents_A.front());
    const auto acceleration = pulsedAcceleration_rad_s2(first_A);
    if (!acceleration) {
        return failure(acceleration.error());
    }
    return *acceleration * RunUp_s > CalmShare * m_config.speedLimit_rad_s
               ? findLively(first_A, *acceleration, currents_A.back())
               : findCalm(currents_A);
}

// The dwell hangs on c/J: a slow first motion shows it poorly, a faster one better.
Result<std::optional<PilotEstimate>> PilotMotion::findCalm(const std::vector<double>& currents_A) {
    std::optional<PilotEstimate> found;
    for (const double share : {0.3, 0.6, 1.0}) {
        const double current_A = currents_A.front() + share * (currents_A.back() - currents_A.front());
        if (auto done = drive({{m_sign * current_A, 0.0, m_sign * current_A, 0.0},
                               RunUp_s,
                               EndShare * m_config.speedLimit_rad_s,
                               "first motion"});
            !done) {
            return failure(done.error());
        }
        found = estimate();
        if (isGood(found) || (found && m_watch.highest_rad_s() > FastShare * m_config.speedLimit_rad_s)) {
            return found;
        }
    }
    // It turned, but too slowly to tell torque from friction, as one low current does: the published
    // motor's figures plan the runs, whose speed is watched all the same.
    return found || m_fastest_rad_s <= m_config.usableSpeed_rad_s ? found : std::optional(nominalMotor());
}

// Accelerations under two currents, a gentle one and its double, show torque and friction roughly. Where the
// gentle one does not move the rotor, the line through both lies above the true one: a current chosen by it
// is never too high.
Result<PilotEstimate> PilotMotion::pulsedMotor(double current_A, double acceleration_rad_s2) {
    const double calm_rad_s2 = CalmShare * m_config.speedLimit_rad_s / RunUp_s;
    constexpr int MostHalvings = 12; // of the current: a speed that does not follow it shows no motor
    double gentle_rad_s2 = acceleration_rad_s2;
    for (int halving = 0; gentle_rad_s2 > calm_rad_s2; ++halving) {
        if (halving == MostHalvings) {
            return nominalMotor(); // the runs are watched all the same
        }
        acceleration_rad_s2 = gentle_rad_s2;
        current_A *= 0.5;
        const auto next = pulsedAcceleration_rad_s2(current_A);
        if (!next) {
            return failure(next.error());
        }
        gentle_rad_s2 = *next;
    }
    PilotEstimate rough = nominalMotor();
    if (!(acceleration_rad_s2 > gentle_rad_s2)) {
        return rough;
    }
    rough.torque_rad_s2_A = (acceleration_rad_s2 - gentle_rad_s2) / current_A;
    rough.friction_rad_s2 = std::max(rough.torque_rad_s2_A * current_A - gentle_rad_s2, 0.0);
    return rough;
}

Result<std::optional<PilotEstimate>> PilotMotion::findLively(double current_A, double acceleration_rad_s2,
                                                             double highest_A) {
    const auto rough = pulsedMotor(current_A, acceleration_rad_s2);
    if (!rough) {
        return failure(rough.error());
    }
    constexpr double Growth = 2.0; // of the drive, so that the next run-up is at most twice as fast
    constexpr int Attempts = 2;    // at the highest speed
    std::optional<PilotEstimate> found;
    double drive_rad_s2 = FastShare * m_config.speedLimit_rad_s / RunUp_s;
    for (int attempts = 0; !found && attempts < Attempts;) {
        const double wanted_A = (rough->friction_rad_s2 + drive_rad_s2) / rough->torque_rad_s2_A;
        const double run_A = m_sign * std::min(wanted_A, highest_A);
        if (auto done = drive({{run_A, 0.0, run_A, 0.0, run_A, 0.0},
                               RunUp_s,
                               CalmShare * m_config.speedLimit_rad_s,
                               "first motion"});
            !done) {
            return failure(done.error());
        }
        if (wanted_A < highest_A && m_watch.highest_rad_s() < FastShare * m_config.speedLimit_rad_s) {
            drive_rad_s2 *= Growth;
        } else {
            ++attempts;
            found = estimate();
        }
    }
    return found ? found : std::optional(*rough);
}

} // namespace halbench::app
