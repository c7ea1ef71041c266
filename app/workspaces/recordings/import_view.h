#pragma once

#include "app/workbench/file_chooser.h"
#include "app/workbench/latest_task.h"
#include "app/workbench/workbench.h"
#include "app/workspaces/recordings/table_import.h"

#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>
#include <string>

class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace halbench::widgets {
class ElidedLabel;
class MessageBar;
class ProgressRow;
} // namespace halbench::widgets

namespace halbench::app {

class ImportForm;
class ImportTable;

/// A table of another program becomes a recording: shown as it would be read, and what is not certain is
/// asked (resources/help/monitor.md, "Import"). Reads and writes on a thread of its own.
class ImportView : public QWidget {
    Q_OBJECT

public:
    explicit ImportView(Workbench& bench, QWidget* parent = nullptr);
    ~ImportView() override;

    void setFileChooser(FileChooser chooser) { m_chooser = std::move(chooser); }
    /// Asks for a file and looks at it; false: none was chosen.
    bool choose();
    /// Looks at a file.
    void begin(const QString& path);

Q_SIGNALS:
    void imported(const QString& path); ///< of the recording

private:
    using Text = std::shared_ptr<const std::string>;
    void buildFile(QVBoxLayout& column);
    void buildTable();
    void buildEnd(QVBoxLayout& column);
    void look();
    void take(Result<TableLook> look);
    void showQuestions();
    void run();
    void finish(const Result<ImportedTable>& done);
    void showProgress();
    void refreshEnd();
    QString obstacle() const;
    QString target() const;
    void say(const Error& error);

    Workbench& m_bench;
    FileChooser m_chooser;
    QString m_path; ///< of the table; empty: none was chosen
    Text m_text;
    std::optional<TableLook> m_look;            ///< none: it cannot be read as it is
    std::shared_ptr<ImportProgress> m_progress; ///< while it is imported
    bool m_isLooking = false;
    QPushButton* m_choose = nullptr;
    widgets::ElidedLabel* m_file = nullptr;
    ImportForm* m_form = nullptr;
    QWidget* m_questions = nullptr;
    ImportTable* m_table = nullptr;
    QLineEdit* m_name = nullptr;
    QPushButton* m_import = nullptr;
    QLabel* m_reason = nullptr;
    widgets::ProgressRow* m_running = nullptr;
    widgets::MessageBar* m_message = nullptr;
    QTimer m_tick;
    LatestTask m_work;
};

} // namespace halbench::app
