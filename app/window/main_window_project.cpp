// The project of the window: what its panels show, opened, collected, kept.
#include "app/window/docks/dock_layout.h"
#include "app/window/docks/panels.h"
#include "app/window/main_window.h"
#include "app/window/project/project_menu.h"
#include "app/window/project/project_work.h"
#include "app/workspaces/device/device_panel.h"
#include "app/workspaces/device/notes_panel.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "widgets/controls/message_bar.h"
#include "widgets/language/phrasebook.h"

#include <QFileInfo>

#include <algorithm>
#include <optional>
#include <utility>

namespace halbench::app {

namespace {

/// What of a project is not as its file says: documents that were lost, layout of plots that is as usual.
std::optional<widgets::Message> whatIsUnread(const QStringList& lost,
                                             const std::vector<std::string>& resets) {
    QStringList texts;
    QStringList remedies;
    if (!lost.isEmpty()) {
        texts << MainWindow::tr("Parts of the project could not be read: %1").arg(lost.join("; "));
        remedies << MainWindow::tr("They stay in the file unchanged; the rest is open.");
    }
    if (!resets.empty()) {
        QStringList words;
        for (const std::string& reset : resets) {
            words << widgets::inWords(reset);
        }
        texts << MainWindow::tr("Default plots are shown where the project is not valid: %1")
                     .arg(words.join("; "));
        remedies << MainWindow::tr("The file keeps these lines until the project is saved.");
    }
    if (texts.isEmpty()) {
        return std::nullopt;
    }
    return widgets::Message{
        widgets::Severity::Warning, texts.join("; "), remedies.join(QLatin1Char(' ')), {}};
}

} // namespace

void MainWindow::offerCopy(const QString& path) {
    say({widgets::Severity::Warning, tr("%1 is open in another window.").arg(QFileInfo(path).fileName()),
         tr("Close it there, or open a copy as a new project."), tr("Open a copy")},
        [this, path] { m_projects->openCopy(path); });
}

/// The autosave failed: the work is in this window alone.
void MainWindow::sayNotKept(const Error& error) {
    say({widgets::Severity::Error, widgets::inWords(error.message), widgets::inWords(error.hint),
         tr("Save project as…")},
        [this] { m_projects->saveAs(); });
    m_isNotKept = true;
}

void MainWindow::onKept() {
    m_refusal->clear();
    if (std::exchange(m_isNotKept, false)) {
        m_message->clear();
    }
}

void MainWindow::openProject(const QString& path) {
    furnish();
    m_projects->open(path);
}

void MainWindow::recoverUnnamed() {
    furnish();
    if (const auto aside = m_project->setAsideDamaged({})) {
        onMessage(widgets::Severity::Warning,
                  tr("The project's autosave could not be read; it was moved to %1.")
                      .arg(QString::fromStdString(*aside)),
                  {});
    }
    m_docks->setArrangements(m_preferences.arrangements);
    if (const std::optional<Project> left = m_project->recoverable({});
        left && !isSameWork(*left, m_project->project())) {
        m_project->recover({}, *left);
        takeOverProject();
        onMessage(widgets::Severity::Information, tr("Restored your unsaved project."),
                  tr("Save it with a name to keep it."));
    }
    offerInterrupted();
}

/// The last project of those that have unsaved work, e.g. because the program crashed.
void MainWindow::offerInterrupted() {
    const QStringList recent = recentProjects();
    const auto left = std::find_if(recent.begin(), recent.end(), [this](const QString& path) {
        return m_project->wasLeftWithWork(path.toStdString());
    });
    if (left != recent.end()) {
        say({widgets::Severity::Information,
             tr("%1 has unsaved work of an earlier session.").arg(QFileInfo(*left).fileName()),
             tr("Open the project to restore it."), tr("Open the project")},
            [this, path = *left] { m_projects->open(path); });
    }
}

/// What the panels show, as a project.
Project MainWindow::shownProject() const {
    Project project = m_project->project();
    project.device = m_devices->address().toStdString();
    project.notes = m_notes->notes().toStdString();
    project.perspective = perspectiveId(m_docks->perspective()).toStdString();
    const QHash<QString, QByteArray> arrangements = m_docks->arrangements();
    project.layouts.clear();
    for (auto entry = arrangements.begin(); entry != arrangements.end(); ++entry) {
        if (QString::fromUtf8(entry.value()).toUtf8() == entry.value()) { // a damaged one may be no text
            project.layouts[entry.key().toStdString()] = entry.value().toStdString();
        }
    }
    project.monitor = static_cast<MonitorPanel*>(m_docks->panel("monitor"))->view();
    project.furtherMonitors.clear();
    for (const char* id : FurtherMonitors) {
        MonitorView view = static_cast<MonitorPanel*>(m_docks->panel(QString::fromLatin1(id)))->view();
        if (!view.plots.empty()) {
            project.furtherMonitors[id] = std::move(view);
        }
    }
    m_work->fill(project);
    return project;
}

void MainWindow::autosave() {
    collectProject();
    m_project->autosave([this](const Result<void>& saved) {
        if (saved) {
            onKept();
        } else {
            sayNotKept(saved.error());
        }
    });
}

void MainWindow::collectProject() {
    furnish();
    m_project->update(shownProject());
}

/// Nothing is connected or armed by opening a project: the address waits for Connect.
void MainWindow::takeOverProject() {
    furnish();
    if (std::exchange(m_isProjectRefused, false)) {
        m_message->clear(); // another one could be opened
    }
    const Project& project = m_project->project();
    if (m_bench.session().state() == SessionState::Disconnected) {
        m_devices->setAddress(QString::fromStdString(project.device));
    }
    m_notes->setNotes(QString::fromStdString(project.notes));
    QHash<QString, QByteArray> arrangements;
    for (const auto& [perspective, layout] : project.layouts) {
        arrangements.insert(QString::fromStdString(perspective), QByteArray::fromStdString(layout));
    }
    m_docks->setArrangements(arrangements, perspectiveOf(QString::fromStdString(project.perspective)));
    static_cast<MonitorPanel*>(m_docks->panel("monitor"))->setView(project.monitor);
    for (const char* id : FurtherMonitors) {
        const auto kept = project.furtherMonitors.find(id);
        static_cast<MonitorPanel*>(m_docks->panel(QString::fromLatin1(id)))
            ->setView(kept != project.furtherMonitors.end() ? kept->second : MonitorView());
    }
    if (const auto unread = whatIsUnread(m_work->restore(project), project.resets)) {
        onMessage(unread->severity, unread->text, unread->remedy);
    } else if (m_work->isRecordingOwed()) {
        onMessage(widgets::Severity::Information,
                  tr("The project's recording settings apply from the next recording on."),
                  tr("The running recording keeps its settings."));
    }
    if (m_project->path().empty() && !m_project->isChanged()) {
        m_project->beginWith(shownProject());
    }
    refreshTitle();
}

void MainWindow::refreshTitle() {
    const QString name = m_project->path().empty()
                             ? tr("unnamed project")
                             : QFileInfo(QString::fromStdString(m_project->path())).fileName();
    setWindowTitle(tr("%1[*] — Halbench").arg(name));
    setWindowModified(m_project->isWorkUnsaved()); // plots that a device brought are no work
}

} // namespace halbench::app
