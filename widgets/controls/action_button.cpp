#include "widgets/controls/action_button.h"

#include <QAction>

namespace halbench::widgets {

ActionButton::ActionButton(QAction& action, Shape shape, QWidget* parent)
    : QPushButton(parent), m_action(action), m_shape(shape) {
    setAutoDefault(false);
    connect(&action, &QAction::changed, this, &ActionButton::follow);
    connect(this, &QPushButton::clicked, &action, &QAction::trigger);
    follow();
}

void ActionButton::follow() {
    setIcon(m_action.icon());
    setText(m_shape == Shape::IconAndText ? m_action.text() : QString());
    setToolTip(m_action.toolTip());
    setAccessibleName(m_action.text());
    setAccessibleDescription(m_action.toolTip());
    setEnabled(m_action.isEnabled());
    setCheckable(m_action.isCheckable());
    setChecked(m_action.isChecked());
}

} // namespace halbench::widgets
