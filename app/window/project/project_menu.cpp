#include "app/window/project/project_menu.h"

#include "app/window/start/recent_files.h"
#include "widgets/language/local_time.h"
#include "widgets/language/phrasebook.h"

#include <QDateTime>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QPointer>

#include <utility>

namespace halbench::app {

QStringList recentProjects() {
    return recentProjectFiles().paths();
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

bool ProjectMenu::refuseWhileBusy() {
    const bool isBusy = m_isBusy();
    if (isBusy) {
        refused(tr("A project cannot be opened while the actuator is armed or a procedure is running: a slow "
                   "disk would delay Esc."),
                tr("Disarm, or wait for the end of the procedure, then open the project."));
    }
    return isBusy;
}

/// What is open is left once all of it is kept; until then it stays.
void ProjectMenu::leaveThen(std::function<void()> next) {
    if (refuseWhileBusy()) {
        return;
    }
    collecting();
    m_next = std::move(next);
    m_session.keep([self = QPointer(this)](const Result<void>& kept) {
        if (!self || !self->m_next) {
            return;
        }
        if (kept) {
            self->goOn();
        } else {
            self->unkept(kept.error());
        }
    });
}

/// It may have been armed while the project was written.
void ProjectMenu::goOn() {
    const auto next = std::exchange(m_next, {});
    if (!refuseWhileBusy()) {
        next();
    }
}

void ProjectMenu::tryAgain() {
    if (m_next) {
        leaveThen(m_next);
    }
}

void ProjectMenu::discard() {
    if (m_next && !refuseWhileBusy()) {
        m_session.giveUp();
        goOn();
    }
}

void ProjectMenu::stay() {
    m_next = {};
}

void ProjectMenu::startNew() {
    leaveThen([this] {
        m_session.startNew();
        opened();
    });
}

void ProjectMenu::chooseAndOpen() {
    const QString path = m_files.open(m_window, {tr("Open project"), {}, tr("Halbench project (*.toml)")});
    if (!path.isEmpty()) {
        open(path);
    }
}

void ProjectMenu::open(const QString& path) {
    collecting();
    const std::string file = path.toStdString();
    if (m_session.has(file) && m_session.isChanged()) {
        recovered(tr("%1 opened with unsaved changes.").arg(QFileInfo(path).fileName()), {});
        return;
    }
    leaveThen([this, path] { openFile(path); });
}

void ProjectMenu::openFile(const QString& path) {
    const std::string file = path.toStdString();
    if (const Result<void> read = m_session.open(file); !read) {
        if (read.error().code == ErrorCode::Refused) {
            locked(path);
        } else {
            say(read.error());
        }
        return;
    }
    remember(path);
    if (const auto aside = m_session.setAsideDamaged(file)) {
        recovered(tr("The project's autosave could not be read; it was moved to %1.")
                      .arg(QString::fromStdString(*aside)),
                  tr("The saved file is unchanged."));
    }
    if (const std::optional<Project> left = m_session.recoverable(file);
        left && !isSameWork(*left, m_session.project())) {
        m_session.recover(file, *left);
        recovered(tr("Unsaved work of %1 was recovered. Save it to keep it.").arg(QFileInfo(path).fileName()),
                  {});
    }
    opened();
}

void ProjectMenu::openCopy(const QString& path) {
    leaveThen([this, path] {
        if (const Result<void> read = m_session.openCopy(path.toStdString()); !read) {
            say(read.error());
            return;
        }
        recovered(tr("This is a copy of %1, without a name.").arg(QFileInfo(path).fileName()),
                  tr("Save it with a new name to keep it."));
        opened();
    });
}

void ProjectMenu::openUnnamed(const std::string& place) {
    if (const Result<void> read = m_session.openUnnamed(place); !read) {
        say(read.error());
        return;
    }
    opened();
}

void ProjectMenu::say(const Error& error) {
    refused(widgets::inWords(error.message), widgets::inWords(error.hint));
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
    collecting();
    m_session.save(path.toStdString(), [self = QPointer(this), path](const Result<void>& written) {
        if (!self) {
            return;
        }
        if (written) {
            self->remember(path);
            self->saved();
            self->tryAgain(); // what waited for it
        } else if (written.error().code == ErrorCode::Refused) {
            self->refused(tr("%1 is open in another window.").arg(QFileInfo(path).fileName()),
                          tr("Choose another name, or close the other window."));
        } else {
            self->say(written.error());
        }
    });
}

void ProjectMenu::remember(const QString& path) {
    recentProjectFiles().add(path);
}

void ProjectMenu::fillRecent() {
    m_recent->clear();
    for (const QString& path : recentProjects()) {
        m_recent->addAction(path, this, [this, path] { open(path); });
    }
    addUnnamed();
    if (m_recent->isEmpty()) {
        m_recent->addAction(tr("No recent projects"))->setEnabled(false);
    }
}

/// Work without a name that an earlier window left, or this one for another project.
void ProjectMenu::addUnnamed() {
    for (const std::string& place : m_session.waiting()) {
        const QFileInfo file(QString::fromStdString(autosavePath(place)));
        const QString when = widgets::localTimeText(file.lastModified());
        m_recent->addAction(tr("Unnamed project, %1").arg(when), this,
                            [this, place] { leaveThen([this, place] { openUnnamed(place); }); });
    }
}

} // namespace halbench::app
