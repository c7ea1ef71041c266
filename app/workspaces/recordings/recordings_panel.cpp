#include "app/workspaces/recordings/recordings_panel.h"

#include "app/workbench/drive_control.h"
#include "app/workbench/recording_control.h"
#include "app/workbench/shown_recording.h"
#include "app/workspaces/parts/compact_table.h"
#include "app/workspaces/parts/panel_parts.h"
#include "app/workspaces/recordings/import_view.h"
#include "app/workspaces/recordings/result_history_view.h"
#include "app/workspaces/recordings/run_overlay.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"
#include "widgets/language/whole_numbers.h"

#include <QAction>
#include <QDir>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTabWidget>
#include <QTableView>
#include <QVBoxLayout>

#include <utility>

namespace halbench::app {

namespace {

constexpr int SaveDelay_ms = 600; ///< after the last key
constexpr int FewestRows = 4;     ///< of the list that are seen, however small the window is
constexpr int LeastReason = 10;   ///< characters; the rest in its tooltip
constexpr double LongestRecording_s = 1e7;

} // namespace

RecordingsPanel::RecordingsPanel(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    QVBoxLayout* outer = makeScrollingColumn(this);
    auto* splitter = new QSplitter(Qt::Vertical, this);
    splitter->setChildrenCollapsible(false);
    auto* list = new QWidget(splitter);
    auto* column = new QVBoxLayout(list);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(widgets::PanelMargin_px);
    buildSearch(*column);
    m_message = new widgets::MessageBar(list);
    m_message->setObjectName(QStringLiteral("recordings_message"));
    buildTable();
    m_empty = makeNote(list);
    reserveLines(*m_empty, 2);
    column->addWidget(m_empty, 1);
    column->addWidget(m_table, 1);
    column->addWidget(m_message); // takes its room from the list, and moves no row of it
    buildActions(*column);
    buildTabs(splitter);
    constexpr int ListShare = 2; // a few rows to choose from, and a picture large enough to compare them
    constexpr int PictureShare = 3;
    splitter->setStretchFactor(0, ListShare);
    splitter->setStretchFactor(1, PictureShare);
    splitter->setSizes({ListShare * 1000, PictureShare * 1000});
    outer->addWidget(splitter);
    m_saving.setSingleShot(true);
    m_saving.setInterval(SaveDelay_ms);
    connect(&m_saving, &QTimer::timeout, this, &RecordingsPanel::saveWords);
    connect(&m_bench.recording(), &RecordingControl::finished, this, &RecordingsPanel::refresh);
    connect(&m_bench.recording(), &RecordingControl::folderChanged, this, &RecordingsPanel::refresh);
    connect(&m_bench.session(), &DeviceSession::stateChanged, this, &RecordingsPanel::onSession);
    connect(&m_bench.drive(), &DriveControl::changed, this, &RecordingsPanel::refreshActions);
    refresh();
    onSelection();
}

RecordingsPanel::~RecordingsPanel() {
    saveWords();
}

void RecordingsPanel::setFileChooser(FileChooser chooser) {
    m_import->setFileChooser(chooser);
    m_overlay->setFileChooser(std::move(chooser));
}

/// Of the panel, wherever in it the focus is.
QAction& RecordingsPanel::addKey(const char* key) {
    auto* action = new QAction(this);
    action->setShortcut(QKeySequence(QLatin1String(key)));
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    addAction(action);
    return *action;
}

void RecordingsPanel::buildSearch(QVBoxLayout& column) {
    m_search = new QLineEdit(this);
    m_search->setAccessibleName(tr("Search recordings"));
    m_search->setPlaceholderText(tr("Search name, device, date, signals, tags, notes"));
    m_search->setToolTip(tr("All words must occur (Ctrl+F)"));
    m_search->setClearButtonEnabled(true);
    connect(&addKey("Ctrl+F"), &QAction::triggered, m_search,
            [this] { m_search->setFocus(Qt::ShortcutFocusReason); });
    QPushButton* again = makeButton({tr("Refresh"), tr("Read the folder again (F5)"), {}}, this);
    connect(&addKey("F5"), &QAction::triggered, this, &RecordingsPanel::refresh);
    connect(again, &QPushButton::clicked, this, &RecordingsPanel::refresh);
    connect(m_search, &QLineEdit::textChanged, &m_filter, &RecordingsFilterModel::setWords);
    auto* row = new QHBoxLayout;
    row->addWidget(m_search, 1);
    row->addWidget(again);
    column.addLayout(row);
}

void RecordingsPanel::buildTable() {
    m_filter.setSourceModel(&m_model);
    m_filter.setSortRole(RecordingsTableModel::SortRole);
    m_table = new QTableView(this);
    m_table->setAccessibleName(tr("Recordings"));
    m_table->setToolTip(tr("Enter opens the selected recording; several are overlaid"));
    m_table->setModel(&m_filter);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);
    m_table->setWordWrap(false);
    m_table->setItemDelegate(new widgets::WholeNumbers(m_table));
    setCompact(*m_table);
    m_table->setMinimumHeight(m_table->horizontalHeader()->sizeHint().height() +
                              FewestRows * m_table->verticalHeader()->defaultSectionSize());
    m_table->setSortingEnabled(true);
    m_table->sortByColumn(RecordingsTableModel::Date, Qt::DescendingOrder);
    m_table->horizontalHeader()->setStretchLastSection(true);
    buildMenu();
    connect(m_table, &QTableView::activated, this, &RecordingsPanel::openWhole);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &RecordingsPanel::onSelection);
    connect(&m_filter, &QAbstractItemModel::modelReset, this, &RecordingsPanel::onSelection);
}

