#include "app/window/start/recent_files.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSettings>

namespace halbench::app {
namespace {

QString wholePath(const QString& path) {
    return QDir::cleanPath(QFileInfo(path).absoluteFilePath());
}

FileState stateOf(const QString& path) {
    const QFileInfo file(path);
    if (!file.isFile()) {
        return FileState::Missing;
    }
    return file.isReadable() ? FileState::Present : FileState::Unreadable;
}

} // namespace

/// A list that another program, or a hand, wrote may have anything in it.
QStringList RecentFiles::paths() const {
    QStringList paths;
    for (const QString& path : QSettings().value(m_key).toStringList()) {
        if (paths.size() < Most && QFileInfo(path).isAbsolute() && !paths.contains(wholePath(path))) {
            paths << wholePath(path);
        }
    }
    return paths;
}

void RecentFiles::add(const QString& path) const {
    QStringList list = paths();
    const QString whole = wholePath(path);
    list.removeAll(whole);
    list.prepend(whole);
    QSettings().setValue(m_key, QStringList(list.mid(0, Most)));
}

void RecentFiles::remove(const QString& path) const {
    QStringList list = paths();
    list.removeAll(wholePath(path));
    QSettings().setValue(m_key, list);
}

RecentFiles recentProjectFiles() {
    return RecentFiles(QStringLiteral("recent_projects"));
}

RecentFiles recentRecordingFiles() {
    return RecentFiles(QStringLiteral("recent_recordings"));
}

std::vector<RecentFile> examined(const QStringList& paths) {
    std::vector<RecentFile> files;
    for (const QString& path : paths) {
        files.push_back({path, stateOf(path)});
    }
    return files;
}

QString replayedFile(const QString& uri) {
    static const QRegularExpression StartTime(QStringLiteral(R"(\?at=[-+.0-9eE]+$)"));
    const QString scheme = QStringLiteral("replay:");
    return uri.startsWith(scheme) ? uri.mid(scheme.size()).remove(StartTime) : QString();
}

} // namespace halbench::app
