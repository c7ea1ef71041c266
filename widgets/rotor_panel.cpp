#include "widgets/rotor_panel.h"

#include "widgets/theme_style.h"

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace halbench::widgets {

RotorPanel::RotorPanel(QWidget* parent)
    : QWidget(parent), m_view(new RotorView(this)), m_group(new QButtonGroup(this)) {
    auto* row = new QHBoxLayout;
    row->setSpacing(GridStep_px);
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        m_buttons[i] = new QPushButton(this);
        m_buttons[i]->setCheckable(true);
        m_buttons[i]->setAutoDefault(false);
        m_buttons[i]->setShortcut(QKeySequence(QStringLiteral("Alt+%1").arg(i + 1)));
        m_group->addButton(m_buttons[i], static_cast<int>(i));
        row->addWidget(m_buttons[i]);
    }
    row->addStretch(1);
    m_buttons[0]->setChecked(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(PanelMargin_px, PanelMargin_px, PanelMargin_px, PanelMargin_px);
    column->setSpacing(PanelMargin_px);
    column->addLayout(row);
    column->addWidget(m_view, 1);
    connect(m_group, &QButtonGroup::idClicked, this, [this](int id) {
        m_view->setFieldModel(static_cast<FieldModel>(id));
        Q_EMIT fieldModelChanged(m_view->fieldModel());
    });
    retranslate();
}

void RotorPanel::setFieldModel(FieldModel model) {
    m_buttons[static_cast<std::size_t>(model)]->setChecked(true);
    m_view->setFieldModel(model);
}

void RotorPanel::retranslate() {
    const std::array<QString, 3> names = {tr("Ideal"), tr("Magnets"), tr("Measured")};
    const std::array<QString, 3> purposes = {
        tr("Field lines of the ideal cylinder: uniform inside, none outside"),
        tr("Field lines of the separate magnets, infinitely long"),
        tr("Direction and size of the field that the two Hall sensors see")};
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        const QKeySequence key = m_buttons[i]->shortcut(); // words that hold an ampersand would replace it
        m_buttons[i]->setText(names[i]);
        m_buttons[i]->setShortcut(key);
        m_buttons[i]->setToolTip(
            QStringLiteral("%1 (%2)").arg(purposes[i], key.toString(QKeySequence::NativeText)));
        m_buttons[i]->setAccessibleName(names[i]);
        m_buttons[i]->setAccessibleDescription(purposes[i]);
    }
}

void RotorPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

} // namespace halbench::widgets
