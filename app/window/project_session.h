#pragma once

#include "app/window/project_file.h"

#include <QObject>

#include <functional>
#include <optional>
#include <string>
#include <thread>

namespace halbench::app {

/// The project the window works on: where it is kept, whether it was changed, and its autosave, so that a
/// crash costs at most the last few seconds. Files are written on a thread of their own, one after the other:
/// a disk that is slow holds up nothing, above all no stop. Thread: GUI.
class ProjectSession : public QObject {
    Q_OBJECT

public:
    using Written = std::function<void(const Result<void>&)>;

    /// `unnamedPath` is where a project without a name is autosaved.
    explicit ProjectSession(std::string unnamedPath, QObject* parent = nullptr);
    /// Completes what is being written.
    ~ProjectSession() override;

    const Project& project() const { return m_project; }
    const std::string& path() const { return m_path; } ///< empty: not saved yet
    bool isChanged() const { return m_project != m_saved; }

    void update(const Project& project);
    void startNew();
    /// Errors: FileSystem, InvalidInput; the project that was open stays.
    Result<void> open(const std::string& path);
    /// `then` gets the outcome; the project has the path and is unchanged from then on.
    void save(const std::string& path, Written then);
    /// Writes the autosave if something changed since; `then` gets the outcome if it does.
    void autosave(Written then);
    /// The same, complete when it returns: for the end of the program.
    Result<void> autosaveNow();

    /// The autosave that an interrupted program left for this project or for one without a name.
    std::optional<Project> recoverable(const std::string& path) const;
    /// Takes it over as unsaved work.
    void recover(const std::string& path, const Project& project);
    void discardAutosave();

Q_SIGNALS:
    void changed();

private:
    struct Write {
        Project project;
        std::string path;
        Written then;
    };
    void write(Write next);
    void finishWriting();
    std::string autosaveFile() const;

    std::string m_unnamedPath;
    std::string m_path;
    Project m_project;
    Project m_saved;
    Project m_autosaved;
    std::uint64_t m_opened = 0; ///< counts projects: what was written for an older one is not this one's news
    bool m_isWriting = false;
    std::optional<Write> m_next; ///< waits for the one that is being written
    std::thread m_writer;
};

} // namespace halbench::app
