#include "app/workspaces/parts/field_grid.h"

#include "widgets/controls/quantity_edit.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>

namespace halbench::app {

namespace {

constexpr int LeastCharacters = 12; ///< of a box

} // namespace

FieldGrid::FieldGrid(int columns, QWidget* parent) : QWidget(parent), m_columns(columns) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(widgets::GridStep_px);
    for (int column = 0; column < columns; ++column) {
        grid->setColumnStretch(column, 1);
    }
}

QComboBox* FieldGrid::addBox(const QString& title, const QString& toolTip, const QStringList& items) {
    auto* box = new QComboBox(this);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(LeastCharacters);
    box->addItems(items);
    addTitled(title, toolTip, box);
    return box;
}

void FieldGrid::addTitled(const QString& title, const QString& toolTip, QWidget* field) {
    field->setAccessibleName(title);
    field->setToolTip(toolTip);
    add(title, field, 1);
}

widgets::QuantityEdit* FieldGrid::addNumber(const NumberField& field) {
    widgets::QuantityEdit* box = makeNumberField(field, this);
    add(field.name, box, 1);
    return box;
}

void FieldGrid::addPlain(QWidget* field, int columns) {
    add({}, field, columns);
}

void FieldGrid::add(const QString& title, QWidget* field, int columns) {
    auto* grid = static_cast<QGridLayout*>(layout());
    const int row = 2 * (m_next / m_columns);
    const int column = m_next % m_columns;
    if (!title.isEmpty()) {
        auto* label = new QLabel(title, this);
        label->setBuddy(field);
        widgets::setRole(*label, widgets::Role::Muted);
        grid->addWidget(label, row, column);
    }
    grid->addWidget(field, row + 1, column, 1, columns);
    m_next += columns;
}

} // namespace halbench::app
