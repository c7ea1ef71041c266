#include "app/wizards/frequency_text.h"

#include "app/procedures/frequency/frequency_board.h"
#include "app/wizards/turn_text.h"
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
        return Words::tr("not given: no crossover");
    case MeasuredMargin::Withheld::Gap:
        return Words::tr("not given: crossover in a gap");
    case MeasuredMargin::Withheld::Uncertain:
        return Words::tr("not given: too uncertain");
    case MeasuredMargin::Withheld::No:
        break;
    }
    return {};
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

widgets::EstimateRow marginRow(const QString& name, const MeasuredMargin& margin, const QString& unit) {
    widgets::EstimateRow row;
    row.name = name;
    row.unit = unit;
    if (!margin.value) {
        row.source = withheldReason(margin);
        row.remark = Words::tr("See the findings above for cause and remedy");
        return row;
    }
    row.value = margin.value;
    row.low95 = margin.interval->first;
    row.high95 = margin.interval->second;
    row.source = Words::tr("measured");
    row.remark = Words::tr("at the crossover of %1 Hz").arg(number(*margin.frequency_rad_s / (2.0 * Pi), 2));
    return row;
}

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
    QString text = turnText(plan.turn_rad_s, std::round(turns / 10.0) * 10.0, plan.duration_s());
    text += QLatin1Char('\n');
    text += Words::tr("An excitation of up to %1° is added. The speed keeps its sign; the run stops if it "
                      "comes near zero.")
                .arg(number(radiansToDegrees(swing_rad), 2));
    text += QLatin1Char('\n');
    text += Words::tr("Maximum current %1 A, maximum coil temperature %2 °C.")
                .arg(number(plan.peakCurrent_A, 1), number(warmest_degC, 0));
    text += QLatin1Char(' ');
    text += Words::tr("Device stops at %1 rad/s. The loop is measured with the device's gains, which are not "
                      "changed; all other settings are restored.")
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
        rows.back().remark = Words::tr("direct feed-through from current to angle");
    }
    return rows;
}

QString frequencyUse(const FrequencyResult& result) {
    const auto used = std::count_if(result.points.begin(), result.points.end(),
                                    [](const FrequencyResultPoint& point) { return point.isUsed; });
    QStringList lines = {Words::tr("%1 of %2 frequencies have a coherence of at least %3. The others are "
                                   "shown faint and not used for margins and fit.")
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
    lines << Words::tr("Minimum speed during excitation: %1 rad/s.").arg(number(result.lowestSpeed_rad_s, 2));
    return lines.join(QLatin1Char('\n'));
}

} // namespace halbench::app
