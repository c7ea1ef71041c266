#include "app/window/project/project_session.h"

#include <QFile>

#include <utility>

namespace halbench::app {

ProjectSession::ProjectSession(std::string unnamedPath, QObject* parent)
    : QObject(parent), m_unnamedBase(std::move(unnamedPath)), m_unnamed(claimUnnamed(m_unnamedBase, false)) {}

ProjectSession::~ProjectSession() {
    finishWriting();
}

void ProjectSession::write(Write next) {
    m_writes.push_back(std::move(next));
    startWriting();
}

void ProjectSession::startWriting() {
    if (m_writer.joinable() || m_writes.empty()) {
        return;
    }
    const Write& next = m_writes.front(); // stays there until completeWrite()
    m_writer = std::thread([this, &next, number = m_completed] {
        m_outcome = saveProject(next.project, next.path);
        QMetaObject::invokeMethod(
            this,
            [this, number] {
                if (number == m_completed) { // nobody waited for it
                    completeWrite();
                }
            },
            Qt::QueuedConnection);
    });
}

/// What the write holds, above all a lock, is free when this returns.
void ProjectSession::completeWrite() {
    m_writer.join();
    ++m_completed;
    const Write done = std::move(m_writes.front());
    const Result<void> outcome = std::exchange(m_outcome, {});
    m_writes.pop_front();
    startWriting();
    done.then(outcome);
}

void ProjectSession::finishWriting() {
    while (m_writer.joinable()) {
        completeWrite();
    }
}

/// A project that was left a moment ago is locked by its own last write: that is waited for, so that what it
/// keeps is read too.
Result<ProjectLock> ProjectSession::lockOf(const std::string& path) {
    if (m_lock.isOf(path)) {
        return m_lock;
    }
    Result<ProjectLock> lock = ProjectLock::take(path);
    if (!lock && m_writer.joinable()) {
        finishWriting();
        lock = ProjectLock::take(path);
    }
    return lock;
}

std::string ProjectSession::autosaveOf(const std::string& path) const {
    return autosavePath(path.empty() ? m_unnamed.path : path);
}

std::string ProjectSession::autosaveFile() const {
    return autosaveOf(m_path);
}

void ProjectSession::update(const Project& project) {
    if (project != m_project) {
        m_project = project;
        changed();
    }
}

void ProjectSession::beginWith(const Project& shown) {
    m_project = m_saved = m_autosaved = shown;
    changed();
}

void ProjectSession::startNew() {
    leave();
    take({}, {}, {}, {});
}

bool ProjectSession::isWorkUnsaved() const {
    return m_path.empty() ? holdsWork(m_project) : isChanged();
}

void ProjectSession::keep(Written then) {
    // Behind an autosave that is on its way: whether that one succeeds is not known yet.
    if (!isWorkUnsaved() || (isSameWork(m_project, m_autosaved) && !m_writer.joinable())) {
        then({});
        return;
    }
    write(
        {m_project, autosaveFile(),
         [this, project = m_project, opened = m_opened, then = std::move(then)](const Result<void>& written) {
             if (written && opened == m_opened) {
                 m_autosaved = project;
             }
             then(written);
         }});
}

void ProjectSession::giveUp() {
    m_project = m_saved;
}

/// The autosave stays where something would be lost, and its place with it.
void ProjectSession::leave() {
    const bool isUnnamed = m_path.empty();
    *m_isLeftWithWork = isWorkUnsaved();
    if (!*m_isLeftWithWork) {
        discardAutosave();
        return;
    }
    if (!isSameWork(m_project, m_autosaved) || m_writer.joinable()) {
        write({m_project, autosaveFile(),
               [this, lock = isUnnamed ? m_unnamed.lock : m_lock](const Result<void>& written) {
                   if (!written) {
                       notKept(written.error());
                   }
               }});
    }
    if (isUnnamed) {
        m_unnamed = claimUnnamed(m_unnamedBase, true);
    }
}

void ProjectSession::take(std::string path, ProjectLock lock, Project project, Project saved) {
    ++m_opened;
    m_isLeftWithWork = std::make_shared<bool>(false);
    m_path = std::move(path);
    m_lock = std::move(lock);
    m_project = std::move(project);
    m_saved = m_autosaved = std::move(saved);
    changed();
}

Result<void> ProjectSession::open(const std::string& path) {
    Result<ProjectLock> lock = lockOf(path);
    if (!lock) {
        return failure(lock.error());
    }
    const Result<Project> read = loadProject(path);
    if (!read) {
        return failure(read.error());
    }
    leave();
    take(path, *std::move(lock), *read, *read);
    return {};
}

Result<void> ProjectSession::openCopy(const std::string& path) {
    const Result<Project> read = loadProject(path);
    if (!read) {
        return failure(read.error());
    }
    leave();
    take({}, {}, *read, {});
    return {};
}

Result<void> ProjectSession::openUnnamed(const std::string& path) {
    Result<ProjectLock> lock = lockOf(path);
    if (!lock) {
        return failure(lock.error());
    }
    const Result<Project> left = loadProject(autosavePath(path));
    if (!left) {
        return failure(left.error());
    }
    leave();
    m_unnamed = {path, *std::move(lock)};
    recover({}, *left);
    return {};
}

void ProjectSession::save(const std::string& path, Written then) {
    const Result<ProjectLock> lock = lockOf(path);
    if (!lock) {
        then(failure(lock.error()));
        return;
    }
    write({m_project, path,
           [this, path, lock = *lock, project = m_project, opened = m_opened,
            then = std::move(then)](const Result<void>& written) {
               if (written && opened == m_opened) {
                   discardAutosave();
                   m_path = path;
                   m_lock = lock;
                   m_saved = m_autosaved = project;
                   changed();
               }
               then(written);
           }});
}

void ProjectSession::autosave(Written then) {
    if (isSameWork(m_project, m_autosaved) || m_writer.joinable()) { // the timer comes again
        return;
    }
    write({m_project, autosaveFile(),
           [this, path = autosaveFile(), project = m_project, opened = m_opened, isKept = m_isLeftWithWork,
            then = std::move(then)](const Result<void>& written) {
               if (opened != m_opened) {
                   if (!*isKept) {
                       QFile::remove(QString::fromStdString(path)); // of a project that was left meanwhile
                   }
               } else if (written) {
                   m_autosaved = project;
               }
               then(written);
           }});
}

Result<void> ProjectSession::autosaveNow() {
    finishWriting();
    if (isSameWork(m_project, m_autosaved)) {
        return {};
    }
    Result<void> written = saveProject(m_project, autosaveFile());
    if (written) {
        m_autosaved = m_project;
    }
    return written;
}

std::optional<Project> ProjectSession::recoverable(const std::string& path) const {
    const Result<Project> left = loadProject(autosaveOf(path));
    return left ? std::optional(*left) : std::nullopt;
}

bool ProjectSession::wasLeftWithWork(const std::string& path) const {
    const std::optional<Project> left = has(path) ? std::nullopt : recoverable(path);
    const Result<Project> saved = left ? loadProject(path) : Result<Project>(Project());
    return left && saved && !isSameWork(*left, *saved) && ProjectLock::take(path).has_value();
}

std::optional<std::string> ProjectSession::setAsideDamaged(const std::string& path) const {
    const QString file = QString::fromStdString(autosaveOf(path));
    if (!QFile::exists(file) || loadProject(file.toStdString())) {
        return std::nullopt;
    }
    QString aside = file + QStringLiteral(".damaged");
    for (int number = 2; QFile::exists(aside); ++number) {
        aside = file + QStringLiteral(".damaged-%1").arg(number);
    }
    return QFile::rename(file, aside) ? std::optional(aside.toStdString()) : std::nullopt;
}

void ProjectSession::recover(const std::string& path, const Project& project) {
    const Result<Project> saved = path.empty() ? Project() : loadProject(path);
    take(path, path.empty() ? ProjectLock() : m_lock, project, saved.value_or(Project()));
    m_autosaved = project;
}

void ProjectSession::discardAutosave() {
    QFile::remove(QString::fromStdString(autosaveFile()));
    m_autosaved = m_saved;
}

} // namespace halbench::app
