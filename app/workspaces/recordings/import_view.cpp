#include "app/workspaces/recordings/import_view.h"

#include "app/documents/result_header.h"
#include "app/workbench/recording_control.h"
#include "app/workspaces/parts/panel_parts.h"
#include "app/workspaces/recordings/import_form.h"
#include "app/workspaces/recordings/import_table.h"
#include "app/workspaces/recordings/import_text.h"
#include "devices/formats/recording_file.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/floating_rows.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/progress_row.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace halbench::app {

namespace {

constexpr int FileCharacters = 24;
constexpr int NameCharacters = 20;
constexpr int FewestRows = 6; ///< of the table, that are seen: what its columns become, and numbers
constexpr int Tick_ms = 100;

/// A name that no recording of the folder has.
QString freeName(const QString& folder, const QString& wanted) {
    QString name = wanted;
    for (int number = 2; QFileInfo::exists(QDir(folder).filePath(name + QStringLiteral(".csv"))); ++number) {
        name = QStringLiteral("%1-%2").arg(wanted).arg(number);
    }
    return name;
}

} // namespace

ImportView::ImportView(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    QVBoxLayout* column = makeScrollingColumn(this);
    buildFile(*column);
    m_message = new widgets::MessageBar(this);
    m_message->setObjectName(QStringLiteral("import_message"));
    (new widgets::FloatingRows(*this, Qt::TopEdge, this))->addRow(*m_message);
    m_form = new ImportForm(this);
    column->addWidget(m_form);
    connect(m_form, &ImportForm::changed, this, &ImportView::look);
    m_questions = new QWidget(this);
    auto* questions = new QVBoxLayout(m_questions);
    questions->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_questions);
    buildTable();
    buildEnd(*column); // above the table, where it is seen in a low window too
    column->addWidget(m_table, 1);
    connect(&m_bench.recording(), &RecordingControl::folderChanged, this, &ImportView::refreshEnd);
    connect(&m_tick, &QTimer::timeout, this, &ImportView::showProgress);
    refreshEnd();
}

void ImportView::buildTable() {
    m_table = new ImportTable(this);
    m_table->setMinimumHeight((FewestRows + 2) * m_table->verticalHeader()->defaultSectionSize());
    connect(m_table, &ImportTable::changed, this, &ImportView::look);
    connect(m_form, &ImportForm::reshaped, m_table, &ImportTable::forget);
}

/// Nobody waits for the rows of a table that nobody will see.
ImportView::~ImportView() {
    if (m_progress != nullptr) {
        m_progress->isCancelled = true;
    }
}

void ImportView::buildFile(QVBoxLayout& column) {
    m_choose =
        makeButton({tr("Choose file…"), tr("Choose a data file of another program (Ctrl+I in the window)"),
                    QStringLiteral("open")},
                   this);
    connect(m_choose, &QPushButton::clicked, this, &ImportView::choose);
    m_file = new widgets::ElidedLabel(FileCharacters, this);
    m_file->setAccessibleName(tr("File to import"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_choose);
    row->addWidget(m_file, 1);
    column.addLayout(row);
}

void ImportView::buildEnd(QVBoxLayout& column) {
    m_name = new QLineEdit(this);
    m_name->setAccessibleName(tr("Name of the recording"));
    m_name->setToolTip(tr("Name of the new recording in the recordings folder"));
    m_name->setMinimumWidth(NameCharacters * fontMetrics().averageCharWidth());
    auto* label = new QLabel(tr("Name"), this);
    label->setBuddy(m_name);
    m_import =
        makeButton({tr("Import"), tr("Read all rows, save them as a recording and show it"), {}}, this);
    m_reason = makeNote(this);
    m_reason->setAccessibleName(tr("Missing for the import"));
    m_running = new widgets::ProgressRow(this);
    m_running->hide();
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(m_name);
    row->addWidget(m_import);
    row->addWidget(m_reason, 1);
    column.addLayout(row);
    column.addWidget(m_running);
    connect(m_name, &QLineEdit::textChanged, this, &ImportView::refreshEnd);
    connect(m_import, &QPushButton::clicked, this, &ImportView::run);
    connect(m_running, &widgets::ProgressRow::cancelRequested, this, [this] {
        if (m_progress != nullptr) {
            m_progress->isCancelled = true;
            m_running->setCancelling();
        }
    });
}

bool ImportView::choose() {
    const QString path =
        m_chooser.open
            ? m_chooser.open(this,
                             {tr("Choose file"), {}, tr("Table (*.csv *.txt *.tsv *.dat);;All files (*)")})
            : QString();
    if (!path.isEmpty()) {
        begin(path);
    }
    return !path.isEmpty();
}

void ImportView::begin(const QString& path) {
    if (m_progress != nullptr) {
        return; // the one before is not yet done
    }
    m_path = path;
    m_text.reset();
    m_look.reset();
    m_isLooking = true;
    m_message->clear();
    m_file->setWords(QDir::toNativeSeparators(path));
    m_form->reset();
    m_name->setText(freeName(m_bench.recording().folder(), QFileInfo(path).completeBaseName()));
    m_table->forget();
    showQuestions();
    refreshEnd();
    m_work.run([file = path.toStdString()] { return devices::readTableText(file); },
               [this](Result<std::string> text) {
                   if (text) {
                       m_text = std::make_shared<const std::string>(*std::move(text));
                       look();
                   } else {
                       take(failure(text.error()));
                   }
               });
}

void ImportView::look() {
    if (m_text == nullptr) {
        return;
    }
    m_isLooking = true;
    refreshEnd();
    devices::CsvImportRequest request = m_form->request();
    m_table->addTo(request);
    m_work.run([text = m_text, origin = QFileInfo(m_path).fileName().toStdString(),
                request] { return lookAtTable(*text, origin, request); },
               [this](Result<TableLook> look) { take(std::move(look)); });
}

void ImportView::take(Result<TableLook> look) {
    m_isLooking = false;
    m_message->clear();
    if (look) {
        m_look = *std::move(look);
        m_form->showPlan(m_look->plan);
        m_table->showLook(*m_look);
    } else {
        m_look.reset();
        m_table->showUnread();
        say(look.error());
    }
    showQuestions();
    refreshEnd();
}

void ImportView::say(const Error& error) {
    m_message->showMessage(
        {widgets::Severity::Error, widgets::inWords(error.message), importRemedy(error), {}});
}

/// Each with its answers beside it.
void ImportView::showQuestions() {
    const auto old = m_questions->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly);
    for (QWidget* child : old) {
        child->hide();
        child->deleteLater(); // the request may come from one of them
    }
    if (m_look) {
        for (const devices::CsvQuestion& question : m_look->plan.questions) {
            auto* row = new QuestionRow(question, m_questions);
            m_questions->layout()->addWidget(row);
            row->show(); // now, not when the layout comes to it
            connect(row, &QuestionRow::answered, this, [this](const devices::CsvQuestion::Answer& answer) {
                m_form->take(answer);
                m_table->take(answer);
                look();
            });
        }
    }
    m_questions->setVisible(m_look && !m_look->plan.questions.empty());
}

