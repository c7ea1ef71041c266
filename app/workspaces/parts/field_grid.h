#pragma once

#include "app/workspaces/parts/panel_parts.h"

#include <QStringList>
#include <QWidget>

class QComboBox;

namespace halbench::app {

/// Titled fields in rows of so many columns of equal width, each below its title: what a panel beside plots
/// asks for, in little height.
class FieldGrid : public QWidget {
public:
    FieldGrid(int columns, QWidget* parent);

    QComboBox* addBox(const QString& title, const QString& toolTip, const QStringList& items = {});
    widgets::QuantityEdit* addNumber(const NumberField& field);
    void addTitled(const QString& title, const QString& toolTip, QWidget* field);
    /// Without a title.
    void addPlain(QWidget* field, int columns = 1);

private:
    void add(const QString& title, QWidget* field, int columns);

    int m_columns;
    int m_next = 0;
};

} // namespace halbench::app
