#pragma once

#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"
#include "app/workbench/latest_task.h"
#include "app/workbench/workbench.h"
#include "app/workspaces/recordings/overlay_figure.h"

#include <QWidget>

#include <atomic>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class QComboBox;
class QLabel;
class QTableWidget;

namespace halbench::widgets {
class FigureView;
class MessageBar;
class QuantityEdit;
} // namespace halbench::widgets

namespace halbench::app {

/// Recordings laid over each other, aligned at a moment, with one cursor for all of them
/// (resources/help/monitor.md, "Recordings"). They are read, and thinned to what a screen shows, on threads
/// of their own. Thread: GUI.
class RunOverlay : public QWidget {
    Q_OBJECT

public:
    explicit RunOverlay(Workbench& bench, QWidget* parent = nullptr);
    ~RunOverlay() override;

    void setFileChooser(FileChooser chooser) { m_chooser = std::move(chooser); }
    /// Reads and shows these files, the first sixteen of them; none: says what it is for.
    void setFiles(const QStringList& paths);

private:
    using Runs = std::shared_ptr<const std::vector<ComparedRun>>;

    void buildChoices();
    void buildValues();
    void take(ReadRuns read, int left);
    bool addWarnings(QStringList& lines) const;
    void refreshChoices();
    void draw();
    void showFigure(widgets::Figure figure);
    void moveCursor();
    void refreshCursor();
    std::string signal() const;
    RunAlignment alignment() const;
    DisplayQuantity shown() const;
    OverlayView view() const;

    Workbench& m_bench;
    QStringList m_paths;
    Runs m_runs = std::make_shared<const std::vector<ComparedRun>>();
    std::shared_ptr<std::atomic<bool>> m_isStale; ///< ends the reading that nobody waits for any more
    QComboBox* m_signal = nullptr;
    QComboBox* m_align = nullptr;
    QComboBox* m_span = nullptr;
    widgets::QuantityEdit* m_cursor = nullptr;
    widgets::MessageBar* m_message = nullptr;
    widgets::FigureView* m_view = nullptr;
    QLabel* m_hint = nullptr;
    QTableWidget* m_values = nullptr;
    FileChooser m_chooser;
    FileQueue m_files;
    LatestTask m_drawing;
    LatestTask m_reading;
};

} // namespace halbench::app
