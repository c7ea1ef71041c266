#include "app/window/project/project_lock.h"

#include <QFileInfo>

#include <fmt/format.h>

namespace halbench::app {

namespace {

std::string lockPath(const std::string& projectPath) {
    const QFileInfo file(QString::fromStdString(projectPath));
    const QString whole = file.exists() ? file.canonicalFilePath() : file.absoluteFilePath();
    return whole.toStdString() + ".lock";
}

} // namespace

Result<ProjectLock> ProjectLock::take(const std::string& projectPath) {
    ProjectLock lock;
    lock.m_path = lockPath(projectPath);
    lock.m_file = std::make_shared<QLockFile>(QString::fromStdString(lock.m_path));
    lock.m_file->setStaleLockTime(0); // however old: stale is what no living program holds
    if (lock.m_file->tryLock(0)) {
        return lock;
    }
    if (lock.m_file->error() != QLockFile::LockFailedError) {
        lock.m_file.reset();
        return lock;
    }
    qint64 process = 0;
    QString machine;
    QString program;
    lock.m_file->getLockInfo(&process, &machine, &program);
    return failure(ErrorCode::Refused,
                   fmt::format("{} is open in another window (process {} on {})", projectPath, process,
                               machine.toStdString()),
                   fmt::format("close it there; if it is not open, remove {}", lock.m_path));
}

bool ProjectLock::isOf(const std::string& projectPath) const {
    return m_path == lockPath(projectPath);
}

} // namespace halbench::app
