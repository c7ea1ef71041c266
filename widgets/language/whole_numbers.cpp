#include "widgets/language/whole_numbers.h"

#include <QAbstractItemView>
#include <QStyle>

#include <algorithm>

namespace halbench::widgets {
namespace {

const QChar Dots(0x2026);

/// Of the text in one line; where it may be wrapped, of its longest word.
int leastWidth(const QStyleOptionViewItem& cell) {
    const bool isWrapped = (cell.features & QStyleOptionViewItem::WrapText) != 0;
    int width_px = 0;
    for (const QString& piece : isWrapped ? cell.text.split(QLatin1Char(' ')) : QStringList{cell.text}) {
        width_px = std::max(width_px, cell.fontMetrics.horizontalAdvance(piece));
    }
    return width_px;
}

bool isTooNarrow(const QStyleOptionViewItem& cell, const QAbstractItemView& view) {
    const QStyle& style = *view.style();
    const int margins_px = 2 * (style.pixelMetric(QStyle::PM_FocusFrameHMargin, &cell, &view) + 1);
    const int room_px = style.subElementRect(QStyle::SE_ItemViewItemText, &cell, &view).width() - margins_px;
    return leastWidth(cell) > room_px;
}

} // namespace

bool readsAsNumber(const QString& text) {
    const auto first = std::find_if(text.begin(), text.end(), [](QChar one) {
        return one.isLetterOrNumber(); // signs, comparisons, spaces are passed over
    });
    return first != text.end() && first->isDigit();
}

void WholeNumbers::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
    QStyleOptionViewItem shown = option;
    initStyleOption(&shown, index);
    const auto* view = qobject_cast<const QAbstractItemView*>(option.widget);
    if (view == nullptr) {
        QStyledItemDelegate::paint(painter, option, index);
        return;
    }
    const QRect seen = shown.rect & view->viewport()->rect();
    if ((seen.width() < shown.rect.width() || isTooNarrow(shown, *view)) && readsAsNumber(shown.text)) {
        shown.rect = seen;
        shown.text = Dots;
        shown.displayAlignment = Qt::AlignCenter;
    }
    view->style()->drawControl(QStyle::CE_ItemViewItem, &shown, painter, view);
}

} // namespace halbench::widgets
