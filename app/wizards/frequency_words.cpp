#include "app/wizards/frequency_words.h"

#include "app/procedures/frequency/frequency_board.h"
#include "control/base/unit_text.h"
#include "control/base/units.h"
#include "widgets/controls/progress_row.h"
#include "widgets/language/display_units.h"
#include "widgets/language/unbroken.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

using control::MeasuredMargin;

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::FrequencyWords)
};

QString number(double value, int decimals) {
    return widgets::fixedText(value, decimals);
}

QString withheldReason(const MeasuredMargin& margin) {
    switch (margin.withheld) {
    case MeasuredMargin::Withheld::NoCrossing:
        return Words::tr("withheld: crosses nowhere");
    case MeasuredMargin::Withheld::Gap:
        return Words::tr("withheld: crosses in a gap");
    case MeasuredMargin::Withheld::Uncertain:
        return Words::tr("withheld: too uncertain");
    case MeasuredMargin::Withheld::No:
        break;
    }
    return {};
}

widgets::EstimateRow marginRow(const QString& name, const MeasuredMargin& margin, const QString& unit) {
    widgets::EstimateRow row;
    row.name = name;
    row.unit = unit;
    if (!margin.value) {
        row.source = withheldReason(margin);
        row.remark = Words::tr("The findings above say why, and what helps");
        return row;
    }
    row.value = margin.value;
    row.low95 = margin.interval->first;
    row.high95 = margin.interval->second;
    row.source = Words::tr("measured");
    row.remark =
        Words::tr("where the loop crosses, at %1 Hz").arg(number(*margin.frequency_rad_s / (2.0 * Pi), 2));
    return row;
}

widgets::EstimateRow rotorRow(const QString& name, const control::Estimate& estimate) {
    widgets::EstimateRow row;
    row.name = name;
    row.value = estimate.value;
    row.low95 = estimate.interval95->first;
    row.high95 = estimate.interval95->second;
    row.unit = QString::fromStdString(unitText(estimate.unit));
    row.source = Words::tr("fitted");
    return row;
}

} // namespace

FrequencyMargins frequencyOutlookMargins(const devices::Catalogue& catalogue,
                                         const std::map<std::string, double>& deviceValues) {
    control::SampledPositionLaw law;
    int delay_samples = law.delaySamples;
    const auto take = [&](const char* role, auto& target) {
        const auto found = deviceValues.find(catalogue.parameterForRole(role));
        if (found != deviceValues.end() && std::isfinite(found->second)) {
            target = static_cast<std::decay_t<decltype(target)>>(found->second);
        }
    };
    take("gain.kp", law.kp_A_per_rad);
    take("gain.ki", law.ki_A_per_rad_s);
    take("gain.kd", law.kd_As_per_rad);
    take("feedforward.inertia", law.inertia_As2_per_rad);
    take("feedforward.viscous", law.viscous_As_per_rad);
    take("limit.current", law.limit_A);
    take("delay.samples", delay_samples);
    law.delaySamples = delay_samples;
    return frequencyMargins(catalogue, law);
}

QString frequencyOutlook(const FrequencyConfig& config, const FrequencyPlan& plan, double warmest_degC) {
    double swing_rad = 0.0;
    for (const FrequencyStage& stage : plan.stages) {
        swing_rad = std::max(swing_rad, stage.reference.amplitude);
    }
    const double speed_rad_s = std::abs(plan.turn_rad_s);
    const double turns = speed_rad_s * plan.duration_s() / (2.0 * Pi);
    QString text =
        (plan.turn_rad_s < 0.0
             ? Words::tr("The rotor will turn in reverse at %1 rad/s (%2 r/min), about %3 turns, for "
                         "%4 minutes of device time.")
             : Words::tr("The rotor will turn forward at %1 rad/s (%2 r/min), about %3 turns, for %4 "
                         "minutes of device time."))
            .arg(number(speed_rad_s, 1), number(radPerSecondToRpm(speed_rad_s), 0),
                 number(std::round(turns / 10.0) * 10.0, 0), widgets::durationText(plan.duration_s()));
    text += QLatin1Char('\n');
    text += Words::tr("On top of that it is excited by up to %1°; its speed never changes sign, and the "
                      "run ends where it comes near zero.")
                .arg(number(radiansToDegrees(swing_rad), 2));
    text += QLatin1Char('\n');
    text += Words::tr("Current up to %1 A, coils up to %2 °C.")
                .arg(number(plan.peakCurrent_A, 1), number(warmest_degC, 0));
    text += QLatin1Char(' ');
    text +=
        Words::tr("The board ends the motion at %1 rad/s. The gains on the board stay and are measured with; "
                  "all else is restored whatever happens.")
            .arg(number(config.speedLimit_rad_s, 0));
    return widgets::withUnitsKept(text);
}

std::vector<widgets::EstimateRow> frequencyRows(const FrequencyResult& result) {
    std::vector<widgets::EstimateRow> rows = {
        marginRow(Words::tr("phase margin"), result.margins.phase_deg, QStringLiteral("\u00b0")),
        marginRow(Words::tr("gain margin"), result.margins.gain_dB, QStringLiteral("dB"))};
    if (result.fit) {
        rows.push_back(rotorRow(QStringLiteral("c/J"), result.fit->dampingRate));
        rows.push_back(rotorRow(QStringLiteral("\u03c6/J"), result.fit->accelerationGain));
        rows.push_back(rotorRow(QStringLiteral("\u03ba"), result.fit->feedthrough));
        rows.back().remark = Words::tr("angle that follows the current at once");
    }
    return rows;
}

QString frequencyUse(const FrequencyResult& result) {
    const auto used = std::count_if(result.points.begin(), result.points.end(),
                                    [](const FrequencyResultPoint& point) { return point.isUsed; });
    QStringList lines = {
        Words::tr("%1 of %2 frequencies have a coherence of %3 or more; the others are faint and part "
                  "of no margin and no fit.")
            .arg(used)
            .arg(result.points.size())
            .arg(number(result.config.leastCoherence, 3))};
    for (const FrequencyBand& band : result.bands) {
        if (band.from_Hz < band.to_Hz) {
            lines << Words::tr("%1 to %2 Hz: amplitude %3°")
                         .arg(number(band.from_Hz, 2), number(band.to_Hz, 2),
                              number(radiansToDegrees(band.amplitude_rad), 3));
        }
    }
    lines << Words::tr("While excited the rotor never turned slower than %1 rad/s.")
                 .arg(number(result.lowestSpeed_rad_s, 2));
    return lines.join(QLatin1Char('\n'));
}

} // namespace halbench::app
