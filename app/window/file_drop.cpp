#include "app/window/file_drop.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QUrl>
#include <QWidget>

namespace halbench::app {
namespace {

/// Empty where there is anything that is no file of this machine.
QStringList localFiles(const QMimeData& data) {
    QStringList paths;
    for (const QUrl& url : data.urls()) {
        if (!url.isLocalFile()) {
            return {};
        }
        paths << url.toLocalFile();
    }
    return paths;
}

} // namespace

FileDrop::FileDrop(QWidget& window) : QObject(&window) {
    window.setAcceptDrops(true);
    window.installEventFilter(this);
}

bool FileDrop::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::DragEnter) {
        auto* drag = static_cast<QDragEnterEvent*>(event);
        if (!localFiles(*drag->mimeData()).isEmpty()) {
            drag->acceptProposedAction();
            return true;
        }
    } else if (event->type() == QEvent::Drop) {
        auto* drop = static_cast<QDropEvent*>(event);
        if (const QStringList paths = localFiles(*drop->mimeData()); !paths.isEmpty()) {
            drop->acceptProposedAction();
            take(paths);
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

void FileDrop::take(const QStringList& paths) {
    static const QStringList Tables{QStringLiteral("csv"), QStringLiteral("txt"), QStringLiteral("tsv"),
                                    QStringLiteral("mf4")};
    if (paths.size() > 1) {
        Q_EMIT refused(tr("One file at a time"), tr("Drop one recording or one project."));
        return;
    }
    const QString suffix = QFileInfo(paths.front()).suffix().toLower();
    if (Tables.contains(suffix)) {
        Q_EMIT recordingDropped(paths.front());
    } else if (suffix == QLatin1String("toml")) {
        Q_EMIT projectDropped(paths.front());
    } else {
        Q_EMIT refused(tr("%1 cannot be opened by dropping it").arg(QFileInfo(paths.front()).fileName()),
                       tr("Drop a recording or table (.csv, .txt, .tsv, .mf4) or a project (.toml)."));
    }
}

} // namespace halbench::app
