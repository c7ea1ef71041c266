#pragma once

#include "app/window/project_file.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <optional>
#include <string>

namespace halbench::app {

/// The project the window works on: where it is kept, whether it was changed, and its autosave, so that a
/// crash costs at most the last few seconds. Thread: GUI.
class ProjectSession : public QObject {
    Q_OBJECT

public:
    /// `unnamedPath` is where a project without a name is autosaved.
    explicit ProjectSession(std::string unnamedPath, QObject* parent = nullptr);

    const Project& project() const { return m_project; }
    const std::string& path() const { return m_path; } ///< empty: not saved yet
    bool isChanged() const { return m_project != m_saved; }

    void update(const Project& project);
    void startNew();
    /// Errors: FileSystem, InvalidInput; the project that was open stays.
    Result<void> open(const std::string& path);
    Result<void> save(const std::string& path);
    /// Writes the autosave now if something changed since.
    Result<void> autosave();

    /// The autosave that an interrupted program left for this project or for one without a name.
    std::optional<Project> recoverable(const std::string& path) const;
    /// Takes it over as unsaved work.
    void recover(const std::string& path, const Project& project);
    void discardAutosave();

Q_SIGNALS:
    void changed();

private:
    std::string autosaveFile() const;

    std::string m_unnamedPath;
    std::string m_path;
    Project m_project;
    Project m_saved;
    Project m_autosaved;
};

} // namespace halbench::app
