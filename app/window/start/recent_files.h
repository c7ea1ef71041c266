#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace halbench::app {

/// Whether a file of such a list can be opened.
enum class FileState { Present, Missing, Unreadable };

struct RecentFile {
    QString path;
    FileState state = FileState::Present;

    bool operator==(const RecentFile&) const = default;
};

/// Files that were opened last, newest first, kept in the settings: absolute paths, each once, a few of them.
/// Settings that hold something else count as an empty list.
class RecentFiles {
public:
    static constexpr int Most = 8;

    explicit RecentFiles(QString key) : m_key(std::move(key)) {}

    QStringList paths() const;
    /// To the front.
    void add(const QString& path) const;
    void remove(const QString& path) const;

private:
    QString m_key;
};

RecentFiles recentProjectFiles();
RecentFiles recentRecordingFiles();

/// How these files are now. For a thread of its own: a disk may be slow, or far away.
std::vector<RecentFile> examined(const QStringList& paths);

/// File of a replayed recording's address, "replay:/data/run.csv?at=2.5"; empty for another address.
QString replayedFile(const QString& uri);

} // namespace halbench::app
