#pragma once

#include "app/documents/result_history.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"
#include "app/workbench/latest_task.h"
#include "app/workbench/workbench.h"
#include "app/workspaces/recordings/recordings_table_model.h"

#include <QTimer>
#include <QWidget>

class QAction;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QTabWidget;
class QTableView;
class QVBoxLayout;

namespace halbench::widgets {
class ElidedLabel;
class MessageBar;
class QuantityEdit;
} // namespace halbench::widgets

namespace halbench::app {

class ImportView;
class ResultHistoryView;
class RunOverlay;

/// The recordings of the folder: searched, tagged, replayed, laid over each other
/// (resources/help/monitor.md, "Recordings").
class RecordingsPanel : public QWidget {
    Q_OBJECT

public:
    explicit RecordingsPanel(Workbench& bench, QWidget* parent = nullptr);
    ~RecordingsPanel() override;

    void setFileChooser(FileChooser chooser);
    /// Asks for a table of another program and shows how it would be read.
    void importTable();
    /// Shows a recording; a table of another program first as it would be read.
    void open(const QString& path) { openEntry(path); }

Q_SIGNALS:
    void played();                             ///< or opened: whoever shows signals comes to the front
    void whatIfRequested(const QString& path); ///< what the gains proposed in Tune would have made of it

protected:
    void showEvent(QShowEvent* event) override;

private:
    struct Folder {
        std::vector<RecordingEntry> entries;
        std::vector<ResultRow> results;
    };

    QAction& addKey(const char* key);
    void buildSearch(QVBoxLayout& column);
    void buildTable();
    void buildMenu();
    void buildActions(QVBoxLayout& column);
    void buildTabs(QWidget* parent);
    QWidget* buildWords(QWidget* parent);
    void refresh();
    void take(Folder folder);
    void recoverAll();
    void recoverElsewhere();
    void recover(const QString& path);
    void onSelection();
    QString reason(const RecordingEntry* entry) const;
    QString busyReason() const;
    void refreshActions();
    void openWhole();
    void openEntry(const QString& path);
    void connectImport();
    void onImported(const QString& path);
    void play();
    void onSession();
    void saveWords();
    bool isFree() const;
    QList<int> selectedRows() const;
    const RecordingEntry* chosen() const; ///< the only one that is selected

    Workbench& m_bench;
    RecordingsTableModel m_model;
    RecordingsFilterModel m_filter;
    QLineEdit* m_search = nullptr;
    QTableView* m_table = nullptr;
    QPushButton* m_open = nullptr;
    QPushButton* m_play = nullptr;
    QPushButton* m_recover = nullptr;
    QPushButton* m_whatIf = nullptr;
    widgets::QuantityEdit* m_from = nullptr;
    QLineEdit* m_tags = nullptr;
    QPlainTextEdit* m_notes = nullptr;
    widgets::MessageBar* m_message = nullptr;
    QLabel* m_empty = nullptr;
    widgets::ElidedLabel* m_reason = nullptr;
    RunOverlay* m_overlay = nullptr;
    ResultHistoryView* m_results = nullptr;
    ImportView* m_import = nullptr;
    QTabWidget* m_tabs = nullptr;
    QString m_begun; ///< path of the recording that `m_from` is of
    QString m_words; ///< path of the recording whose words are shown
    bool m_hasRecovered = false;
    QTimer m_saving;
    FileQueue m_files;
    LatestTask m_reading;
};

} // namespace halbench::app
