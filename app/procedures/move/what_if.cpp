#include "app/procedures/move/what_if.h"

#include "app/procedures/tune/large_step.h"
#include "control/assess/filtered_loop.h"
#include "control/assess/loop_rows.h"
#include "control/law/filtered_delta.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

/// A record that needs more is not of this motor with these gains: of a thousand that are, one does
/// (2 x 1.645 sigma), and another needs three times.
constexpr double Explained_ratio = 2.0;
constexpr double NotExplained_ratio = 3.0;
constexpr double NotableAmplification_ratio = 2.0;
constexpr std::size_t MostMotors = 300; ///< of those drawn: the 5th percentile is known to 1.3 %

std::vector<control::ReferencePoint> loopReference(const RecordedMove& move, double period_s) {
    const auto rowsPerPeriod = static_cast<std::size_t>(std::lround(period_s * 1e3));
    std::vector<double> value_rad;
    for (std::size_t row = 0; row < move.rows(); row += rowsPerPeriod) {
        value_rad.push_back(move.reference_rad[row]);
    }
    return control::referencePoints(value_rad, period_s);
}

/// The current that this motor needs beside the recorded one to move as it was recorded.
std::vector<double> disturbance_A(const MotionRemainder& remainder, const control::PositionPlant& plant) {
    std::vector<double> result(remainder.current_A.size());
    for (std::size_t row = 0; row < result.size(); ++row) {
        const double needed_A =
            (remainder.acceleration_rad_s2[row] + plant.dampingRate_1_s * remainder.speed_rad_s[row]) /
                plant.accelerationGain_rad_s2_A +
            plant.breakawayCurrent_A * remainder.direction_ratio[row] - remainder.current_A[row];
        result[row] = remainder.moving_ratio[row] * needed_A;
    }
    return result;
}

/// With the record's own disturbance; each motor needs another one, and two runs differ by the scatter of
/// both.
control::LoopReplay replayed(const WhatIfBasis& basis, const RunMotor& motor,
                             const control::SampledPositionLaw& law) {
    const std::vector<double> disturbed_A = disturbance_A(basis.remainder, motor.plant);
    RunMotor scattered = motor;
    scattered.friction_ratio = 1.0 + std::sqrt(2.0) * (motor.friction_ratio - 1.0);
    return replayRun(scattered, {law, basis.reference, disturbed_A, basis.config.move.rows()});
}

/// What the identification alone says of the move, without the record.
MotionEnvelope identifiedBand(const WhatIfBasis& basis, const control::SampledPositionLaw& law) {
    const std::size_t rows = basis.config.move.rows();
    return motionEnvelope(basis.motors, rows, [&](const RunMotor& motor) {
        return replayRun(motor, {law, basis.reference, {}, rows}).angle_rad;
    });
}

void judgeRecord(WhatIfBasis& basis, const control::SampledPositionLaw& ran) {
    basis.explained = identifiedBand(basis, ran);
    const std::vector<double>& recorded_rad = basis.config.move.position_rad;
    basis.widening_ratio = neededWidening_ratio(basis.explained, recorded_rad, basis.resolution_rad());
    const MotionEnvelope seen = widened(basis.explained, 1.0, basis.resolution_rad());
    std::size_t outside = 0;
    for (std::size_t i = 0; i < seen.time_s.size(); ++i) {
        const double angle_rad = recorded_rad[i * MotionEnvelopeStride];
        outside += angle_rad < seen.angle_rad.p5[i] || angle_rad > seen.angle_rad.p95[i] ? 1 : 0;
    }
    basis.outside_ratio = static_cast<double>(outside) / static_cast<double>(seen.time_s.size());
    if (basis.widening_ratio <= Explained_ratio) {
        return;
    }
    const bool isExplained = basis.widening_ratio <= NotExplained_ratio;
    basis.quality.verdict = isExplained ? Verdict::Doubtful : Verdict::Refused;
    basis.quality.findings.push_back(
        {isExplained ? "record_hardly_explained" : "record_not_explained",
         fmt::format("the model with the recorded gains does not match the recorded move: {:.0f} % outside "
                     "the predicted band",
                     100.0 * basis.outside_ratio),
         isExplained
             ? "the band is widened to contain the recording; identify the motor again for a better one"
             : "no prediction for other gains: identify the motor again, or use a recording of this motor "
               "with these gains"});
}

Result<control::SampledPositionLaw> admitted(const WhatIfBasis& basis, const LoopLaw& proposed) {
    if (basis.quality.verdict == Verdict::Refused) {
        const Finding& finding = basis.quality.findings.back();
        return failure(ErrorCode::Refused, finding.message, finding.hint);
    }
    const auto board = simulatedLaw(proposed, basis.config.conditions);
    if (!board) {
        return board;
    }
    const auto radius = control::filteredPoleRadius(basis.identified.plant, asFiltered(proposed),
                                                    basis.config.conditions.timing);
    if (!radius) {
        return failure(radius.error());
    }
    if (*radius >= 1.0) {
        return failure(ErrorCode::Refused, "the loop is unstable with these gains: no prediction",
                       "use stable gains");
    }
    return board;
}

