#pragma once

#include "app/workspaces/file_chooser.h"
#include "app/workspaces/monitor_view.h"
#include "app/workspaces/workbench.h"

#include <QTimer>
#include <QWidget>

#include <set>
#include <string>

class QLabel;
class QStackedWidget;

namespace halbench::widgets {
class EmptyState;
class LivePlotStack;
class MessageBar;
struct PlotSpec;
} // namespace halbench::widgets

namespace halbench::app {

class MonitorData;
class MonitorStatistics;
class MonitorPicture;
class MonitorRate;
class MonitorRecording;
class MonitorReference;
class MonitorTrigger;
class RecordedMarkers;

/// What the device does, over time, in stacked plots (resources/help/monitor.md, "Plots").
class MonitorPanel : public QWidget {
    Q_OBJECT

public:
    explicit MonitorPanel(Workbench& bench, QWidget* parent = nullptr);

    void setFileChooser(FileChooser chooser);
    MonitorView view() const;
    /// Shown when a device is there. Signals that it does not have are left out and said in place; they stay
    /// part of view() until the user changes the plots.
    void setView(const MonitorView& view);

    /// Into the plot of its kind, or out of all plots.
    void plot(const QString& name, bool isPlotted);

Q_SIGNALS:
    void plottedChanged(const std::set<std::string>& names);
    void addSignalsRequested();
    void connectRequested(); ///< of the simulated motor, while there is nothing to watch

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* buildTools();
    void connectStack();
    void onDevice();
    void onValues();
    void onDerived();
    /// To the plot asked for; -1: to an empty one, to the first with that quantity, else to a new one below.
    void addTo(int plot, const std::string& name);
    void addHere(int plot, const widgets::PlotSpec& wanted);
    void onPlotsChanged();
    void showView();
    void forgetMissing();
    void sayLeftOut();
    void onMarkers();
    void refreshStream();
    void refreshWords();

    Workbench& m_bench;
    QStackedWidget* m_pages = nullptr;
    widgets::EmptyState* m_empty = nullptr;
    widgets::LivePlotStack* m_stack = nullptr;
    MonitorTrigger* m_trigger = nullptr;
    MonitorPicture* m_picture = nullptr;
    MonitorData* m_data = nullptr;
    MonitorReference* m_reference = nullptr;
    MonitorRate* m_rate = nullptr;
    MonitorRecording* m_recording = nullptr;
    RecordedMarkers* m_recorded = nullptr;
    MonitorStatistics* m_statistics = nullptr;
    QLabel* m_stream = nullptr;
    QTimer m_values;    ///< what is said of the stream
    QString m_device;   ///< whose plots are shown; empty: the view waits for a device
    MonitorView m_view; ///< as it was set
    bool m_isLeftOutSaid = false;
    bool m_isIncomplete = false; ///< some of m_view is left out, and nothing was changed since
    widgets::MessageBar* m_message = nullptr;
};

} // namespace halbench::app
