#pragma once

#include "app/documents/configuration_comparison.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"
#include "app/workbench/workbench.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace halbench::widgets {
class EmptyState;
class MessageBar;
} // namespace halbench::widgets

namespace halbench::app {

class ConfigurationTable;

/// Saves all settings of the device into a file and restores chosen rows of one; what the device had before
/// is kept first (resources/help/command-line.md, "Configuration files").
class ConfigurationPanel : public QWidget {
    Q_OBJECT

public:
    /// `backups`: folder of the copies that are kept before a restore.
    explicit ConfigurationPanel(Workbench& bench, QWidget* parent = nullptr,
                                const std::string& backups = backupFolder());

    void setFileChooser(FileChooser chooser) { m_chooser = std::move(chooser); }

private:
    QWidget* buildEmpty();
    QWidget* buildRows();
    void refresh();
    void save();
    void open();
    void opened(const QString& path, const Result<Configuration>& file);
    void compare(bool keepTicks);
    void backUpAndRestore();
    void restore(const std::vector<ParameterValue>& values, const QString& backup, std::uint64_t stops);
    void restored(const Result<std::vector<RowOutcome>>& outcomes, const QString& backup);
    void tell(const Error& error);

    Workbench& m_bench;
    const std::string m_backups;
    FileChooser m_chooser;
    FileQueue m_files;
    std::optional<Configuration> m_file;
    bool m_isRestoring = false;
    int m_connections = 0; ///< what was chosen for one is not written to another
    std::optional<ConfigurationComparison> m_comparison;
    QPushButton* m_save = nullptr;
    QPushButton* m_open = nullptr;
    widgets::MessageBar* m_messages = nullptr;
    QStackedWidget* m_stack = nullptr;
    QLabel* m_origin = nullptr;
    QLabel* m_findings = nullptr;
    ConfigurationTable* m_table = nullptr;
    QCheckBox* m_differencesOnly = nullptr;
    QCheckBox* m_withCalibration = nullptr;
    QPushButton* m_restore = nullptr;
};

} // namespace halbench::app
