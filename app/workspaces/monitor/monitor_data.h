#pragma once

#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"
#include "app/workbench/workbench.h"
#include "devices/recording/recording_meta.h"

#include <QObject>

class QAction;

namespace halbench::widgets {
class LivePlotStack;
}

namespace halbench::app {

/// The samples of the Monitor's plots as data: of what is in view or, with cursors, of the stretch between
/// them (resources/help/monitor.md, "Data of the plots"). To a CSV, MDF4 or MAT file with what a recording
/// says beside it, or onto the clipboard for a spreadsheet.
class MonitorData : public QObject {
    Q_OBJECT

public:
    /// `panel` gets the actions.
    MonitorData(Workbench& bench, widgets::LivePlotStack& stack, QWidget& panel);

    void setFileChooser(FileChooser chooser) { m_chooser = std::move(chooser); }
    QAction& copyAction() { return *m_copy; }
    QAction& saveAction() { return *m_save; }

Q_SIGNALS:
    void failed(const QString& text, const QString& remedy);
    void done(const QString& text); ///< what was written, in words

private:
    Result<Recording> rows(std::size_t mostValues) const;
    QString leftOut() const;
    devices::RecordingMeta meta(const Recording& rows) const;
    std::string timeOfZero() const;
    void copy();
    void save();
    void refuse(const Error& error);

    Workbench& m_bench;
    widgets::LivePlotStack& m_stack;
    QWidget& m_panel;
    FileChooser m_chooser;
    FileQueue m_files;
    QAction* m_copy = nullptr;
    QAction* m_save = nullptr;
};

} // namespace halbench::app
