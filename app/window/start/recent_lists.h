#pragma once

#include "app/window/start/recent_files.h"
#include "app/workbench/latest_task.h"
#include "app/workbench/workbench.h"

#include <QWidget>

namespace halbench::app {

class StartList;

/// Recent projects and recordings of the start page. A recording counts as recent when it was opened,
/// replayed or made; the files are looked for in a thread of its own whenever the lists come into sight.
class RecentLists : public QWidget {
    Q_OBJECT

public:
    /// Recordings below `builtInFolder` come with the program and are listed elsewhere.
    RecentLists(Workbench& bench, QString builtInFolder, QWidget* parent);

Q_SIGNALS:
    void projectChosen(const QString& path);
    void recordingChosen(const QString& path);

private:
    void connectRemoval(StartList& list, const RecentFiles& files);
    void follow(Workbench& bench);
    void noteRecording(const QString& path);
    void refresh();
    void show(const std::vector<RecentFile>& projects, const std::vector<RecentFile>& recordings);

    QString m_builtInFolder;
    StartList* m_projects = nullptr;
    StartList* m_recordings = nullptr;
    LatestTask m_looking;
};

} // namespace halbench::app
