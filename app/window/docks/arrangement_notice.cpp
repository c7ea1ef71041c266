#include "app/window/docks/arrangement_notice.h"

#include "app/window/docks/dock_layout.h"

namespace halbench::app {

ArrangementNotice::ArrangementNotice(DockLayout& docks, QWidget* parent) : MessageBar(parent) {
    connect(&docks, &DockLayout::arrangementUnread, this, &ArrangementNotice::say);
}

void ArrangementNotice::say(Perspective perspective, ArrangementFault fault, const QString& keptAs) {
    const QString title = perspectiveTitle(perspective).replace(QLatin1String("&&"), QLatin1String("&"));
    QString text;
    switch (fault) {
    case ArrangementFault::Damaged:
        text = tr("The panel layout in %1 is damaged. The default layout is shown.");
        break;
    case ArrangementFault::Newer:
        text = tr("The panel layout in %1 is from a newer version. The default layout is shown.");
        break;
    case ArrangementFault::Older:
        text = tr("The panel layout in %1 is from an older version. The default layout is shown.");
        break;
    }
    showMessage({widgets::Severity::Warning,
                 text.arg(title),
                 tr("The old layout stays in the file as %1.").arg(keptAs),
                 {}});
}

} // namespace halbench::app
