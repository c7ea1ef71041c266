#include "app/window/start/recent_lists.h"

#include "app/window/start/start_list.h"
#include "app/workbench/recording_control.h"
#include "widgets/theme/theme_style.h"

#include <QDir>
#include <QFileInfo>
#include <QVBoxLayout>

#include <utility>

namespace halbench::app {
namespace {

QString faultText(FileState state) {
    switch (state) {
    case FileState::Missing:
        return RecentLists::tr("moved or deleted");
    case FileState::Unreadable:
        return RecentLists::tr("no permission to read it");
    case FileState::Present:
        break;
    }
    return {};
}

/// "~/motors" is read faster than the whole path, which the tooltip has.
QString folderText(const QString& path) {
    const QString folder = QFileInfo(path).absolutePath();
    const QString home = QDir::homePath();
    const bool isBelow = folder == home || folder.startsWith(home + QLatin1Char('/'));
    return QDir::toNativeSeparators(isBelow ? QLatin1Char('~') + folder.mid(home.size()) : folder);
}

std::vector<RecentFile> takenAsPresent(const QStringList& paths) {
    std::vector<RecentFile> files;
    for (const QString& path : paths) {
        files.push_back({path});
    }
    return files;
}

std::vector<StartEntry> entriesOf(const std::vector<RecentFile>& files) {
    std::vector<StartEntry> entries;
    for (const RecentFile& file : files) {
        entries.push_back(
            {file.path, QFileInfo(file.path).fileName(), folderText(file.path), {}, faultText(file.state)});
    }
    return entries;
}

} // namespace

RecentLists::RecentLists(Workbench& bench, QString builtInFolder, QWidget* parent)
    : QWidget(parent), m_builtInFolder(QDir::cleanPath(std::move(builtInFolder))) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(widgets::GroupSpacing_px);
    const QString tip = tr("Enter opens, Delete removes from the list");
    const QString noProject = tr("No recent projects. Ctrl+O opens one, Ctrl+S saves this one.");
    m_projects = new StartList({tr("Recent projects"), noProject, tip}, StartList::Kind::Files, this);
    const QString noRecording = tr("No recent recordings. Ctrl+R records a device.");
    m_recordings = new StartList({tr("Recent recordings"), noRecording, tip}, StartList::Kind::Files, this);
    column->addWidget(m_projects);
    column->addWidget(m_recordings);
    connectRemoval(*m_projects, recentProjectFiles());
    connectRemoval(*m_recordings, recentRecordingFiles());
    // Until they were looked for, all are taken to be there: most are, and rows that come late move the page.
    show(takenAsPresent(recentProjectFiles().paths()), takenAsPresent(recentRecordingFiles().paths()));
    connect(m_projects, &StartList::shown, this, &RecentLists::refresh);
    connect(m_projects, &StartList::openRequested, this, &RecentLists::projectChosen);
    connect(m_recordings, &StartList::openRequested, this, &RecentLists::recordingChosen);
    follow(bench);
}

void RecentLists::connectRemoval(StartList& list, const RecentFiles& files) {
    connect(&list, &StartList::removeRequested, this, [this, files](const QString& path) {
        files.remove(path);
        refresh();
    });
}

void RecentLists::follow(Workbench& bench) {
    connect(&bench.session(), &DeviceSession::stateChanged, this, [this, &session = bench.session()] {
        const QString file = replayedFile(QString::fromStdString(session.info().uri));
        if (session.state() == SessionState::Connected && !file.isEmpty()) {
            noteRecording(file);
        }
    });
    connect(&bench.recording(), &RecordingControl::finished, this,
            [this](const QString& path) { noteRecording(path); });
}

void RecentLists::noteRecording(const QString& path) {
    if (!QDir::cleanPath(path).startsWith(m_builtInFolder + QLatin1Char('/'))) {
        recentRecordingFiles().add(path);
        refresh();
    }
}

void RecentLists::refresh() {
    m_looking.run(
        [projects = recentProjectFiles().paths(), recordings = recentRecordingFiles().paths()] {
            return std::make_pair(examined(projects), examined(recordings));
        },
        [this](const auto& found) { show(found.first, found.second); });
}

void RecentLists::show(const std::vector<RecentFile>& projects, const std::vector<RecentFile>& recordings) {
    m_projects->setEntries(entriesOf(projects));
    m_recordings->setEntries(entriesOf(recordings));
}

} // namespace halbench::app
