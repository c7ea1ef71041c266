#pragma once

#include "app/workspaces/file_chooser.h"
#include "app/workspaces/file_queue.h"
#include "app/workspaces/workbench.h"
#include "widgets/figure.h"

#include <QObject>

class QAction;

namespace halbench::widgets {
class LivePlotStack;
}

namespace halbench::app {

/// The plots as they are in view as a figure for print: axes with quantity and unit, at most two points per
/// column of it and curve, so that its size does not grow with the samples. Gaps and missing values
/// interrupt the lines.
widgets::Figure monitorFigure(const widgets::LivePlotStack& stack, const control::SampleHistory& history);

/// Copies the Monitor's plots as a picture and saves them as SVG, PDF or PNG (resources/help/monitor.md,
/// "Plots").
class MonitorPicture : public QObject {
    Q_OBJECT

public:
    /// `panel` gets the actions.
    MonitorPicture(Workbench& bench, widgets::LivePlotStack& stack, QWidget& panel);

    void setFileChooser(FileChooser chooser) { m_chooser = std::move(chooser); }
    QAction& copyAction() { return *m_copy; }
    QAction& saveAction() { return *m_save; }

Q_SIGNALS:
    void failed(const QString& text, const QString& remedy);
    void leftOut(const QString& text); ///< plots on another time axis, in words

private:
    widgets::Figure figure() const;
    void sayLeftOut();
    void copy();
    void save();

    Workbench& m_bench;
    widgets::LivePlotStack& m_stack;
    QWidget& m_panel;
    FileChooser m_chooser;
    FileQueue m_files;
    QAction* m_copy = nullptr;
    QAction* m_save = nullptr;
};

} // namespace halbench::app