void RecordingsPanel::buildActions(QVBoxLayout& column) {
    m_open = makeButton({tr("Open"),
                         tr("Show the whole recording in the panels (Enter). Disconnects the device; not "
                            "available while it is armed, recording or busy"),
                         {}},
                        this);
    m_play = makeButton({tr("Replay"),
                         tr("Replay the recording as a live device (Ctrl+Return). Disconnects the device; "
                            "not available while it is armed, recording or busy"),
                         {}},
                        this);
    connect(&addKey("Ctrl+Return"), &QAction::triggered, this, &RecordingsPanel::play);
    m_from = makeNumberField({tr("Start at"), tr("Start time of the replay; Enter jumps there"),
                              QStringLiteral("s"), 2, 0.0, LongestRecording_s, 1.0},
                             this);
    m_whatIf = makeButton(
        {tr("What-if"), tr("Show in Tune how this move would run with the proposed gains"), {}}, this);
    m_recover = makeButton({tr("Recover"), tr("Recover an interrupted recording"), {}}, this);
    auto* label = new QLabel(tr("Start at"), this);
    label->setBuddy(m_from);
    auto* row = new QHBoxLayout;
    row->addWidget(m_open);
    row->addWidget(m_play);
    row->addWidget(label);
    row->addWidget(m_from);
    m_reason = new widgets::ElidedLabel(LeastReason, this);
    widgets::setRole(*m_reason, widgets::Role::Muted);
    row->addWidget(m_reason, 1);
    row->addWidget(m_whatIf);
    row->addWidget(m_recover);
    column.addLayout(row);
    connect(m_open, &QPushButton::clicked, this, &RecordingsPanel::openWhole);
    connect(m_play, &QPushButton::clicked, this, &RecordingsPanel::play);
    connect(m_from, &widgets::QuantityEdit::entered, this, &RecordingsPanel::play);
    connect(m_whatIf, &QPushButton::clicked, this, [this] {
        if (const RecordingEntry* entry = chosen()) {
            Q_EMIT whatIfRequested(entry->path);
        }
    });
    connect(m_recover, &QPushButton::clicked, this, [this] {
        if (const RecordingEntry* entry = chosen()) {
            recover(entry->path);
        }
    });
}

