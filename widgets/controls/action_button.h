#pragma once

#include <QPushButton>

class QAction;

namespace halbench::widgets {

/// A push button that is an action: its icon, words, tooltip and state follow the action's.
class ActionButton : public QPushButton {
    Q_OBJECT
public:
    enum class Shape { IconAndText, IconOnly };
    ActionButton(QAction& action, Shape shape, QWidget* parent = nullptr);

private:
    void follow();

    QAction& m_action;
    Shape m_shape;
};

} // namespace halbench::widgets
