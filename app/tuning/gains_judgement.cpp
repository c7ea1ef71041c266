#include "app/tuning/gains_judgement.h"

#include "app/documents/filtered_gains.h"
#include "app/documents/result_header.h"
#include "app/procedures/base/measured_timing.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr const char* UnnamedMethod = "file"; // of gains that do not say how they were found

bool isPresetItself(const GainsFile& gains, const TuneResult& judged) {
    const auto law = control::designLaw(gains.method, judged.plant, judged.conditions.timing, {});
    return law && !gains.filtered && isSameLaw(*law, gains.law);
}

} // namespace

Result<TuneResult> judgeGains(const GainsFile& gains, const MotorEstimate& estimate,
                              const LoopConditions& conditions, const JudgedWith& with) {
    TuneConfig config;
    config.method = gains.method.empty() ? UnnamedMethod : gains.method;
    config.targets = gains.targets;
    config.conditions = conditions;
    config.seed = with.seed;
    config.load_A = with.load_A;
    auto judged = judgeLaw(estimate, gains.loopLaw(), config);
    if (judged && !judged->predicted.isStable && !isPresetItself(gains, *judged)) {
        judged->quality.verdict = Verdict::Refused;
    }
    return judged;
}

std::optional<Finding> foreignGains(const GainsFile& gains, const devices::DeviceInfo& device) {
    if (!foreignMotor(gains.device, device)) {
        return std::nullopt;
    }
    const bool isNamed = gains.device->model != device.model || gains.device->id != device.id;
    return Finding{"other_device",
                   isNamed ? fmt::format("the gains were found for the {} '{}', this device is the {} '{}'",
                                         gains.device->model, gains.device->id, device.model, device.id)
                           : fmt::format("the gains were found for '{}' with other overrides than this "
                                         "device has",
                                         gains.device->id),
                   "identify this device and use its model for tuning"};
}

std::optional<Finding> otherTiming(const control::LoopTiming& designed, const control::LoopTiming& now) {
    if (isSameTiming(designed, now)) {
        return std::nullopt;
    }
    return Finding{"other_timing",
                   fmt::format("gains for {:.4g} s and {} samples of delay, this device has {:.4g} s and {}: "
                               "assessed for this device",
                               designed.period_s, designed.delay_samples, now.period_s, now.delay_samples),
                   "design them for the timing of this device"};
}

Result<void> checkPeriodOfGains(const control::LoopTiming& designed, const control::LoopTiming& device) {
    if (isSamePeriod(designed.period_s, device.period_s)) {
        return {};
    }
    return failure(ErrorCode::Refused,
                   fmt::format("the gains are for a sampling period of {:.4g} s, this device has {:.4g} s",
                               designed.period_s, device.period_s),
                   "design them for the timing of this device");
}

void addOtherTiming(TuneResult& result, const Finding& finding) {
    result.quality.verdict = std::max(result.quality.verdict, Verdict::Doubtful);
    addFinding(result, finding);
}

void addFinding(TuneResult& result, const Finding& finding) {
    result.quality.findings.push_back(finding);
    result.warnings.push_back(finding);
}

Result<void> checkJudgement(const TuneResult& result) {
    if (result.quality.verdict != Verdict::Refused) {
        return {};
    }
    const auto& findings = result.quality.findings;
    const auto unstable = std::find_if(findings.begin(), findings.end(),
                                       [](const Finding& finding) { return finding.code == "unstable"; });
    const bool isKnown = unstable != findings.end();
    return failure(ErrorCode::Refused,
                   isKnown ? unstable->message + "; nothing was written"
                           : std::string("these gains are rejected; nothing was written"),
                   isKnown ? unstable->hint : std::string("check their findings"));
}

} // namespace halbench::app