QString ImportView::target() const {
    return QDir(m_bench.recording().folder()).filePath(m_name->text().trimmed() + QStringLiteral(".csv"));
}

/// Why Import cannot be pressed; empty: it can.
QString ImportView::obstacle() const {
    const QString name = m_name->text().trimmed();
    if (m_path.isEmpty()) {
        return tr("Choose a file first. Uncertain settings are asked for here.");
    }
    if (m_isLooking) {
        return tr("Reading the file.");
    }
    if (!m_look) {
        return tr("The file cannot be read with these settings; see the cause above.");
    }
    if (const QString missing = m_form->obstacle(); !missing.isEmpty()) {
        return missing;
    }
    if (const auto& questions = m_look->plan.questions; !questions.empty()) {
        return tr("Answer above: %1.").arg(questionWords(questions.front()));
    }
    if (name.isEmpty() || name.contains(QLatin1Char('/')) || name.contains(QLatin1Char('\\'))) {
        return tr("Enter a name without a folder for the recording.");
    }
    return QFileInfo::exists(target()) ? tr("A recording of this name exists already.") : QString();
}

void ImportView::refreshEnd() {
    const QString reason = obstacle();
    m_import->setEnabled(reason.isEmpty() && m_progress == nullptr);
    m_reason->setText(reason);
    showRole(*m_reason, m_look && !reason.isEmpty() ? widgets::Role::Warn : widgets::Role::Muted);
    m_running->setVisible(m_progress != nullptr);
    m_choose->setEnabled(m_progress == nullptr);
    m_form->setEnabled(m_text != nullptr && m_progress == nullptr);
    m_questions->setEnabled(m_progress == nullptr);
    m_table->setEnabled(m_progress == nullptr);
}

void ImportView::run() {
    m_progress = std::make_shared<ImportProgress>();
    m_message->clear();
    refreshEnd();
    m_running->setText(tr("Importing"));
    m_running->setProgress(std::nullopt);
    m_running->findChild<QPushButton*>()->setFocus();
    m_tick.start(Tick_ms);
    m_work.run([text = m_text, origin = QFileInfo(m_path).fileName().toStdString(), plan = m_look->plan,
                path = target().toStdString(), header = m_bench.beginResult("halbench.import/1"),
                progress = m_progress] { return importTable(*text, origin, plan, path, header, *progress); },
               [this](const Result<ImportedTable>& done) { finish(done); });
}

void ImportView::showProgress() {
    if (m_progress != nullptr && !m_progress->isCancelled) {
        m_running->setText(tr("Importing: %1 rows").arg(widgets::countText(m_progress->rows.load())));
    }
}

/// The table is not needed any more: it may be large.
void ImportView::finish(const Result<ImportedTable>& done) {
    m_tick.stop();
    m_progress.reset();
    if (!done) {
        say(done.error());
        refreshEnd();
        return;
    }
    QStringList doubts;
    for (const Finding& finding : done->findings) {
        doubts << widgets::inWords(finding.message);
    }
    m_path.clear();
    m_text.reset();
    m_look.reset();
    m_file->setWords(QString());
    m_form->reset();
    m_table->forget();
    showQuestions();
    refreshEnd();
    m_message->showMessage({doubts.isEmpty() ? widgets::Severity::Success : widgets::Severity::Warning,
                            tr("Imported: %1 rows in %2")
                                .arg(widgets::countText(done->rows),
                                     QDir::toNativeSeparators(QString::fromStdString(done->path))),
                            doubts.join(QStringLiteral("; ")),
                            {}});
    Q_EMIT imported(QString::fromStdString(done->path));
}

} // namespace halbench::app
