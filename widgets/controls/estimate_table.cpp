#include "widgets/controls/estimate_table.h"

#include "widgets/controls/copy_menu.h"
#include "widgets/language/display_units.h"
#include "widgets/language/whole_numbers.h"
#include "widgets/theme/theme_style.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::widgets {
namespace {

enum Column { Name, Value, Half, Unit, Source, Columns };

const QChar Missing(0x2013);

int decade(double value) {
    return static_cast<int>(std::floor(std::log10(std::abs(value))));
}

} // namespace

EstimateText estimateText(double value, std::optional<double> half) {
    constexpr int HalfDigits = 2;
    if (!std::isfinite(value)) {
        return {Missing, Missing};
    }
    if (!half || !std::isfinite(*half) || *half <= 0.0) {
        return {numberText(value, 6), Missing};
    }
    // As many decimals as the half-width shows: trailing zeros are information here.
    const int decimals = std::max(0, HalfDigits - 1 - decade(*half));
    constexpr int MostDecimals = 7;
    constexpr double LeastDecimal = 1e-4; // numberText() too writes what is smaller with an exponent
    if (decimals <= MostDecimals && std::max(std::abs(value), *half) >= LeastDecimal) {
        return {fixedText(value, decimals), fixedText(*half, decimals)};
    }
    const int digits =
        value == 0.0 ? HalfDigits : std::clamp(decade(value) - decade(*half) + HalfDigits, 2, 9);
    return {exponentText(value, digits - 1), exponentText(*half, HalfDigits - 1)};
}

EstimateTable::EstimateTable(QWidget* parent) : QTableWidget(0, Columns, parent) {
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setTabKeyNavigation(false);
    setItemDelegate(new WholeNumbers(this));
    addCopyMenu(*this);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    verticalHeader()->hide();
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    // The names take the lines they need where there is little room: nothing is cut, nothing scrolls
    // sideways.
    horizontalHeader()->setSectionResizeMode(Name, QHeaderView::Stretch);
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    setWordWrap(true);
    connect(verticalHeader(), &QHeaderView::sectionResized, this, [this] { updateGeometry(); });
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    refreshWords();
}

void EstimateTable::refreshWords() {
    setHorizontalHeaderLabels({tr("Quantity"), tr("Value"), tr("\u00b1 (95 %)"), tr("Unit"),
                               m_lastTitle.isEmpty() ? tr("Source") : m_lastTitle});
    for (int column = 0; column < Columns; ++column) {
        horizontalHeaderItem(column)->setTextAlignment(
            static_cast<int>((isNumber(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
    }
}

void EstimateTable::setLastTitle(const QString& title) {
    if (std::exchange(m_lastTitle, title) != title) {
        m_rows.clear();
        refreshWords();
    }
}

bool EstimateTable::isNumber(int column) const {
    return column == Value || column == Half || (column == Source && !m_lastTitle.isEmpty());
}

void EstimateTable::setRows(const std::vector<EstimateRow>& rows) {
    if (!rows.empty() && rows == m_rows) {
        return;
    }
    m_rows = rows;
    setRowCount(static_cast<int>(rows.size()));
    for (int i = 0; i < rowCount(); ++i) {
        const EstimateRow& row = rows[static_cast<std::size_t>(i)];
        const auto half = row.low95 && row.high95 ? std::optional(0.5 * (*row.high95 - *row.low95))
                                                  : std::optional<double>();
        const EstimateText number =
            row.value ? estimateText(*row.value, half) : EstimateText{Missing, Missing};
        const QString interval =
            row.low95 && row.high95
                ? tr("95 % interval: %1 to %2").arg(numberText(*row.low95, 5), numberText(*row.high95, 5))
                : QString();
        const QString texts[Columns] = {row.name, number.value, number.half, row.unit, row.source};
        for (int column = 0; column < Columns; ++column) {
            auto* item = new QTableWidgetItem(texts[column]);
            item->setTextAlignment(
                static_cast<int>((isNumber(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
            item->setFont(isNumber(column) ? tabularFont(font()) : font());
            item->setToolTip(row.remark.isEmpty() ? interval : row.remark);
            setItem(i, column, item);
        }
    }
    setAccessibleDescription(text());
    updateGeometry();
}

QString EstimateTable::text() const {
    QString lines;
    for (int column = 0; column < Columns; ++column) {
        lines += (column > 0 ? QStringLiteral("\t") : QString()) + horizontalHeaderItem(column)->text();
    }
    for (int i = 0; i < rowCount(); ++i) {
        lines += QLatin1Char('\n');
        for (int column = 0; column < Columns; ++column) {
            lines += (column > 0 ? QStringLiteral("\t") : QString()) + item(i, column)->text();
        }
    }
    return lines;
}

int EstimateTable::neededWidth() const {
    constexpr int Edges_px = 4;
    int width_px = 2 * frameWidth() + Edges_px;
    for (int column = 0; column < Columns; ++column) {
        width_px += std::max(sizeHintForColumn(column), horizontalHeader()->sectionSizeHint(column));
    }
    return width_px;
}

QSize EstimateTable::sizeHint() const {
    int height_px = horizontalHeader()->sizeHint().height() + 2 * frameWidth();
    for (int i = 0; i < rowCount(); ++i) {
        height_px += rowHeight(i);
    }
    return {360, height_px + 2};
}

QSize EstimateTable::minimumSizeHint() const {
    constexpr int LeastName_characters = 12;
    int width_px = 2 * frameWidth() + LeastName_characters * fontMetrics().averageCharWidth();
    for (int column = Value; column < Columns; ++column) {
        width_px += std::max(sizeHintForColumn(column), horizontalHeader()->sectionSizeHint(column));
    }
    return {width_px, sizeHint().height()};
}

void EstimateTable::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy)) {
        QGuiApplication::clipboard()->setText(text());
    } else if (event->key() == Qt::Key_Escape) {
        event->ignore(); // Esc stops the motor
    } else {
        QTableWidget::keyPressEvent(event);
    }
}

void EstimateTable::changeEvent(QEvent* event) {
    QTableWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange) {
        m_rows.clear();
        refreshWords();
    }
}

} // namespace halbench::widgets