void RecordingsPanel::buildTabs(QWidget* parent) {
    m_tabs = new QTabWidget(parent);
    QTabWidget* tabs = m_tabs;
    tabs->setAccessibleName(tr("Overlay, results, tags and notes, import"));
    m_overlay = new RunOverlay(m_bench, tabs);
    m_results = new ResultHistoryView(tabs);
    tabs->addTab(m_overlay, tr("Overlay"));
    tabs->addTab(m_results, tr("Results over time"));
    tabs->addTab(buildWords(tabs), tr("Tags and notes"));
    m_import = new ImportView(m_bench, tabs);
    tabs->addTab(m_import, tr("Import"));
    connectImport();
}

QWidget* RecordingsPanel::buildWords(QWidget* parent) {
    auto* page = new QWidget(parent);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, widgets::PanelMargin_px, 0, 0);
    m_tags = new QLineEdit(page);
    m_tags->setAccessibleName(tr("Tags of the recording"));
    m_tags->setPlaceholderText(tr("Tags, with commas between them"));
    m_tags->setToolTip(tr("Search words, saved in the .meta.json file"));
    m_notes = new QPlainTextEdit(page);
    m_notes->setAccessibleName(tr("Notes on the recording"));
    m_notes->setPlaceholderText(tr("Notes on this recording"));
    m_notes->setToolTip(tr("Saved in the .meta.json file"));
    m_notes->setTabChangesFocus(true);
    column->addWidget(m_tags);
    column->addWidget(m_notes, 1);
    connect(m_tags, &QLineEdit::textEdited, this, [this] { m_saving.start(); });
    connect(m_notes, &QPlainTextEdit::textChanged, this, [this] { m_saving.start(); });
    return page;
}

void RecordingsPanel::refresh() {
    const QString folder = m_bench.recording().folder();
    m_reading.run(
        [folder] {
            return Folder{recordingsIn(folder), resultsIn(folder.toStdString())};
        },
        [this](Folder read) { take(std::move(read)); });
}

/// The folder may have been changed, or filled, while nobody looked.
void RecordingsPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
}

