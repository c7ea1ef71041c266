#include "app/workspaces/panel_parts.h"

#include "widgets/icons.h"

#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace halbench::app {

QDoubleSpinBox* makeNumberField(const NumberField& field, QWidget* parent) {
    auto* box = new QDoubleSpinBox(parent);
    box->setKeyboardTracking(false);
    box->setAlignment(Qt::AlignRight);
    box->setFont(widgets::tabularFont(box->font()));
    dressNumberField(*box, field);
    return box;
}

void dressNumberField(QDoubleSpinBox& box, const NumberField& field) {
    box.setAccessibleName(field.name);
    box.setToolTip(field.toolTip);
    box.setSuffix(field.unit.isEmpty() ? QString() : QLatin1Char(' ') + field.unit);
    box.setDecimals(field.decimals);
    box.setRange(field.min, field.max);
    box.setSingleStep(field.step);
}

QPushButton* makeButton(const PushAction& action, QWidget* parent) {
    auto* button = new QPushButton(action.text, parent);
    button->setToolTip(action.toolTip);
    button->setAccessibleDescription(action.toolTip);
    if (!action.icon.isEmpty()) {
        button->setIcon(widgets::themedIcon(action.icon));
    }
    return button;
}

QVBoxLayout* makePanelColumn(QWidget* panel) {
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(widgets::PanelMargin_px, widgets::PanelMargin_px, widgets::PanelMargin_px,
                               widgets::PanelMargin_px);
    column->setSpacing(widgets::PanelMargin_px);
    return column;
}

QVBoxLayout* makeScrollingColumn(QWidget* panel) {
    auto* outer = new QVBoxLayout(panel);
    outer->setContentsMargins(0, 0, 0, 0);
    auto* scroll = new QScrollArea(panel);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    auto* content = new QWidget(scroll);
    QVBoxLayout* column = makePanelColumn(content);
    scroll->setWidget(content);
    outer->addWidget(scroll);
    return column;
}

QVBoxLayout* addSection(QBoxLayout* column, const QString& title, QWidget* parent) {
    auto* box = new QGroupBox(title, parent);
    auto* inner = new QVBoxLayout(box);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->setSpacing(widgets::GridStep_px);
    column->addWidget(box);
    return inner;
}

void showRole(QWidget& widget, widgets::Role role) {
    if (widgets::roleOf(widget) != role) {
        widgets::setRole(widget, role);
    }
}

QLabel* makeNote(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    widgets::setRole(*label, widgets::Role::Muted);
    return label;
}

} // namespace halbench::app
