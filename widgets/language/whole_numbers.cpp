#include "widgets/language/whole_numbers.h"

#include <QAbstractItemView>
#include <QStyle>

#include <algorithm>

namespace halbench::widgets {
namespace {

const QChar Dots(0x2026);

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
    if (seen.width() < shown.rect.width() && readsAsNumber(shown.text)) {
        shown.rect = seen;
        shown.text = Dots;
        shown.displayAlignment = Qt::AlignCenter;
    }
    view->style()->drawControl(QStyle::CE_ItemViewItem, &shown, painter, view);
}

} // namespace halbench::widgets
