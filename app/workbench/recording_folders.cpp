#include "app/workbench/recording_folders.h"

#include "app/recordings/recording_list.h"

#include <QStandardPaths>

namespace halbench::app {

QString defaultRecordingFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + QStringLiteral("/Halbench");
}

QStringList interruptedIn(const QString& folder) {
    QStringList paths;
    for (const RecordingEntry& entry : recordingsIn(folder)) {
        if (entry.isInterrupted) {
            paths.append(entry.path);
        }
    }
    return paths;
}

} // namespace halbench::app
