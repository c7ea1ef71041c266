#include "app/documents/text/result_text.h"

#include "app/procedures/tune/loop_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace halbench::app {

namespace {

std::string linesOf(const std::vector<Finding>& findings) {
    std::string text;
    for (const Finding& finding : findings) {
        text += fmt::format("  {}: {}; {}\n", finding.code, finding.message, finding.hint);
    }
    return text;
}

struct UnitSuffix {
    std::string_view suffix, unit;
};
/// An ending that is the end of another one comes after it.
constexpr std::array UnitSuffixes = {
    UnitSuffix{"_rad_s", "rad/s"}, UnitSuffix{"_m_s", "m/s"}, UnitSuffix{"_rad", "rad"},
    UnitSuffix{"_degC", "degC"},   UnitSuffix{"_deg", "deg"}, UnitSuffix{"_ratio", ""},
    UnitSuffix{"_percent", "%"},   UnitSuffix{"_A", "A"},     UnitSuffix{"_s", "s"},
    UnitSuffix{"_m", "m"},         UnitSuffix{"_Nm", "N*m"},  UnitSuffix{"_N", "N"},
};

std::string figureLine(std::string name, const JsonValue& value) {
    std::string_view unit;
    for (const UnitSuffix& known : UnitSuffixes) {
        if (name.size() > known.suffix.size() && std::string_view(name).ends_with(known.suffix)) {
            unit = known.unit;
            name.resize(name.size() - known.suffix.size());
            break;
        }
    }
    std::replace(name.begin(), name.end(), '_', ' ');
    if (!value.isNumber()) {
        return fmt::format("  {:<24} none\n", name);
    }
    return fmt::format("  {:<24} {:.6g}{}{}\n", name, value.number(), unit.empty() ? "" : " ", unit);
}

} // namespace

std::string findingLines(const DataQuality& quality) {
    return fmt::format("data quality: {}\n", verdictName(quality.verdict)) + linesOf(quality.findings);
}

std::string loopFindingLines(const DataQuality& quality, bool isRobustnessKnown) {
    return loopVerdict(quality.verdict, quality.findings, isRobustnessKnown) + '\n' +
           linesOf(quality.findings);
}

std::string figureLines(std::string_view heading, const JsonValue& figures) {
    std::string text = fmt::format("{}\n", heading);
    for (const JsonMember& figure : figures.members()) {
        if (figure.value.isNumber() || figure.value.isNull()) {
            text += figureLine(figure.key, figure.value);
        }
    }
    return text;
}

std::string estimateLine(std::string_view name, const control::Estimate& estimate) {
    if (!estimate.value) {
        return fmt::format("{:<14} {}\n", name, control::estimateSourceName(estimate.source));
    }
    const std::string interval =
        estimate.interval95
            ? fmt::format("  [{:.6g}, {:.6g}]", estimate.interval95->first, estimate.interval95->second)
            : std::string();
    return fmt::format("{:<14} {:.6g} {}{}  {}\n", name, *estimate.value, estimate.unit, interval,
                       control::estimateSourceName(estimate.source));
}

} // namespace halbench::app
