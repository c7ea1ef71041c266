// Files in the panel of the recordings: tables of other programs, and what an interrupted program left.
#include "app/workbench/recording_control.h"
#include "app/workbench/recording_folders.h"
#include "app/workbench/shown_recording.h"
#include "app/workspaces/recordings/import_view.h"
#include "app/workspaces/recordings/recordings_panel.h"
#include "app/workspaces/recordings/table_import.h"
#include "devices/formats/recording_file.h"
#include "widgets/controls/copy_menu.h"
#include "widgets/controls/message_bar.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"

#include <QAction>
#include <QClipboard>
#include <QDesktopServices>
#include <QDir>
#include <QGuiApplication>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>
#include <QUrl>

#include <utility>

namespace halbench::app {

void RecordingsPanel::connectImport() {
    connect(m_import, &ImportView::imported, this, &RecordingsPanel::onImported);
}

/// What the buttons below the list do, and the file itself.
void RecordingsPanel::buildMenu() {
    const auto add = [this](const QString& words, const auto& act) {
        auto* action = new QAction(words, m_table);
        connect(action, &QAction::triggered, this, act);
        m_table->addAction(action);
    };
    add(tr("Open"), [this] { openWhole(); });
    add(tr("Replay"), [this] { play(); });
    add(tr("What-if"), [this] { m_whatIf->click(); });
    add(tr("Copy path"), [this] {
        if (const RecordingEntry* entry = chosen()) {
            QGuiApplication::clipboard()->setText(QDir::toNativeSeparators(entry->path));
        }
    });
    add(tr("Open folder"),
        [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(m_bench.recording().folder())); });
    widgets::addCopyMenu(*m_table);
}

void RecordingsPanel::importTable() {
    m_tabs->setCurrentWidget(m_import);
    m_import->choose();
}

/// A table that our reader does not take is another program's: it is shown first as it would be read.
void RecordingsPanel::openEntry(const QString& path) {
    m_message->clear();
    const auto show = [this, path] {
        if (isFree()) {
            m_bench.shownRecording().open(path);
            Q_EMIT played();
        } else {
            m_message->showMessage(
                {widgets::Severity::Warning, tr("The recording cannot be opened now."), busyReason(), {}});
        }
    };
    const int row = m_model.rowOf(path);
    if (devices::isMdf4Recording(path.toStdString()) || (row >= 0 && m_model.entry(row).hasSidecar)) {
        show();
        return;
    }
    m_files.run([file = path.toStdString()] { return isOwnRecording(file); },
                [this, path, show](const Result<bool>& isOwn) {
                    if (!isOwn || *isOwn) {
                        show(); // which says what is wrong with it
                        return;
                    }
                    m_tabs->setCurrentWidget(m_import);
                    m_import->begin(path);
                    m_message->showMessage(
                        {widgets::Severity::Information,
                         tr("This table is from another program. Check below how it is read."),
                         tr("Import creates a recording; the table is not changed."),
                         {}});
                });
}

/// It opens as any recording does, unless something moves, is recorded or works.
void RecordingsPanel::onImported(const QString& path) {
    refresh();
    m_message->clear();
    if (isFree()) {
        m_bench.shownRecording().open(path);
        Q_EMIT played();
    }
}

/// Once after the start: what a killed program or a power loss left.
void RecordingsPanel::recoverAll() {
    if (std::exchange(m_hasRecovered, true)) {
        return;
    }
    for (int row = 0; row < m_model.rowCount(); ++row) {
        if (m_model.entry(row).isInterrupted) {
            recover(m_model.entry(row).path);
        }
    }
    recoverElsewhere();
}

/// The recordings of before may lie where they go as long as nobody chooses, of an earlier start.
void RecordingsPanel::recoverElsewhere() {
    const QString folder = defaultRecordingFolder();
    if (QDir(folder).absolutePath() == QDir(m_bench.recording().folder()).absolutePath()) {
        return;
    }
    m_files.run([folder] { return Result<QStringList>(interruptedIn(folder)); },
                [this](const Result<QStringList>& found) {
                    for (const QString& path : *found) {
                        recover(path);
                    }
                });
}

void RecordingsPanel::recover(const QString& path) {
    m_files.run(
        [path] { return recoverRecording(path); },
        [this](const Result<RecoveredRecording>& done) {
            if (!done) {
                m_message->showMessage({widgets::Severity::Error,
                                        widgets::inWords(done.error().message),
                                        widgets::inWords(done.error().hint),
                                        {}});
                return;
            }
            const QString text =
                tr("An interrupted recording was recovered: %1 s in %2")
                    .arg(widgets::fixedText(done->duration_s, 2), QDir::toNativeSeparators(done->path));
            QString lost = done->lostOctets == 0
                               ? tr("All written data were recovered.")
                               : tr("Lost: %1 bytes, damaged or at the end.")
                                     .arg(widgets::countText(static_cast<qulonglong>(done->lostOctets)));
            if (!done->keptOriginal.isEmpty()) {
                lost +=
                    QLatin1Char(' ') +
                    tr("The damaged file was saved as %1.").arg(QDir::toNativeSeparators(done->keptOriginal));
            }
            m_message->showMessage({widgets::Severity::Information, text, lost, {}});
            m_bench.session().message(MessageLevel::Info, tr("recording"), text + QLatin1String(". ") + lost);
            refresh();
        });
}

} // namespace halbench::app
