#include "app/wizards/axes_identify_text.h"

#include "app/wizards/identify_text.h"
#include "widgets/controls/progress_row.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"

#include <QCoreApplication>
#include <QStringList>

namespace halbench::app {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::AxesIdentifyWords)
};

} // namespace

std::vector<widgets::EstimateRow> axesRows(const AxesIdentifyResult& result,
                                           const std::vector<devices::AxisSpec>& axes) {
    std::vector<widgets::EstimateRow> rows;
    for (const IdentifiedAxis& axis : result.model.axes) {
        QString title = QString::fromStdString(axis.axis);
        for (const devices::AxisSpec& known : axes) {
            title = known.id == axis.axis ? QString::fromStdString(known.title) : title;
        }
        rows.push_back(estimateRow(Words::tr("%1: damping rate").arg(title), axis.dampingRate));
        rows.push_back(
            estimateRow(Words::tr("%1: acceleration per effort").arg(title), axis.accelerationGain));
        rows.push_back(estimateRow(Words::tr("%1: friction, as effort").arg(title), axis.breakawayEffort));
    }
    for (const std::vector<NamedEstimate>* list : {&result.ratios, &result.constants}) {
        for (const NamedEstimate& each : *list) {
            widgets::EstimateRow row = estimateRow(widgets::inWords(each.title), each.estimate);
            row.remark = QString::fromStdString(each.name);
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

QString axesOutlook(const IdentifyPrediction& prediction, const std::vector<devices::AxisSpec>& axes) {
    QStringList titles;
    for (const devices::AxisSpec& axis : axes) {
        titles << QString::fromStdString(axis.title);
    }
    return Words::tr("Motion of %1 for %2 minutes of device time, up to %3 A in a coil, maximum coil "
                     "temperature %4 °C.")
               .arg(titles.join(QStringLiteral(", ")), widgets::durationText(prediction.duration_s),
                    widgets::fixedText(prediction.peakCurrent_A, 1),
                    widgets::fixedText(prediction.highestTemperature_degC, 0)) +
           QLatin1Char('\n') +
           Words::tr(
               "The board monitors its windows. Gains, limits and references are restored in every case.");
}

} // namespace halbench::app
