#include "app/wizards/axes_frequency_text.h"

#include "app/wizards/frequency_text.h"
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

struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::AxesFrequencyWords)
};

QString titleOf(const devices::AxisSpec& axis) {
    return QString::fromStdString(axis.title);
}

widgets::EstimateRow peakRow(const QString& name, const MeasuredPeak& peak) {
    widgets::EstimateRow row;
    row.name = name;
    if (peak.withheld != MeasuredPeak::Withheld::No) {
        row.source = peak.withheld == MeasuredPeak::Withheld::Edge
                         ? Words::tr("not given: largest at the edge of the band")
                         : Words::tr("not given: no frequency with every axis coherent");
        return row;
    }
    row.value = peak.value;
    row.low95 = std::max(0.0, peak.value - peak.radius);
    row.high95 = peak.value + peak.radius;
    row.source = Words::tr("measured");
    row.remark = Words::tr("at %1 Hz").arg(widgets::fixedText(peak.frequency_rad_s / (2.0 * Pi), 2));
    return row;
}

/// The largest |G_ij| F_j / (|G_ii| F_i) above its scatter.
QString couplingText(const AxesFrequencyResult& result) {
    double largest = 0.0;
    QString text;
    for (const AxesFrequencyPoint& point : result.points) {
        for (std::size_t i = 0; i < result.axes.size(); ++i) {
            for (std::size_t j = 0; j < result.axes.size(); ++j) {
                const auto row = static_cast<Eigen::Index>(i);
                const auto column = static_cast<Eigen::Index>(j);
                const double size = std::abs(point.plant.value(row, column));
                const devices::AxisSpec& of = result.axes[i].axis;
                const devices::AxisSpec& from = result.axes[j].axis;
                const double relative =
                    size * from.effortLimit / (std::abs(point.plant.value(row, row)) * of.effortLimit);
                const bool isSeen = i != j && point.isUsed[i] && size > point.plant.radius(row, column);
                if (isSeen && relative > largest) {
                    largest = relative;
                    text = Words::tr("Strongest coupling: full effort of %1 moves %2 by %3 % of what its own "
                                     "full effort does, at %4 Hz.")
                               .arg(titleOf(from), titleOf(of), widgets::fixedText(100.0 * relative, 1),
                                    widgets::fixedText(point.plant.frequency_rad_s / (2.0 * Pi), 2));
                }
            }
        }
    }
    return text.isEmpty() && result.axes.size() > 1
               ? Words::tr("No coupling between the axes was seen above the scatter.")
               : text;
}

} // namespace

QString axesFrequencyOutlook(const AxesFrequencyConfig& config, double duration_s,
                             const std::vector<devices::AxisSpec>& axes) {
    QStringList titles;
    for (const devices::AxisSpec& axis : axes) {
        titles << titleOf(axis);
    }
    return widgets::withUnitsKept(
        Words::tr("The loops hold the position; %1 are excited from %2 to %3 Hz with %4 % of their largest "
                  "effort, for %5 minutes of device time.")
            .arg(titles.join(QStringLiteral(", ")), widgets::numberText(config.from_Hz, 4),
                 widgets::numberText(config.to_Hz, 4), widgets::fixedText(100.0 * config.effort_ratio, 0),
                 widgets::durationText(duration_s)) +
        QLatin1Char('\n') +
        Words::tr("The loops are measured with the gains of the device, which are not changed. Everything "
                  "else is restored."));
}

std::vector<widgets::EstimateRow> axesFrequencyRows(const AxesFrequencyResult& result) {
    std::vector<widgets::EstimateRow> rows;
    for (const AxisResponse& response : result.axes) {
        rows.push_back(marginRow(Words::tr("%1: phase margin").arg(titleOf(response.axis)),
                                 response.margins.phase_deg, QStringLiteral("\u00b0")));
        rows.push_back(marginRow(Words::tr("%1: gain margin").arg(titleOf(response.axis)),
                                 response.margins.gain_dB, QStringLiteral("dB")));
    }
    rows.push_back(peakRow(Words::tr("peak of the largest singular value of S"), result.sensitivity));
    rows.push_back(peakRow(Words::tr("peak of the largest singular value of T"), result.complementary));
    return rows;
}

QString axesFrequencyUse(const AxesFrequencyResult& result) {
    QStringList lines;
    for (std::size_t i = 0; i < result.axes.size(); ++i) {
        const auto used = std::count_if(result.points.begin(), result.points.end(),
                                        [i](const AxesFrequencyPoint& point) { return point.isUsed[i]; });
        lines << Words::tr("%1: %2 of %3 frequencies have a coherence of at least %4.")
                     .arg(titleOf(result.axes[i].axis))
                     .arg(used)
                     .arg(result.points.size())
                     .arg(widgets::fixedText(result.config.leastCoherence, 2));
    }
    lines << couplingText(result) << Words::tr("S and T: positions in units of the test steps of the axes.");
    lines.removeAll(QString());
    return widgets::withUnitsKept(lines.join(QLatin1Char('\n')));
}

} // namespace halbench::app
