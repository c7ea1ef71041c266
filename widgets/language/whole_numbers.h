#pragma once

#include <QStyledItemDelegate>

namespace halbench::widgets {

/// Whether a cut of the words would read as another number: they begin with a digit, after signs at most.
bool readsAsNumber(const QString& text);

/// Draws cells like any other table, but a number that the edge of its view or of its column cuts is three
/// dots: "100" of "1001" is another number, not a part of it.
class WholeNumbers : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

} // namespace halbench::widgets
