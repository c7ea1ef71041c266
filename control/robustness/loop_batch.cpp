#include "control/robustness/loop_batch.h"

#include "control/law/board_gains.h"
#include "control/law/sampled_axis.h"

#include <cmath>

namespace halbench::control {

Result<LoopBatch> LoopBatch::make(const std::vector<PositionPlant>& plants, const PidGains& gains,
                                  const LoopTiming& timing) {
    if (const auto valid = checkTiming(timing); !valid) {
        return failure(valid.error());
    }
    const auto board = boardGains(gains);
    if (!board) {
        return failure(board.error());
    }
    LoopBatch batch;
    batch.m_gains = *board;
    batch.m_timing = timing;
    for (std::size_t i = 0; i < plants.size(); ++i) {
        if (checkPlant(plants[i])) {
            batch.m_plants.push_back(plants[i]);
            batch.m_plantOfLane.push_back(i);
        }
    }
    if (batch.m_plants.empty()) {
        return failure(ErrorCode::Refused, "no valid motor among the samples", "identify the motor again");
    }
    const auto lanes = static_cast<Eigen::Index>(batch.m_plants.size());
    for (Eigen::ArrayXd* array : {&batch.m_gain, &batch.m_gain2, &batch.m_decay, &batch.m_rate}) {
        array->resize(lanes);
    }
    for (Eigen::Index i = 0; i < lanes; ++i) {
        const PositionPlant& plant = batch.m_plants[static_cast<std::size_t>(i)];
        const double x = plant.dampingRate_1_s * timing.period_s;
        const double scale = plant.accelerationGain_rad_s2_A * timing.period_s * timing.period_s;
        batch.m_gain[i] = scale * heldAngleShare(x);
        batch.m_gain2[i] = scale * (heldSpeedShare(x) - heldAngleShare(x));
        batch.m_rate[i] = -std::expm1(-x);
        batch.m_decay[i] = 1.0 - batch.m_rate[i];
    }
    return batch;
}

std::complex<double> LoopBatch::common(double frequency_rad_s) const {
    const double T = m_timing.period_s;
    const double half_rad = 0.5 * frequency_rad_s * T;
    // z - 1 = 2 i sin(w T/2) e^(i w T/2): nothing cancels at low frequency.
    const std::complex<double> turn = std::polar(1.0, half_rad);
    const std::complex<double> z = turn * turn;
    const std::complex<double> difference = std::complex<double>(0.0, 2.0 * std::sin(half_rad)) * turn;
    const std::complex<double> inverse = std::conj(difference) / std::norm(difference);
    const std::complex<double> integral = T * m_gains.integral * inverse;
    const std::complex<double> derivative = m_gains.derivative / T * difference * std::conj(z);
    std::complex<double> value = (m_gains.proportional + integral + derivative) * inverse;
    for (int i = 0; i < m_timing.delay_samples; ++i) {
        value *= std::conj(z);
    }
    return value;
}

std::complex<double> LoopBatch::rest(std::size_t lane, double frequency_rad_s) const {
    const auto i = static_cast<Eigen::Index>(lane);
    const double half_rad = 0.5 * frequency_rad_s * m_timing.period_s;
    const double sine = std::sin(half_rad);
    const double s = 2.0 * sine * std::cos(half_rad);
    const double c = 1.0 - 2.0 * sine * sine;
    const double away = m_rate[i] - 2.0 * sine * sine; // c - E
    const double number = 1.0 / (away * away + s * s);
    const double level = m_gain[i] * c + m_gain2[i];
    return {(level * away + m_gain[i] * s * s) * number, -s * (m_gain[i] * m_decay[i] + m_gain2[i]) * number};
}

void LoopBatch::rest(double frequency_rad_s, Eigen::ArrayXd& real, Eigen::ArrayXd& imaginary) const {
    const double half_rad = 0.5 * frequency_rad_s * m_timing.period_s;
    const double sine = std::sin(half_rad);
    const double s = 2.0 * sine * std::cos(half_rad);
    const double drop = 2.0 * sine * sine; // 1 - cos
    const double c = 1.0 - drop;
    // (b1 z + b2) conj(z - E), over |z - E|^2
    real = m_rate - drop;
    imaginary = 1.0 / (real * real + s * s);
    real = ((m_gain * c + m_gain2) * real + m_gain * (s * s)) * imaginary;
    imaginary *= -s * (m_gain * m_decay + m_gain2);
}

} // namespace halbench::control
