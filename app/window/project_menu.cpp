#include "app/window/project_menu.h"

#include "widgets/phrasebook.h"

#include <QFileInfo>
#include <QMenu>
#include <QPointer>
#include <QSettings>

namespace halbench::app {

namespace {

constexpr int MostRecent = 8;
constexpr const char* RecentKey = "recent_projects";

} // namespace

QStringList recentProjects() {
    return QSettings().value(RecentKey).toStringList().mid(0, MostRecent);
}

ProjectMenu::ProjectMenu(ProjectSession& session, FileChooser files, QWidget* window)
    : QObject(window), m_session(session), m_files(std::move(files)), m_window(window) {}

void ProjectMenu::addTo(QMenu& menu) {
    menu.addAction(tr("&New project"), this, &ProjectMenu::startNew)->setShortcut(QKeySequence::New);
    menu.addAction(tr("&Open project…"), this, &ProjectMenu::chooseAndOpen)->setShortcut(QKeySequence::Open);
    m_recent = menu.addMenu(tr("Open &recent"));
    connect(m_recent, &QMenu::aboutToShow, this, &ProjectMenu::fillRecent);
    menu.addAction(tr("&Save project"), this, &ProjectMenu::save)->setShortcut(QKeySequence::Save);
    menu.addAction(tr("Save project &as…"), this, &ProjectMenu::saveAs)->setShortcut(QKeySequence::SaveAs);
}

void ProjectMenu::startNew() {
    m_session.startNew();
    opened();
}

void ProjectMenu::chooseAndOpen() {
    const QString path = m_files.open(m_window, {tr("Open project"), {}, tr("Halbench project (*.toml)")});
    if (!path.isEmpty()) {
        open(path);
    }
}

void ProjectMenu::open(const QString& path) {
    const std::string file = path.toStdString();
    if (const Result<void> read = m_session.open(file); !read) {
        refused(widgets::inWords(read.error().message), widgets::inWords(read.error().hint));
        return;
    }
    remember(path);
    if (const std::optional<Project> left = m_session.recoverable(file);
        left && *left != m_session.project()) {
        m_session.recover(file, *left);
        recovered(
            tr("Unsaved work of %1 was recovered; save it to keep it.").arg(QFileInfo(path).fileName()));
    }
    opened();
}

void ProjectMenu::save() {
    if (m_session.path().empty()) {
        saveAs();
    } else {
        write(QString::fromStdString(m_session.path()));
    }
}

void ProjectMenu::saveAs() {
    const QString path = m_files.save(
        m_window, {tr("Save project as"), QStringLiteral("motor.toml"), tr("Halbench project (*.toml)")});
    if (!path.isEmpty()) {
        write(path);
    }
}

void ProjectMenu::write(const QString& path) {
    m_session.save(path.toStdString(), [self = QPointer(this), path](const Result<void>& written) {
        if (!self) {
            return;
        }
        if (written) {
            self->remember(path);
        } else {
            self->refused(widgets::inWords(written.error().message), widgets::inWords(written.error().hint));
        }
    });
}

void ProjectMenu::remember(const QString& path) {
    QStringList recent = recentProjects();
    const QString whole = QFileInfo(path).absoluteFilePath();
    recent.removeAll(whole);
    recent.prepend(whole);
    QSettings().setValue(RecentKey, QStringList(recent.mid(0, MostRecent)));
}

void ProjectMenu::fillRecent() {
    m_recent->clear();
    for (const QString& path : recentProjects()) {
        m_recent->addAction(path, this, [this, path] { open(path); });
    }
    if (m_recent->isEmpty()) {
        m_recent->addAction(tr("No project was opened yet"))->setEnabled(false);
    }
}

} // namespace halbench::app
