#include "app/wizards/relay_text.h"

#include "app/wizards/turn_text.h"
#include "control/base/unit_text.h"
#include "control/base/units.h"
#include "widgets/controls/progress_row.h"
#include "widgets/language/display_units.h"
#include "widgets/language/unbroken.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace halbench::app {
namespace {

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::RelayWords)
};

QString number(double value, int decimals) {
    return widgets::fixedText(value, decimals);
}

widgets::EstimateRow row(const QString& name, const control::Estimate& estimate) {
    widgets::EstimateRow row;
    row.name = name;
    row.unit = QString::fromStdString(unitText(estimate.unit));
    row.value = estimate.value;
    if (estimate.interval95) {
        row.low95 = estimate.interval95->first;
        row.high95 = estimate.interval95->second;
    }
    row.source = estimate.value ? Words::tr("measured") : Words::tr("refused");
    row.remark = estimate.value ? QString() : Words::tr("See the findings above for cause and remedy");
    return row;
}

widgets::EstimateRow modelRow(const RelayPrediction& predicted) {
    widgets::EstimateRow row;
    row.name = Words::tr("ultimate gain of the model");
    row.unit = QString::fromStdString(unitText("A/rad"));
    row.value = predicted.at.gain;
    if (predicted.gain95) {
        row.low95 = predicted.gain95->first;
        row.high95 = predicted.gain95->second;
    }
    row.source = predicted.isOfThisMotor ? Words::tr("identified motor") : Words::tr("published motor");
    return row;
}

QString agreementText(const RelayResult& result) {
    switch (result.agreement) {
    case RelayAgreement::Agrees:
        return Words::tr("The identified motor agrees: the intervals overlap.");
    case RelayAgreement::Disagrees:
        return Words::tr("The identified motor disagrees: the intervals do not overlap.");
    case RelayAgreement::Unknown:
        break;
    }
    return Words::tr("No identified motor to compare with. Identify the motor.");
}

} // namespace

QString relayOutlook(const RelayConfig& config, const RelayPlan& plan, double warmest_degC) {
    const double turns = std::abs(plan.travel_rad()) / (2.0 * Pi);
    QString text = turnText(plan.turn_rad_s, turns, plan.duration_s());
    text += QLatin1Char('\n');
    text += Words::tr("Oscillation of about %1° every %2 s, speed %3 to %4 rad/s. The speed keeps its sign; "
                      "the run stops outside the expected range.")
                .arg(number(radiansToDegrees(plan.predicted.amplitude_rad), 1),
                     number(plan.predicted.period_s, 2), number(plan.predicted.lowest_rad_s, 1),
                     number(plan.predicted.peak_rad_s, 1));
    text += QLatin1Char('\n');
    text += Words::tr("Maximum current %1 A, maximum coil temperature %2 °C.")
                .arg(number(plan.limit_A, 1), number(warmest_degC, 0));
    text += QLatin1Char(' ');
    text += Words::tr("Device stops at %1 rad/s at the latest. Gains and limits are replaced during the "
                      "experiment and always restored.")
                .arg(number(config.speedLimit_rad_s, 0));
    return widgets::withUnitsKept(text);
}

std::vector<widgets::EstimateRow> relayRows(const RelayResult& result) {
    std::vector<widgets::EstimateRow> rows = {row(Words::tr("ultimate gain"), ultimateGainOf(result)),
                                              row(Words::tr("ultimate period"), ultimatePeriodOf(result))};
    if (result.ultimate) {
        widgets::EstimateRow phase;
        phase.name = Words::tr("phase at the oscillation");
        phase.unit = QStringLiteral("\u00b0");
        phase.value = result.ultimate->phase_deg;
        phase.low95 = result.ultimate->phase95_deg.first;
        phase.high95 = result.ultimate->phase95_deg.second;
        phase.source = Words::tr("measured");
        phase.remark =
            Words::tr("at %1 rad/s; extrapolated to −180°").arg(number(result.cycle.frequency_rad_s, 2));
        rows.push_back(phase);
    }
    rows.push_back(modelRow(result.plan.predicted));
    return rows;
}

QString relayUse(const RelayResult& result) {
    QStringList lines;
    if (result.ultimate) {
        lines << agreementText(result);
    }
    lines << Words::tr("%1 cycles of %2° with %3 A; frequency scatter %4 %.")
                 .arg(result.cycle.cycles)
                 .arg(number(radiansToDegrees(result.cycle.amplitude), 1), number(result.cycle.input, 2),
                      number(100.0 * result.cycle.frequencyScatter_ratio, 1));
    lines << Words::tr("Speed range: %1 to %2 rad/s.")
                 .arg(number(result.lowestSpeed_rad_s, 2), number(result.highestSpeed_rad_s, 2));
    return lines.join(QLatin1Char('\n'));
}

} // namespace halbench::app
