#pragma once

#include "app/window/project_session.h"
#include "app/workspaces/file_chooser.h"

#include <QObject>
#include <QStringList>

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
    /// Opens the file; an autosave of it that is newer work is offered in `recovered()`.
    void open(const QString& path);
    /// As a new project without a name; the file stays with the window that has it.
    void openCopy(const QString& path);
    void saveAs();

Q_SIGNALS:
    void collecting();                ///< the session shall know what the panels show before it goes on
    void locked(const QString& path); ///< another window has it
    void opened();                    ///< another project is there: the window takes it over
    void saved();
    void refused(const QString& text, const QString& hint);
    void recovered(const QString& text, const QString& hint);

private:
    void startNew();
    void chooseAndOpen();
    void save();
    void write(const QString& path);
    void remember(const QString& path);
    void fillRecent();
    void addUnnamed();
    void say(const Error& error);

    ProjectSession& m_session;
    FileChooser m_files;
    QWidget* m_window;
    QMenu* m_recent = nullptr;
};

/// Newest first, at most eight.
QStringList recentProjects();

} // namespace halbench::app
