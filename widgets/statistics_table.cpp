#include "widgets/statistics_table.h"

#include "widgets/display_units.h"
#include "widgets/theme_style.h"

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>

#include <algorithm>

namespace halbench::widgets {
namespace {

enum Column { Name, Min, Max, PeakToPeak, Mean, Rms, Deviation, Slope, Count, Gaps, Columns };

constexpr int MostRows = 6;  ///< without scrolling
constexpr int LeastRows = 2; ///< where room is short
constexpr int RowSpace_px = 8;
constexpr int SlopeDigits = 5;
const QChar Missing(0x2013);

} // namespace

StatisticsTable::StatisticsTable(QWidget* parent) : QTableWidget(0, Columns, parent) {
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setTabKeyNavigation(false);
    setFont(tabularFont(font()));
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + RowSpace_px);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
    m_copy = new QAction(this);
    addAction(m_copy);
    setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(m_copy, &QAction::triggered, this, &StatisticsTable::copy);
    refreshWords();
}

void StatisticsTable::refreshWords() {
    m_copy->setText(tr("Copy the table"));
    setHorizontalHeaderLabels({m_stretch.isEmpty() ? tr("Signal") : m_stretch, tr("Min"), tr("Max"),
                               tr("Pk-pk"), tr("Mean"), tr("RMS"), tr("Std dev"), tr("Slope A to B"),
                               tr("Values"), tr("Gaps")});
    horizontalHeaderItem(PeakToPeak)->setToolTip(tr("Peak to peak: largest less smallest value"));
    setAccessibleName(tr("Statistics"));
}

void StatisticsTable::setStretch(const QString& words) {
    if (words != m_stretch) {
        m_stretch = words;
        horizontalHeaderItem(Name)->setText(words);
    }
}

/// Fields are kept, so that the selection stays and nothing is laid out anew without need.
void StatisticsTable::put(int row, int column, const QString& text) {
    QTableWidgetItem* field = item(row, column);
    if (field == nullptr) {
        field = new QTableWidgetItem;
        field->setTextAlignment(
            static_cast<int>((column == Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter));
        setItem(row, column, field);
    }
    if (field->text() != text) {
        field->setText(text);
    }
}

void StatisticsTable::setRows(const std::vector<StatisticsRow>& rows) {
    const bool isAnew = rowCount() != static_cast<int>(rows.size());
    if (isAnew) {
        setRowCount(static_cast<int>(rows.size()));
        updateGeometry();
    }
    bool hasSlope = false;
    for (int i = 0; i < rowCount(); ++i) {
        const StatisticsRow& row = rows[static_cast<std::size_t>(i)];
        const auto number = [&](double value) {
            return row.isKnown && row.count > 0 ? fixedText(value, row.decimals + 1) : QString(Missing);
        };
        put(i, Name, row.unit.isEmpty() ? row.name : QStringLiteral("%1 [%2]").arg(row.name, row.unit));
        put(i, Min, number(row.min));
        put(i, Max, number(row.max));
        put(i, PeakToPeak, number(row.max - row.min));
        put(i, Mean, number(row.mean));
        put(i, Rms, number(row.rms));
        put(i, Deviation, number(row.deviation));
        put(i, Slope,
            row.isKnown && row.slope
                ? QStringLiteral("%1 %2/s").arg(numberText(*row.slope, SlopeDigits), row.unit)
                : QString(Missing));
        put(i, Count, row.isKnown ? countText(row.count) : QString(Missing));
        put(i, Gaps, row.isKnown ? countText(row.gaps) : QString(Missing));
        hasSlope = hasSlope || row.slope;
    }
    setColumnHidden(Slope, !hasSlope);
    fitColumns(isAnew);
}

/// Columns only grow with the numbers: nothing jumps.
void StatisticsTable::fitColumns(bool isAnew) {
    for (int column = 0; column < Columns; ++column) {
        const int needed_px =
            std::max(sizeHintForColumn(column), horizontalHeader()->sectionSizeHint(column));
        if (isAnew || needed_px > columnWidth(column)) {
            setColumnWidth(column, needed_px);
        }
    }
}

QString StatisticsTable::text() const {
    QStringList lines;
    for (int row = -1; row < rowCount(); ++row) {
        QStringList fields;
        for (int column = 0; column < Columns; ++column) {
            if (!isColumnHidden(column)) {
                fields << (row < 0 ? horizontalHeaderItem(column) : item(row, column))->text();
            }
        }
        lines << fields.join('\t');
    }
    return lines.join('\n') + '\n';
}

QSize StatisticsTable::sizeOf(int rows) const {
    return {QTableWidget::sizeHint().width(), horizontalHeader()->sizeHint().height() +
                                                  rows * verticalHeader()->defaultSectionSize() +
                                                  2 * frameWidth()};
}

QSize StatisticsTable::sizeHint() const {
    return sizeOf(std::clamp(rowCount(), 1, MostRows));
}

QSize StatisticsTable::minimumSizeHint() const {
    return {0, sizeOf(std::clamp(rowCount(), 1, LeastRows)).height()};
}

void StatisticsTable::copy() {
    QGuiApplication::clipboard()->setText(text());
}

/// Here Ctrl+C means the table, whatever it means around it.
bool StatisticsTable::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
        event->accept();
        return true;
    }
    return QTableWidget::event(event);
}

void StatisticsTable::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy)) {
        copy();
        return;
    }
    QTableWidget::keyPressEvent(event);
}

void StatisticsTable::changeEvent(QEvent* event) {
    QTableWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange) {
        verticalHeader()->setDefaultSectionSize(fontMetrics().height() + RowSpace_px);
        fitColumns(true);
    }
}

} // namespace halbench::widgets
