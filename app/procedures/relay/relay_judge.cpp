#include "app/procedures/relay/relay_judge.h"

#include "app/procedures/base/coil_forecast.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double MostGrowth_ratio = 1.15; // of the amplitude, from the first third to the last
constexpr double MostScatter_ratio =
    0.04; // of the cycle's frequency; less than half of what the base motion weaves
constexpr double DoubtfulHalf_ratio = 0.10; // of the ultimate gain
constexpr double RefusedHalf_ratio = 0.30;

Result<void> checkRows(const RelayRun& run) {
    const std::vector<double>& time_s = run.recording.time_s;
    const bool isThere = run.firstRow + 1 < run.endRow && run.endRow <= time_s.size();
    const double expected_s = static_cast<double>(run.endRow - run.firstRow - 1) * run.period_s;
    if (!isThere ||
        std::abs(time_s[run.endRow - 1] - time_s[run.firstRow] - expected_s) > 0.5 * run.period_s) {
        return failure(
            withCause({ErrorCode::Refused, "rows missing: the cycles are not consistent", "measure again"},
                      run.rowLoss));
    }
    return {};
}

void takeFigures(RelayResult& result, const RelayRun& run) {
    const Recording& recording = run.recording;
    result.duration_s = recording.time_s.back() - recording.time_s.front();
    const std::string coils[] = {"coil_temperature.a", "coil_temperature.b"};
    result.highestTemperature_degC = highestCoil_degC(coils, recording);
    const std::vector<double> speed_rad_s = recording.column("speed");
    const double sign = run.plan.turn_rad_s < 0.0 ? -1.0 : 1.0;
    result.lowestSpeed_rad_s = result.highestSpeed_rad_s = std::abs(run.plan.turn_rad_s);
    for (std::size_t row = run.firstRow; row < run.endRow && row < speed_rad_s.size(); ++row) {
        result.lowestSpeed_rad_s = std::min(result.lowestSpeed_rad_s, sign * speed_rad_s[row]);
        result.highestSpeed_rad_s = std::max(result.highestSpeed_rad_s, sign * speed_rad_s[row]);
    }
}

double halfWidth_ratio(const control::UltimateEstimate& ultimate) {
    return 0.5 * (ultimate.gain95.second - ultimate.gain95.first) / ultimate.at.gain;
}

void refuse(RelayResult& result, Finding finding) {
    result.quality.verdict = Verdict::Refused;
    result.quality.findings.push_back(std::move(finding));
}

void doubt(RelayResult& result, Finding finding) {
    result.quality.verdict = std::max(result.quality.verdict, Verdict::Doubtful);
    result.quality.findings.push_back(std::move(finding));
}

void judgeCycle(RelayResult& result) {
    const double growth = result.cycle.growth_ratio;
    if (!(result.cycle.frequencyScatter_ratio <= MostScatter_ratio)) {
        refuse(result, {"cycle_follows_turn",
                        fmt::format("frequency drift of the oscillation {:.2g} %: excited by angle errors "
                                    "during rotation, allowed {:.2g} %",
                                    100.0 * result.cycle.frequencyScatter_ratio, 100.0 * MostScatter_ratio),
                        "calibrate the sensors, apply the calibration, then measure again"});
    } else if (!(growth < MostGrowth_ratio && growth > 1.0 / MostGrowth_ratio)) {
        refuse(result,
               {"cycle_not_settled",
                fmt::format("amplitude change of the oscillation {:.3g} % from the first third to the last",
                            100.0 * (growth - 1.0)),
                "measure more cycles or use a larger relay gain; calibrate the sensors first"});
    }
}

void judgeGain(RelayResult& result) {
    const control::UltimateEstimate& ultimate = *result.ultimate;
    const double half = halfWidth_ratio(ultimate);
    if (!(half <= RefusedHalf_ratio)) {
        refuse(result, {"ultimate_gain_uncertain",
                        fmt::format("ultimate gain between {:.3g} and {:.3g} A/rad: too uncertain",
                                    ultimate.gain95.first, ultimate.gain95.second),
                        "measure more cycles; calibrate the sensors first"});
    } else if (half > DoubtfulHalf_ratio) {
        doubt(result, {"ultimate_gain_uncertain",
                       fmt::format("uncertainty of the ultimate gain {:.2g} %", 100.0 * half),
                       "measure more cycles; calibrate the sensors first"});
    }
}

void judgeAgreement(RelayResult& result) {
    const auto& predicted95 = result.plan.predicted.gain95;
    if (!predicted95) {
        return;
    }
    const auto [low, high] = result.ultimate->gain95;
    const bool isApart = low > predicted95->second || high < predicted95->first;
    result.agreement = isApart ? RelayAgreement::Disagrees : RelayAgreement::Agrees;
    if (isApart) {
        doubt(result,
              {"disagrees_with_model",
               fmt::format("ultimate gain of the model {:.4g} to {:.4g} A/rad, measured {:.4g} to {:.4g}",
                           predicted95->first, predicted95->second, low, high),
               "identify the motor again: it changed, or one of the results is wrong"});
    }
}

} // namespace

Result<RelayResult> estimateRelay(RelayRun run) {
    if (auto whole = checkRows(run); !whole) {
        return failure(whole.error());
    }
    RelayResult result;
    result.config = run.config;
    result.plan = run.plan;
    result.period_s = run.period_s;
    result.delaySamples = run.delaySamples;
    const std::vector<double> reference = run.recording.column("reference");
    const std::vector<double> input = run.recording.column("current_command");
    const std::vector<double> output = run.recording.column("position");
    const auto part = [&](const std::vector<double>& column) {
        return std::span(column).subspan(run.firstRow, run.endRow - run.firstRow);
    };
    const auto cycle =
        control::estimateLimitCycle({run.period_s, part(reference), part(input), part(output)});
    if (!cycle) {
        return failure(cycle.error());
    }
    result.cycle = *cycle;
    control::CycleLoop loop;
    loop.period_s = run.period_s;
    loop.delay_samples = run.delaySamples;
    loop.lag_s = run.config.actuatorLag_s;
    loop.gainError_ratio = run.config.gainError_ratio;
    const auto ultimate = control::ultimateOfCycle(*cycle, loop);
    if (ultimate) {
        result.ultimate = *ultimate;
    } else {
        refuse(result, {"no_ultimate_gain", ultimate.error().message, ultimate.error().hint});
    }
    takeFigures(result, run);
    result.recording = std::move(run.recording);
    return result;
}

void judgeRelay(RelayResult& result) {
    judgeCycle(result);
    if (result.ultimate) {
        judgeGain(result);
    }
    if (result.quality.verdict == Verdict::Refused) {
        result.ultimate.reset(); // what is refused is not told
        return;
    }
    judgeAgreement(result);
    if (result.agreement == RelayAgreement::Unknown) {
        result.quality.findings.push_back(
            {"model_without_interval",
             result.plan.predicted.isOfThisMotor
                 ? "agreement with the model unknown: the model has no covariance"
                 : "not compared with a model of this motor",
             "identify the motor and give its model"});
    }
}

} // namespace halbench::app
