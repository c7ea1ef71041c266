#pragma once

#include "control/analysis/margins.h"
#include "control/base/result.h"
#include "control/law/position_loop.h"

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <vector>

namespace halbench::control {

/// Many motors under one law, looked at together: one plant a lane, so that what they share is computed once
/// and the rest in step. Each loop is controller, delay and
///   P(z) = k (b1 z + b2)/((z - 1)(z - E)),  E = e^(-a T)
/// as `sampledOpenLoop` has it; the answers are those of the loops one by one to rounding.
class LoopBatch {
public:
    /// Plants that are no motor have no lane. Errors: of gains and timing; Refused (no motor among them).
    static Result<LoopBatch> make(const std::vector<PositionPlant>& plants, const PidGains& gains,
                                  const LoopTiming& timing);

    std::size_t size() const { return static_cast<std::size_t>(m_gain.size()); }
    /// Which plant a lane is of.
    const std::vector<std::size_t>& plantOfLane() const { return m_plantOfLane; }
    const PositionPlant& plant(std::size_t lane) const { return m_plants[lane]; }
    const std::vector<PositionPlant>& plants() const { return m_plants; } ///< lane by lane
    const PidGains& gains() const { return m_gains; }
    const LoopTiming& timing() const { return m_timing; }

    /// What all lanes have in common, C(z) z^-delay/(z - 1) at z = e^(i w T).
    std::complex<double> common(double frequency_rad_s) const;
    /// The rest of one lane: k (b1 z + b2)/(z - E).
    std::complex<double> rest(std::size_t lane, double frequency_rad_s) const;
    /// The same of all lanes: real and imaginary part.
    void rest(double frequency_rad_s, Eigen::ArrayXd& real, Eigen::ArrayXd& imaginary) const;

    /// The open loop of one lane.
    std::complex<double> loop(std::size_t lane, double frequency_rad_s) const {
        return common(frequency_rad_s) * rest(lane, frequency_rad_s);
    }

private:
    std::vector<PositionPlant> m_plants;
    std::vector<std::size_t> m_plantOfLane;
    PidGains m_gains; ///< of the board
    LoopTiming m_timing;
    Eigen::ArrayXd m_gain;  ///< k b1, the first numerator coefficient
    Eigen::ArrayXd m_gain2; ///< k b2
    Eigen::ArrayXd m_decay; ///< E
    Eigen::ArrayXd m_rate;  ///< 1 - E, to its last digit
};

/// One motor as the uncertainty judges it.
struct BatchVerdict {
    bool isStable = false;
    StabilityMargins margins;
};
/// Of every lane what `poleRadius` and `smallestMargins` say of its loop. O(lanes x frequencies), some
/// microseconds a lane.
std::vector<BatchVerdict> judgeBatch(const LoopBatch& batch);

} // namespace halbench::control
