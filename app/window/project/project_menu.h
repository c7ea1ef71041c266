#pragma once

#include "app/window/project/project_session.h"
#include "app/workbench/file_chooser.h"

#include <QObject>
#include <QStringList>

#include <functional>
#include <string>

class QMenu;
class QWidget;

namespace halbench::app {

/// New, open, save and recent projects as a menu; asks for file names and shows what went wrong.
/// Thread: GUI.
class ProjectMenu : public QObject {
    Q_OBJECT

public:
    ProjectMenu(ProjectSession& session, FileChooser files, QWidget* window);

    void addTo(QMenu& menu);
    /// While this says so no project is left or opened: a file that is read holds up this thread.
    void setBusy(std::function<bool()> isBusy) { m_isBusy = std::move(isBusy); }
    /// Opens the file; an autosave of it that is newer work is offered in `recovered()`.
    void open(const QString& path);
    /// As a new project without a name; the file stays with the window that has it.
    void openCopy(const QString& path);
    void saveAs();
    /// After unkept(): what was asked for, once more, or without what is not saved.
    void tryAgain();
    void discard();
    void stay(); ///< what was asked for is not wanted any more

Q_SIGNALS:
    void collecting();                ///< the session shall know what the panels show before it goes on
    void locked(const QString& path); ///< another window has it
    void opened();                    ///< another project is there: the window takes it over
    void saved();
    void refused(const QString& text, const QString& hint);
    void recovered(const QString& text, const QString& hint);
    /// The project that is open could not be kept and stays open: tryAgain(), saveAs() or discard().
    void unkept(const halbench::Error& error);

private:
    bool refuseWhileBusy();
    void leaveThen(std::function<void()> next);
    void goOn();
    void startNew();
    void chooseAndOpen();
    void openFile(const QString& path);
    void openUnnamed(const std::string& place);
    void save();
    void write(const QString& path);
    void remember(const QString& path);
    void fillRecent();
    void addUnnamed();
    void say(const Error& error);

    ProjectSession& m_session;
    FileChooser m_files;
    QWidget* m_window;
    std::function<bool()> m_isBusy = [] { return false; };
    QMenu* m_recent = nullptr;
    std::function<void()> m_next; ///< what waits until the open project is kept
};

/// Newest first, at most eight.
QStringList recentProjects();

} // namespace halbench::app
