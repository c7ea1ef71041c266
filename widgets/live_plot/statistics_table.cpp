#include "widgets/live_plot/statistics_table.h"

#include "widgets/language/display_units.h"
#include "widgets/language/whole_numbers.h"
#include "widgets/theme/theme_style.h"

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QScrollBar>

#include <algorithm>

namespace halbench::widgets {
namespace {

enum Column { Name, Min, Max, PeakToPeak, Mean, Rms, Deviation, Slope, Count, Gaps, Columns };

constexpr int MostRows = 6;   ///< without scrolling
constexpr int LeastRows = 2;  ///< where room is short
constexpr int LeastName = 14; ///< characters of a name that gives way to numbers
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
    setTextElideMode(Qt::ElideMiddle); // of a long name; its unit stays
    setItemDelegate(new WholeNumbers(this));
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
                               tr("Pk-pk"), tr("Mean"), tr("RMS"), tr("Std dev"), tr("Slope/s"), tr("Values"),
                               tr("Gaps")});
    horizontalHeaderItem(PeakToPeak)->setToolTip(tr("Peak to peak: maximum minus minimum"));
    horizontalHeaderItem(Slope)->setToolTip(tr("Slope from cursor A to B, per second"));
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
        field->setToolTip(column == Name ? text : QString());
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
        put(i, Slope, row.isKnown && row.slope ? numberText(*row.slope, SlopeDigits) : QString(Missing));
        put(i, Count, row.isKnown ? countText(row.count) : QString(Missing));
        put(i, Gaps, row.isKnown ? countText(row.gaps) : QString(Missing));
        hasSlope = hasSlope || row.slope;
    }
    setColumnHidden(Slope, !hasSlope);
    fitColumns(isAnew);
}

/// Columns only grow with the numbers: nothing jumps. Where they lack room the names give way first.
void StatisticsTable::fitColumns(bool isAnew) {
    m_needed_px.resize(Columns, 0);
    int numbers_px = 0;
    for (int column = 0; column < Columns; ++column) {
        int& needed_px = m_needed_px[static_cast<std::size_t>(column)];
        needed_px = std::max(
            {isAnew ? 0 : needed_px, sizeHintForColumn(column), horizontalHeader()->sectionSizeHint(column)});
        if (column != Name) {
            setColumnWidth(column, needed_px);
            numbers_px += isColumnHidden(column) ? 0 : needed_px;
        }
    }
    const int least_px =
        std::max(LeastName * fontMetrics().averageCharWidth(), horizontalHeader()->sectionSizeHint(Name));
    const int wanted_px = std::max(m_needed_px[Name], least_px);
    setColumnWidth(Name, std::clamp(viewport()->width() - numbers_px, least_px, wanted_px));
    if (const bool isScrolled = horizontalHeader()->length() > viewport()->width();
        isScrolled != m_isScrolled) {
        m_isScrolled = isScrolled;
        updateGeometry();
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
    return {QTableWidget::sizeHint().width(),
            horizontalHeader()->sizeHint().height() + rows * verticalHeader()->defaultSectionSize() +
                (m_isScrolled ? horizontalScrollBar()->sizeHint().height() : 0) + 2 * frameWidth()};
}

int StatisticsTable::leastRows() const {
    return m_isScrolled ? 1 : LeastRows;
}

int StatisticsTable::heightWithin(int room_px) const {
    const int rows = (room_px - sizeOf(0).height()) / verticalHeader()->defaultSectionSize();
    return sizeOf(std::max(rows, leastRows())).height();
}

QSize StatisticsTable::sizeHint() const {
    return sizeOf(std::clamp(rowCount(), 1, MostRows));
}

QSize StatisticsTable::minimumSizeHint() const {
    return {0, sizeOf(std::clamp(rowCount(), 1, leastRows())).height()};
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

void StatisticsTable::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    fitColumns(false);
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
