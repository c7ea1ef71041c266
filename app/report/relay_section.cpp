#include "app/report/report_blocks.h"
#include "app/report/step_sections.h"
#include "control/base/units.h"

#include <fmt/format.h>

namespace halbench::app {
namespace {

ReportEstimate row(const std::string& name, const control::Estimate& estimate) {
    const auto interval = estimate.interval95;
    return {name,
            estimate.unit,
            estimate.value,
            interval ? std::optional(interval->first) : std::nullopt,
            interval ? std::optional(interval->second) : std::nullopt,
            control::estimateSourceName(estimate.source)};
}

std::string modelWords(const RelayResult& result) {
    const RelayPrediction& predicted = result.plan.predicted;
    const std::string value = fmt::format("{:.4g} A/rad", predicted.at.gain);
    switch (result.agreement) {
    case RelayAgreement::Agrees:
        return value + ", agrees";
    case RelayAgreement::Disagrees:
        return value + ", disagrees";
    case RelayAgreement::Unknown:
        break;
    }
    return value + (predicted.isOfThisMotor ? ", without an interval" : ", the published motor's");
}

ReportFacts factsOf(const RelayResult& result) {
    const auto fact = [](const char* name, std::string value) {
        return ReportFacts::Fact{name, std::move(value), ReportTone::Plain};
    };
    ReportFacts facts{
        {fact("ultimate gain of the model", modelWords(result)),
         fact("cycles", fmt::format("{} of {:.3g}\u00b0 and {:.3g} A at {:.4g} rad/s", result.cycle.cycles,
                                    radiansToDegrees(result.cycle.amplitude), result.cycle.input,
                                    result.cycle.frequency_rad_s)),
         fact("speed",
              fmt::format("{:.2f} to {:.2f} rad/s", result.lowestSpeed_rad_s, result.highestSpeed_rad_s)),
         fact("duration", fmt::format("{:.1f} s", result.duration_s))}};
    facts.addMeasured("highest coil temperature", result.highestTemperature_degC, 1, "\u00b0C");
    return facts;
}

} // namespace

ReportSection relaySection(const std::string& heading, const RelayResult& result) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(ReportQuality{result.quality});
    section.blocks.emplace_back(
        estimateTable("Ultimate gain and period", {row("ultimate gain", ultimateGainOf(result)),
                                                   row("ultimate period", ultimatePeriodOf(result))}));
    section.blocks.emplace_back(factsOf(result));
    return section;
}

} // namespace halbench::app
