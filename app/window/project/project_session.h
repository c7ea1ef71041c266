#pragma once

#include "app/window/project/project_file.h"
#include "app/window/project/project_lock.h"
#include "app/window/project/unnamed_projects.h"

#include <QObject>

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

namespace halbench::app {

/// The project the window works on: where it is kept, whether it was changed, and its autosave, so that a
/// crash costs at most the last few seconds. Files are written on a thread of their own, one after the other:
/// a disk that is slow holds up nothing, above all no stop. A project that is open here is locked for other
/// windows, and each window has an autosave of its own (resources/help/projects.md). Thread: GUI.
class ProjectSession : public QObject {
    Q_OBJECT

public:
    using Written = std::function<void(const Result<void>&)>;

    /// `unnamedPath` is where a project without a name is autosaved, or beside it when another window has
    /// that (unnamed_projects.h).
    explicit ProjectSession(std::string unnamedPath, QObject* parent = nullptr);
    /// As finishWriting().
    ~ProjectSession() override;

    const Project& project() const { return m_project; }
    const std::string& path() const { return m_path; } ///< empty: not saved yet
    bool isChanged() const { return !isSameWork(m_project, m_saved); }
    /// Whether this file is the one that is open here.
    bool has(const std::string& path) const { return !m_path.empty() && m_lock.isOf(path); }

    /// Changed; without a name only what someone worked on counts, not what a device brought to the panels.
    bool isWorkUnsaved() const;

    void update(const Project& project);
    /// What the panels show of a new project before anyone touches them: no change of it.
    void beginWith(const Project& shown);
    /// Writes what the autosave lacks, so that the project can be left; `then` gets the outcome, at once when
    /// there is nothing to write.
    void keep(Written then);
    /// What was not saved is not kept: the user said so.
    void giveUp();
    /// What was not saved of the project before stays in its autosave; the same in the next three.
    void startNew();
    /// Errors: FileSystem, InvalidInput, Refused (another window has it); the project that was open stays.
    Result<void> open(const std::string& path);
    /// As a new project without a name, whoever has the file. Errors: FileSystem, InvalidInput.
    Result<void> openCopy(const std::string& path);
    /// A place of waitingUnnamed(). Errors: as of open().
    Result<void> openUnnamed(const std::string& path);
    std::vector<std::string> waiting() const { return waitingUnnamed(m_unnamedBase); }
    /// `then` gets the outcome; the project has the path and is unchanged from then on. Errors: FileSystem,
    /// Refused (another window has the path).
    void save(const std::string& path, Written then);
    /// Writes the autosave if something changed since; `then` gets the outcome if it does.
    void autosave(Written then);
    /// The same, complete when it returns: for the end of the program.
    Result<void> autosaveNow();
    /// Waits until all that is being written is, and answers it.
    void finishWriting();

    /// The autosave that an interrupted program left for this project or for one without a name.
    std::optional<Project> recoverable(const std::string& path) const;
    /// Whether opening this file would recover work: its autosave holds some, and no window has it open.
    bool wasLeftWithWork(const std::string& path) const;
    /// An autosave that cannot be read is renamed; says to what.
    std::optional<std::string> setAsideDamaged(const std::string& path) const;
    /// Takes it over as unsaved work.
    void recover(const std::string& path, const Project& project);
    void discardAutosave();

Q_SIGNALS:
    void changed();
    void notKept(const halbench::Error& error); ///< work that was left could not be written

private:
    struct Write {
        Project project;
        std::string path;
        Written then;
    };
    void write(Write next);
    void startWriting();
    void completeWrite();
    Result<ProjectLock> lockOf(const std::string& path);
    void leave();
    void take(std::string path, ProjectLock lock, Project project, Project saved);
    std::string autosaveFile() const;
    std::string autosaveOf(const std::string& path) const;

    std::string m_unnamedBase;
    UnnamedPlace m_unnamed;
    std::string m_path;
    ProjectLock m_lock;
    Project m_project;
    Project m_saved;
    Project m_autosaved;
    std::uint64_t m_opened = 0; ///< counts projects: what was written for an older one is not this one's news
    std::shared_ptr<bool> m_isLeftWithWork = std::make_shared<bool>(false); ///< of the project that is open
    std::deque<Write> m_writes;    ///< the first is being written, the others wait for it
    std::uint64_t m_completed = 0; ///< writes; tells one that was waited for from the next
    Result<void> m_outcome;        ///< of the first, once the writer has ended
    std::thread m_writer;
};

} // namespace halbench::app