/// What the model is wrong by moves the rotor by as much more as the peak of the sensitivity is higher: the
/// record has shown it only with the gains that ran.
double amplification(const WhatIfBasis& basis, const LoopLaw& proposed) {
    const auto peak = [&](const LoopLaw& law) {
        const auto loop =
            control::deltaOpenLoop(basis.identified.plant, asFiltered(law), basis.config.conditions.timing);
        const double margin = loop ? control::smallestMargins(*loop).modulusMargin : 0.0;
        return 1.0 / std::max(margin, 1e-3);
    };
    return std::max(1.0, peak(proposed) / peak(basis.config.ran));
}

WhatIf nominal(const WhatIfBasis& basis, const control::SampledPositionLaw& law) {
    control::LoopReplay replay = replayed(basis, basis.identified, law);
    return {std::move(replay.angle_rad), std::move(replay.current_A), {}, 1.0, basis.quality};
}

} // namespace

MotionFigures motionFigures(const std::vector<double>& reference_rad, const std::vector<double>& angle_rad) {
    MotionFigures figures;
    const std::size_t rows = std::min(reference_rad.size(), angle_rad.size());
    if (rows == 0) {
        return figures;
    }
    double square = 0.0;
    double beyond_rad = 0.0;
    const double end_rad = reference_rad[rows - 1];
    bool isLevel = end_rad != 0.0;
    for (std::size_t row = 0; row < rows; ++row) {
        const double error_rad = reference_rad[row] - angle_rad[row];
        square += error_rad * error_rad;
        beyond_rad = std::max(beyond_rad, std::copysign(1.0, end_rad) * -error_rad);
        isLevel = isLevel && reference_rad[row] == end_rad;
    }
    figures.rmsError_rad = std::sqrt(square / static_cast<double>(rows));
    figures.finalError_rad = end_rad - angle_rad[rows - 1];
    if (isLevel) {
        figures.overshoot_rad = beyond_rad;
    }
    return figures;
}

Result<WhatIfBasis> prepareWhatIf(WhatIfConfig config) {
    if (const double period_s = config.conditions.timing.period_s; !control::isWholeMilliseconds(period_s)) {
        return failure(
            ErrorCode::Refused,
            fmt::format("a recorded move has rows of 1 ms and cannot be replayed through a loop of {:.6g} ms",
                        1e3 * period_s),
            "what-if needs a sampling period of whole milliseconds");
    }
    const auto plant = plantFromEstimate(config.motor);
    if (!plant) {
        return failure(plant.error());
    }
    const auto ran = simulatedLaw(config.ran, config.conditions);
    if (!ran) {
        return failure(ran.error());
    }
    auto motors = drawRuns(config.motor, config.draws);
    if (!motors) {
        return failure(motors.error());
    }
    motors->resize(std::min(motors->size(), MostMotors));
    WhatIfBasis basis;
    basis.reference = loopReference(config.move, config.conditions.timing.period_s);
    basis.remainder = remainderOf(config.move);
    basis.identified.plant = *plant;
    basis.motors = *std::move(motors);
    basis.config = std::move(config);
    judgeRecord(basis, *ran);
    return basis;
}

Result<WhatIf> whatIf(const WhatIfBasis& basis, const LoopLaw& law) {
    const auto board = admitted(basis, law);
    return board ? Result<WhatIf>(nominal(basis, *board)) : Result<WhatIf>(failure(board.error()));
}

Result<WhatIf> whatIfWithBand(const WhatIfBasis& basis, const LoopLaw& law) {
    const auto board = admitted(basis, law);
    if (!board) {
        return failure(board.error());
    }
    WhatIf result = nominal(basis, *board);
    const MotionEnvelope disturbed =
        motionEnvelope(basis.motors, basis.config.move.rows(),
                       [&](const RunMotor& motor) { return replayed(basis, motor, *board).angle_rad; });
    result.amplification_ratio = amplification(basis, law);
    result.band =
        widened(hullOf(disturbed, identifiedBand(basis, *board)),
                std::max(1.0, basis.widening_ratio) * result.amplification_ratio, basis.resolution_rad());
    if (result.amplification_ratio > NotableAmplification_ratio) {
        result.quality.verdict = Verdict::Doubtful;
        result.quality.findings.push_back(
            {"gains_forgive_less",
             fmt::format("these gains amplify model errors {:.1f} times more than the recorded gains: the "
                         "band is wider by this factor",
                         result.amplification_ratio),
             "apply them gradually, or use gains with a larger modulus margin"});
    }
    return result;
}

} // namespace halbench::app
