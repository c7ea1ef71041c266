#pragma once

#include "app/documents/model_file.h"
#include "app/procedures/tune/tune.h"

#include <optional>

namespace halbench::app {

/// Settings of a judgement of gains.
struct JudgedWith {
    std::uint64_t seed = 1; ///< of the drawn motors
    double load_A = DisturbanceLoad_A;
};

/// Gains of a file as designed ones are judged: the same proof, the same robustness, the same refusals. That
/// a file names a preset lets it show an unstable loop only when it holds that preset's gains. Errors: of
/// `judgeLaw`.
Result<TuneResult> judgeGains(const GainsFile& gains, const MotorEstimate& estimate,
                              const LoopConditions& conditions, const JudgedWith& with);

/// Finding about gains of another device than this one; a file that names none is not compared.
std::optional<Finding> foreignGains(const GainsFile& gains, const devices::DeviceInfo& device);

/// A loop that samples or waits otherwise than the one that was designed for.
std::optional<Finding> otherTiming(const control::LoopTiming& designed, const control::LoopTiming& now);

/// Gains are sampled with the period they were written for: on a device with another one they are another
/// loop. Error: Refused, with both.
Result<void> checkPeriodOfGains(const control::LoopTiming& designed, const control::LoopTiming& device);

/// Adds what otherTiming() found: such gains are doubtful at best.
void addOtherTiming(TuneResult& result, const Finding& finding);

/// A finding that is told with the gains and with what is thought of them.
void addFinding(TuneResult& result, const Finding& finding);

/// Gains that may be written: not refused, and run by a board. Errors: Refused, with the first finding;
/// InvalidInput.
Result<void> checkJudgement(const TuneResult& result);

} // namespace halbench::app
