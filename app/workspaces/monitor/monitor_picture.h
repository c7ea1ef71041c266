#pragma once

#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"
#include "app/workbench/workbench.h"
#include "widgets/figure/picture_sheets.h"

#include <QObject>

class QAction;

namespace halbench::widgets {
class LivePlotStack;
}

namespace halbench::app {

/// The plots as they are in view for print: axes with quantity and unit, at most two points per column and
/// curve, so that its size does not grow with the samples. Gaps and missing values interrupt the lines.
/// Plots of a column that follow each other on one time axis are a figure, columns stand beside each other,
/// with the shares of the room that they have on the screen; limit bands, markers, cursors and trigger are
/// drawn as there.
std::vector<widgets::PictureSheet> monitorSheets(const widgets::LivePlotStack& stack,
                                                 const control::SampleHistory& history);

/// Copies the Monitor's plots as a picture and saves them as SVG, PDF or PNG, in the light theme or, if asked
/// for, in the window's (resources/help/monitor.md, "Pictures").
class MonitorPicture : public QObject {
    Q_OBJECT

public:
    /// `panel` gets the actions.
    MonitorPicture(Workbench& bench, widgets::LivePlotStack& stack, QWidget& panel);

    void setFileChooser(FileChooser chooser) { m_chooser = std::move(chooser); }
    QAction& copyAction() { return *m_copy; }
    QAction& saveAction() { return *m_save; }
    QAction& colourAction() { return *m_asOnScreen; } ///< checkable: the window's colours

Q_SIGNALS:
    void failed(const QString& text, const QString& remedy);

private:
    std::vector<widgets::PictureSheet> sheets() const;
    widgets::Theme theme() const;
    int width_px() const;
    void copy();
    void save();

    Workbench& m_bench;
    widgets::LivePlotStack& m_stack;
    QWidget& m_panel;
    FileChooser m_chooser;
    FileQueue m_files;
    QAction* m_copy = nullptr;
    QAction* m_save = nullptr;
    QAction* m_asOnScreen = nullptr;
};

} // namespace halbench::app
