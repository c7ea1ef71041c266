#include "app/workspaces/parts/panel_parts.h"

#include "widgets/controls/quantity_edit.h"
#include "widgets/theme/icons.h"

#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace halbench::app {

widgets::QuantityEdit* makeNumberField(const NumberField& field, QWidget* parent) {
    auto* box = new widgets::QuantityEdit(parent);
    box->setFont(widgets::tabularFont(box->font()));
    dressNumberField(*box, field);
    return box;
}

void dressNumberField(widgets::QuantityEdit& box, const NumberField& field) {
    box.setFormat({field.unit, field.min, field.max, field.step, field.decimals});
    box.setAccessibleName(field.name);
    box.setToolTip(field.toolTip.isEmpty() ? box.toolTip()
                                           : field.toolTip + QLatin1Char('\n') + box.toolTip());
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
    auto* content = new QWidget(panel);
    QVBoxLayout* column = makePanelColumn(content);
    QScrollArea* scroll = makeScrollArea(content);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    outer->addWidget(scroll, 1); // all that rows below it, as a message, do not need
    return column;
}

QScrollArea* makeScrollArea(QWidget* content) {
    auto* scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(content);
    return scroll;
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

void reserveLines(QLabel& note, int lines) {
    note.setMinimumHeight(lines * note.fontMetrics().lineSpacing());
    note.setAlignment(Qt::AlignLeft | Qt::AlignTop);
}

} // namespace halbench::app
