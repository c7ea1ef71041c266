#pragma once

#include "app/documents/axis_model_file.h"
#include "app/procedures/frequency/axes_frequency.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/workbench.h"

#include <QStackedWidget>

namespace halbench::widgets {
class EmptyState;
}

namespace halbench::app {

class AxisTunePanel;

/// Pages of the Tune panel: an empty state with the way out, the work on one loop, the axes of a device with
/// several. Device and identification decide which one is shown. Thread: GUI.
class TunePages : public QStackedWidget {
    Q_OBJECT
public:
    explicit TunePages(Workbench& bench, QWidget* parent = nullptr);

    void setLoopPage(QWidget* page);
    void setFileChooser(FileChooser chooser);
    /// Gains for these axes, identified just now.
    void useAxisModel(const AxisModelFile& model);
    /// A measured response of the axes in their open loops, now or once they are identified.
    void useMeasuredAxes(const AxesFrequencyResult& response);
    /// It was measured on a device that is left.
    void forgetMeasuredAxes();
    void showPage();
    void refreshTexts();

Q_SIGNALS:
    void identifyRequested();

private:
    AxisTunePanel& axisPanel();

    Workbench& m_bench;
    FileChooser m_chooser;
    widgets::EmptyState* m_empty;
    QWidget* m_loop = nullptr;
    AxisTunePanel* m_axes = nullptr; ///< once axes were identified or measured
};

} // namespace halbench::app
