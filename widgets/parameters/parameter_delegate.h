#pragma once

#include "widgets/language/whole_numbers.h"

namespace halbench::widgets {

/// Edits a value of the parameter table: a list for an enumeration, else a line in the user's notation.
class ParameterDelegate : public WholeNumbers {
    Q_OBJECT
public:
    using WholeNumbers::WholeNumbers;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;
};

} // namespace halbench::widgets
