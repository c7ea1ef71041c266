#pragma once

#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"

#include <QObject>

class QAction;
class QWidget;

namespace halbench::widgets {
class LivePlotStack;
}

namespace halbench::app {

/// Lays a recording under the Monitor's curves as their reference (resources/help/monitor.md, "Reference").
class MonitorReference : public QObject {
    Q_OBJECT

public:
    /// `panel` gets the action.
    MonitorReference(widgets::LivePlotStack& stack, QWidget& panel);

    void setFileChooser(FileChooser chooser) { m_chooser = std::move(chooser); }
    /// Keep, lay a recording under, remove.
    QAction& menuAction() { return *m_menuAction; }

Q_SIGNALS:
    void failed(const QString& text, const QString& remedy);
    void doubted(const QString& text); ///< it is shown, but is not as it was recorded

private:
    void open();

    widgets::LivePlotStack& m_stack;
    QWidget& m_panel;
    FileChooser m_chooser;
    FileQueue m_files;
    QAction* m_open = nullptr;
    QAction* m_menuAction = nullptr;
};

} // namespace halbench::app