void RecordingsPanel::take(Folder folder) {
    QStringList selected;
    for (const int row : selectedRows()) {
        selected.append(m_model.entry(row).path);
    }
    m_model.setEntries(std::move(folder.entries));
    m_results->setRows(std::move(folder.results));
    QItemSelection selection;
    for (const QString& path : selected) {
        const QModelIndex index = m_filter.mapFromSource(m_model.index(m_model.rowOf(path), 0));
        if (index.isValid()) {
            selection.select(index, index);
        }
    }
    m_table->selectionModel()->select(selection,
                                      QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    m_table->resizeColumnsToContents();
    constexpr int Last = RecordingsTableModel::Results; // it has what the others leave
    m_table->setColumnWidth(Last, m_table->horizontalHeader()->sectionSizeHint(Last));
    m_empty->setVisible(m_model.rowCount() == 0);
    m_table->setVisible(m_model.rowCount() > 0);
    m_empty->setText(tr("No recordings in %1 yet. To make one: Record data (Ctrl+R).")
                         .arg(QDir::toNativeSeparators(m_bench.recording().folder())));
    recoverAll();
    refreshActions();
}

QList<int> RecordingsPanel::selectedRows() const {
    QList<int> rows;
    const QModelIndexList selected = m_table->selectionModel()->selectedRows();
    for (const QModelIndex& index : selected) {
        rows.append(m_filter.mapToSource(index).row());
    }
    return rows;
}

const RecordingEntry* RecordingsPanel::chosen() const {
    const QList<int> rows = selectedRows();
    return rows.size() == 1 ? &m_model.entry(rows.front()) : nullptr;
}

void RecordingsPanel::onSelection() {
    saveWords();
    QStringList paths;
    for (const int row : selectedRows()) {
        if (!m_model.entry(row).isInterrupted) {
            paths.append(m_model.entry(row).path);
        }
    }
    m_overlay->setFiles(paths);
    const RecordingEntry* entry = chosen();
    if (entry != nullptr && std::exchange(m_begun, entry->path) != entry->path) {
        m_from->setQuantity(0.0);
    }
    const QSignalBlocker quietTags(m_tags);
    const QSignalBlocker quietNotes(m_notes);
    m_words = entry != nullptr && entry->hasSidecar ? entry->path : QString();
    m_tags->setText(entry != nullptr ? entry->tags.join(QLatin1String(", ")) : QString());
    m_notes->setPlainText(entry != nullptr ? entry->notes : QString());
    refreshActions();
}

/// Nothing that moves, or is recorded, loses its device to a recording.
bool RecordingsPanel::isFree() const {
    return !m_bench.recording().isRecording() && m_bench.session().procedure().isEmpty() &&
           !m_bench.drive().isArmed();
}

/// Why Open and Replay are greyed; empty where they are not.
QString RecordingsPanel::reason(const RecordingEntry* entry) const {
    if (m_model.rowCount() == 0) {
        return {}; // the list says it
    }
    if (entry == nullptr) {
        return selectedRows().isEmpty() ? tr("Select a recording to open or replay it.")
                                        : tr("Several are overlaid below; select one to open it.");
    }
    if (entry->isInterrupted) {
        return tr("Interrupted: recover it first.");
    }
    return busyReason();
}

/// Why no recording can be opened now; empty: one can.
QString RecordingsPanel::busyReason() const {
    if (m_bench.recording().isRecording()) {
        return tr("End the current recording first.");
    }
    return isFree()                    ? QString()
           : m_bench.drive().isArmed() ? tr("Disarm the device first.")
                                       : tr("Wait for the end of the procedure.");
}

void RecordingsPanel::refreshActions() {
    const RecordingEntry* entry = chosen();
    const bool isWhole = entry != nullptr && !entry->isInterrupted;
    m_open->setEnabled(isWhole && isFree());
    m_play->setEnabled(isWhole && isFree());
    m_whatIf->setEnabled(isWhole); // nothing moves and no device is left
    m_from->setEnabled(isWhole);
    m_from->setMaximum(isWhole ? entry->duration_s.value_or(LongestRecording_s) : LongestRecording_s);
    m_recover->setVisible(entry != nullptr && entry->isInterrupted);
    m_reason->setWords(reason(entry));
    m_tags->setEnabled(!m_words.isEmpty());
    m_notes->setEnabled(!m_words.isEmpty());
}

void RecordingsPanel::openWhole() {
    const RecordingEntry* entry = chosen();
    if (entry != nullptr && m_open->isEnabled()) {
        openEntry(entry->path);
    }
}

void RecordingsPanel::play() {
    const RecordingEntry* entry = chosen();
    if (entry == nullptr || !m_play->isEnabled()) {
        return;
    }
    QString uri = QStringLiteral("replay:") + entry->path;
    if (const double begin_s = m_from->value(); begin_s > 0.0) {
        uri += QStringLiteral("?at=") + QString::number(begin_s, 'g', 12);
    }
    m_message->clear();
    m_bench.session().connectDevice(uri, m_bench.pace());
    Q_EMIT played();
}

/// What a recording shows is not the continuation of what its device showed.
void RecordingsPanel::onSession() {
    const DeviceSession& session = m_bench.session();
    if (session.state() == SessionState::Connected && session.info().transport == "replay") {
        m_bench.clearHistory();
    }
    refreshActions();
}

/// What was typed belongs to the recording that it was typed for.
void RecordingsPanel::saveWords() {
    if (!m_saving.isActive() && sender() != &m_saving) {
        return;
    }
    m_saving.stop();
    if (m_words.isEmpty()) {
        return;
    }
    const QString path = m_words;
    const QStringList tags = tagsOf(m_tags->text());
    const QString notes = m_notes->toPlainText();
    m_model.setWords(path, tags, notes); // the fields stay as they are while somebody types
    m_files.run([path, tags, notes] { return writeRecordingNotes(path, tags, notes); },
                [this](const Result<void>& done) {
                    if (!done) {
                        m_message->showMessage({widgets::Severity::Error,
                                                widgets::inWords(done.error().message),
                                                widgets::inWords(done.error().hint),
                                                {}});
                        refresh();
                    }
                });
}

} // namespace halbench::app
