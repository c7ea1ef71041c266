#include "widgets/figure/picture_actions.h"

#include "widgets/theme/icons.h"

#include <QAction>
#include <QWidget>

namespace halbench::widgets {

void addPictureActions(QWidget& view, QAction& copy, QAction& save) {
    view.setFocusPolicy(Qt::StrongFocus);
    view.setContextMenuPolicy(Qt::ActionsContextMenu);
    copy.setIcon(themedIcon(QStringLiteral("copy")));
    copy.setShortcut(QKeySequence::Copy);
    save.setIcon(themedIcon(QStringLiteral("picture")));
    save.setShortcut(QKeySequence(QStringLiteral("Ctrl+E")));
    for (QAction* action : {&copy, &save}) {
        action->setShortcutContext(Qt::WidgetShortcut);
        view.addAction(action);
    }
}

} // namespace halbench::widgets
