#include "app/window/project_session.h"

#include <QFile>

#include <utility>

namespace halbench::app {

ProjectSession::ProjectSession(std::string unnamedPath, QObject* parent)
    : QObject(parent), m_unnamedPath(std::move(unnamedPath)) {}

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
    m_path = path;
    m_project = m_saved = m_autosaved = *std::move(read);
    changed();
    return {};
}

Result<void> ProjectSession::save(const std::string& path) {
    if (Result<void> written = saveProject(m_project, path); !written) {
        return written;
    }
    discardAutosave();
    m_path = path;
    m_saved = m_autosaved = m_project;
    changed();
    return {};
}

Result<void> ProjectSession::autosave() {
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
