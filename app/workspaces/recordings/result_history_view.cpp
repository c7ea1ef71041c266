#include "app/workspaces/recordings/result_history_view.h"

#include "app/workbench/wall_clock.h"
#include "app/workspaces/parts/compact_table.h"
#include "widgets/controls/copy_menu.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/language/display_units.h"
#include "widgets/language/whole_numbers.h"

#include <QDateTime>
#include <QHeaderView>

#include <array>
#include <utility>

namespace halbench::app {

namespace {

constexpr int FirstValue = 4; ///< after file, date, device and quality
constexpr std::array<const char*, HistoryParameters.size()> Units = {"N·m·s/rad", "N·m", "N·m/A", "kg·m²"};

QString titleOf(std::size_t parameter) {
    const QString titles[] = {ResultHistoryView::tr("Damping c"), ResultHistoryView::tr("Friction K_f"),
                              ResultHistoryView::tr("Torque constant"), ResultHistoryView::tr("Inertia J")};
    return QStringLiteral("%1 [%2]").arg(titles[parameter], QString::fromUtf8(Units[parameter]));
}

QString valueText(const control::Estimate& estimate) {
    if (!estimate.value) {
        return QStringLiteral("\u2013");
    }
    const std::optional<double> half =
        estimate.interval95 ? std::optional((estimate.interval95->second - estimate.interval95->first) / 2.0)
                            : std::nullopt;
    const widgets::EstimateText text = widgets::estimateText(*estimate.value, half);
    const QString number = half ? QStringLiteral("%1 \u00b1 %2").arg(text.value, text.half) : text.value;
    return estimate.source == control::EstimateSource::Given ? ResultHistoryView::tr("%1 (given)").arg(number)
                                                             : number;
}

QString qualityText(Verdict verdict) {
    switch (verdict) {
    case Verdict::Good:
        return ResultHistoryView::tr("good");
    case Verdict::Doubtful:
        return ResultHistoryView::tr("doubtful");
    case Verdict::Refused:
        break;
    }
    return ResultHistoryView::tr("refused");
}

/// A symbol where the change is more than chance: colour alone says nothing.
QString driftText(const std::optional<Drift>& drift) {
    if (!drift) {
        return {};
    }
    const QString symbol = !drift->isSignificant ? QString()
                           : drift->ratio > 0.0  ? QStringLiteral(" \u25b2")
                                                 : QStringLiteral(" \u25bc");
    const QString sign = drift->ratio > 0.0 ? QStringLiteral("+") : QString();
    return QStringLiteral("  (%1%2 %%3)").arg(sign, widgets::fixedText(drift->ratio * 100.0, 1), symbol);
}

QString driftWords(const std::optional<Drift>& drift) {
    if (!drift) {
        return {};
    }
    return drift->isSignificant
               ? ResultHistoryView::tr("Drift since the first result of this device: outside both intervals")
               : ResultHistoryView::tr("Drift since the first result of this device: within the intervals");
}

/// Virtual time begins in 1970 and says nothing.
QString dateText(const std::string& started) {
    const QDateTime date = QDateTime::fromString(QString::fromStdString(started), Qt::ISODate);
    return date.isValid() && date.toSecsSinceEpoch() != 0 ? localDate(started)
                                                          : ResultHistoryView::tr("simulated time");
}

QString deviceText(const std::optional<devices::DeviceInfo>& device) {
    return device ? QString::fromStdString(device->id.empty() ? device->model : device->id) : QString();
}

} // namespace

ResultHistoryView::ResultHistoryView(QWidget* parent) : QTableWidget(parent) {
    setAccessibleName(tr("Identified values over time"));
    setToolTip(tr("Identification files (.json) of the folder, oldest first, with 95 % intervals; in "
                  "brackets the drift since the first result of the same device"));
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setTabKeyNavigation(false);
    widgets::addCopyMenu(*this);
    setItemDelegate(new widgets::WholeNumbers(this));
    setCompact(*this);
    QStringList titles = {tr("File"), tr("Date"), tr("Device"), tr("Data quality")};
    for (std::size_t i = 0; i < HistoryParameters.size(); ++i) {
        titles.append(titleOf(i));
    }
    setColumnCount(titles.size());
    setHorizontalHeaderLabels(titles);
}

void ResultHistoryView::setRows(std::vector<ResultRow> rows) {
    m_rows = std::move(rows);
    setRowCount(static_cast<int>(m_rows.size()));
    for (int row = 0; row < rowCount(); ++row) {
        fillRow(row);
    }
    resizeColumnsToContents();
}

void ResultHistoryView::fillRow(int row) {
    const ResultRow& result = m_rows[static_cast<std::size_t>(row)];
    const ResultHeader& header = result.header;
    const QStringList words = {QString::fromStdString(result.file), dateText(header.started),
                               deviceText(header.device), qualityText(header.quality.verdict)};
    for (int column = 0; column < FirstValue; ++column) {
        setItem(row, column, new QTableWidgetItem(words[column]));
    }
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        const std::optional<Drift> drift = driftAt(m_rows, static_cast<std::size_t>(row), i);
        auto* item = new QTableWidgetItem(valueText(result.values[i]) + driftText(drift));
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        item->setToolTip(driftWords(drift));
        setItem(row, FirstValue + static_cast<int>(i), item);
    }
}

} // namespace halbench::app
