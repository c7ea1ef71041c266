#include "app/workspaces/parts/focus_keeper.h"

namespace halbench::app {

void FocusKeeper::setEnabled(QWidget& control, bool isEnabled) {
    const auto isOf = [&control](const QWidget* widget) {
        return widget != nullptr && (widget == &control || control.isAncestorOf(widget));
    };
    QWidget* focus = control.window()->focusWidget();
    if (!isEnabled && control.isEnabled() && isOf(focus)) {
        m_left = focus;
        m_rest.setFocus();
    }
    control.setEnabled(isEnabled);
    if (isEnabled && isOf(m_left)) {
        if (focus == &m_rest) {
            m_left->setFocus();
        }
        m_left.clear();
    }
}

} // namespace halbench::app
