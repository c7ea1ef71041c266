#include "widgets/parameters/parameter_delegate.h"

#include "widgets/parameters/parameter_table_model.h"

#include <QComboBox>
#include <QLineEdit>

namespace halbench::widgets {

QWidget* ParameterDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                         const QModelIndex& index) const {
    const QString name = index.data(ParameterTableModel::NameRole).toString();
    const QStringList choices = index.data(ParameterTableModel::ChoicesRole).toStringList();
    QWidget* editor = nullptr;
    if (choices.isEmpty()) {
        auto* line = new QLineEdit(parent);
        line->setAlignment(Qt::AlignRight);
        editor = line;
    } else {
        auto* combo = new QComboBox(parent);
        combo->addItems(choices);
        editor = combo;
    }
    editor->setAccessibleName(name);
    editor->setToolTip(index.data(Qt::ToolTipRole).toString());
    return editor;
}

void ParameterDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    const QString text = index.data(Qt::EditRole).toString();
    if (auto* combo = qobject_cast<QComboBox*>(editor)) {
        combo->setCurrentText(text);
    } else if (auto* line = qobject_cast<QLineEdit*>(editor)) {
        line->setText(text);
        line->selectAll();
    }
}

void ParameterDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                     const QModelIndex& index) const {
    if (const auto* combo = qobject_cast<QComboBox*>(editor)) {
        model->setData(index, combo->currentText());
    } else if (const auto* line = qobject_cast<QLineEdit*>(editor)) {
        model->setData(index, line->text());
    }
}

} // namespace halbench::widgets
