#include "app/wizards/relay_words.h"

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
    row.remark = estimate.value ? QString() : Words::tr("The findings above say why, and what helps");
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
        return Words::tr("The identified motor agrees: the two intervals overlap.");
    case RelayAgreement::Disagrees:
        return Words::tr("The identified motor disagrees: the two intervals lie apart.");
    case RelayAgreement::Unknown:
        break;
    }
    return Words::tr("Whether a model agrees is not known: identify the motor to compare.");
}

} // namespace

QString relayOutlook(const RelayConfig& config, const RelayPlan& plan, double warmest_degC) {
    const double speed_rad_s = std::abs(plan.turn_rad_s);
    const double turns = std::abs(plan.travel_rad()) / (2.0 * Pi);
    QString text =
        (plan.turn_rad_s < 0.0
             ? Words::tr("The rotor will turn in reverse at %1 rad/s (%2 r/min), about %3 turns, for "
                         "%4 minutes of device time.")
             : Words::tr("The rotor will turn forward at %1 rad/s (%2 r/min), about %3 turns, for %4 "
                         "minutes of device time."))
            .arg(number(speed_rad_s, 1), number(radPerSecondToRpm(speed_rad_s), 0), number(turns, 0),
                 widgets::durationText(plan.duration_s()));
    text += QLatin1Char('\n');
    text +=
        Words::tr("It swings around that by about %1° every %2 s, with speeds from %3 to %4 rad/s; its speed "
                  "never changes sign, and the run ends where it leaves what is foreseen.")
            .arg(number(radiansToDegrees(plan.predicted.amplitude_rad), 1),
                 number(plan.predicted.period_s, 2), number(plan.predicted.lowest_rad_s, 1),
                 number(plan.predicted.peak_rad_s, 1));
    text += QLatin1Char('\n');
    text += Words::tr("Current up to %1 A, coils up to %2 °C.")
                .arg(number(plan.limit_A, 1), number(warmest_degC, 0));
    text += QLatin1Char(' ');
    text +=
        Words::tr(
            "The board ends the motion at %1 rad/s at the latest. Its gains and limits are replaced for the "
            "experiment and restored whatever happens.")
            .arg(number(config.speedLimit_rad_s, 0));
    return widgets::withUnitsKept(text);
}

std::vector<widgets::EstimateRow> relayRows(const RelayResult& result) {
    std::vector<widgets::EstimateRow> rows = {row(Words::tr("ultimate gain"), ultimateGainOf(result)),
                                              row(Words::tr("ultimate period"), ultimatePeriodOf(result))};
    if (result.ultimate) {
        widgets::EstimateRow phase;
        phase.name = Words::tr("phase where it swung");
        phase.unit = QStringLiteral("\u00b0");
        phase.value = result.ultimate->phase_deg;
        phase.low95 = result.ultimate->phase95_deg.first;
        phase.high95 = result.ultimate->phase95_deg.second;
        phase.source = Words::tr("measured");
        phase.remark = Words::tr("at %1 rad/s; followed from there to −180°")
                           .arg(number(result.cycle.frequency_rad_s, 2));
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
    lines << Words::tr(
                 "%1 swings of %2° around the steady motion, with %3 A; their frequency scattered by %4 %.")
                 .arg(result.cycle.cycles)
                 .arg(number(radiansToDegrees(result.cycle.amplitude), 1), number(result.cycle.input, 2),
                      number(100.0 * result.cycle.frequencyScatter_ratio, 1));
    lines << Words::tr("The speed stayed between %1 and %2 rad/s.")
                 .arg(number(result.lowestSpeed_rad_s, 2), number(result.highestSpeed_rad_s, 2));
    return lines.join(QLatin1Char('\n'));
}

} // namespace halbench::app
