#include "app/window/project_session.h"

#include <QFile>

#include <utility>

namespace halbench::app {

ProjectSession::ProjectSession(std::string unnamedPath, QObject* parent)
    : QObject(parent), m_unnamedPath(std::move(unnamedPath)) {}

ProjectSession::~ProjectSession() {
    finishWriting();
}

void ProjectSession::write(Write next) {
    if (m_isWriting) {
        m_next = std::move(next);
        return;
    }
    finishWriting();
    m_isWriting = true;
    m_writer = std::thread([this, next = std::move(next)] {
        const Result<void> written = saveProject(next.project, next.path);
        QMetaObject::invokeMethod(
            this,
            [this, written, then = next.then] {
                m_isWriting = false;
                if (m_next) {
                    write(*std::exchange(m_next, std::nullopt));
                }
                then(written);
            },
            Qt::QueuedConnection);
    });
}

/// Waits for the writer and writes what waited behind it.
void ProjectSession::finishWriting() {
    if (m_writer.joinable()) {
        m_writer.join();
    }
    if (m_next) {
        const Write last = *std::exchange(m_next, std::nullopt);
        last.then(saveProject(last.project, last.path));
    }
}

std::string ProjectSession::autosaveFile() const {
    return autosavePath(m_path.empty() ? m_unnamedPath : m_path);
}

void ProjectSession::update(const Project& project) {
    if (project != m_project) {
        m_project = project;
        changed();
    }
}

void ProjectSession::startNew() {
    ++m_opened;
    discardAutosave();
    m_path.clear();
    m_project = m_saved = m_autosaved = {};
    changed();
}

Result<void> ProjectSession::open(const std::string& path) {
    Result<Project> read = loadProject(path);
    if (!read) {
        return failure(read.error());
    }
    ++m_opened;
    m_path = path;
    m_project = m_saved = m_autosaved = *std::move(read);
    changed();
    return {};
}

void ProjectSession::save(const std::string& path, Written then) {
    write({m_project, path,
           [this, path, project = m_project, opened = m_opened,
            then = std::move(then)](const Result<void>& written) {
               if (written && opened == m_opened) {
                   discardAutosave();
                   m_path = path;
                   m_saved = m_autosaved = project;
                   changed();
               }
               then(written);
           }});
}

void ProjectSession::autosave(Written then) {
    if (m_project == m_autosaved || m_isWriting) { // the timer comes again
        return;
    }
    write({m_project, autosaveFile(),
           [this, path = autosaveFile(), project = m_project, opened = m_opened,
            then = std::move(then)](const Result<void>& written) {
               if (opened != m_opened) {
                   QFile::remove(QString::fromStdString(path)); // of a project that was left meanwhile
               } else if (written) {
                   m_autosaved = project;
               }
               then(written);
           }});
}

Result<void> ProjectSession::autosaveNow() {
    finishWriting();
    if (m_project == m_autosaved) {
        return {};
    }
    Result<void> written = saveProject(m_project, autosaveFile());
    if (written) {
        m_autosaved = m_project;
    }
    return written;
}

std::optional<Project> ProjectSession::recoverable(const std::string& path) const {
    const Result<Project> left = loadProject(autosavePath(path.empty() ? m_unnamedPath : path));
    return left ? std::optional(*left) : std::nullopt;
}

void ProjectSession::recover(const std::string& path, const Project& project) {
    ++m_opened;
    m_path = path;
    const Result<Project> saved = path.empty() ? Project() : loadProject(path);
    m_saved = saved.value_or(Project());
    m_project = m_autosaved = project;
    changed();
}

void ProjectSession::discardAutosave() {
    QFile::remove(QString::fromStdString(autosaveFile()));
    m_autosaved = m_saved;
}

} // namespace halbench::app
