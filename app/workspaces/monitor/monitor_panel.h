#pragma once

#include "app/workbench/file_chooser.h"
#include "app/workbench/workbench.h"
#include "app/workspaces/monitor/monitor_view.h"
#include "widgets/live_plot/plot_marker.h"

#include <QWidget>

#include <set>
#include <string>

class QLabel;
class QStackedWidget;
class QToolBar;

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
class SignalBox;

/// Stacked plots of the signals over time (resources/help/monitor.md, "Plots"). A further one
/// beside the first has plots and a time axis of its own on the same samples; the trigger, the live rate,
/// derived signals and cursors of a project are the first one's. All have the same markers, once they are
/// connected to each other; the first one keeps them in recordings.
class MonitorPanel : public QWidget {
    Q_OBJECT

public:
    enum class Rank { First, Further };
    explicit MonitorPanel(Workbench& bench, QWidget* parent = nullptr, Rank rank = Rank::First);

    void setFileChooser(FileChooser chooser);
    /// At the left end of the tools, in words.
    void addToolsAhead(const QList<QAction*>& actions);
    MonitorView view() const;
    /// Shown when a device is there. Signals that it does not have are left out and said in place; they stay
    /// part of view() until the user changes the plots.
    void setView(const MonitorView& view);

    /// Into the plot of its kind, or out of all plots.
    void plot(const QString& name, bool isPlotted);
    /// One that is closed asks the device for nothing. The first one always does.
    void setInUse(bool isInUse);
    /// Those of the live samples, or of the recording that is shown.
    const std::vector<widgets::PlotMarker>& markers() const;
    void setMarkers(const std::vector<widgets::PlotMarker>& markers);
    /// Of the first one: the recording that runs got a marker elsewhere, at a time of the device.
    void takeRecordedMarker(double device_s, const QString& note);

Q_SIGNALS:
    void markersChanged();
    void plottedChanged(const std::set<std::string>& names);
    void addSignalsRequested();
    void connectRequested(); ///< of the simulated motor, while there is nothing to watch

protected:
    void changeEvent(QEvent* event) override;

private:
    bool isFirst() const { return m_rank == Rank::First; }
    void connectBench();
    QWidget* buildTools();
    void addBox(QToolBar& bar);
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
    void refreshWords();

    Workbench& m_bench;
    const Rank m_rank;
    bool m_isInUse = true;
    SignalBox* m_box = nullptr; ///< of a further one: the tree is the first one's
    int m_addTo = -1;           ///< the plot that its choice is for
    QStackedWidget* m_pages = nullptr;
    widgets::EmptyState* m_empty = nullptr;
    widgets::LivePlotStack* m_stack = nullptr;
    MonitorTrigger* m_trigger = nullptr; ///< null in a further one, as the rate
    MonitorPicture* m_picture = nullptr;
    MonitorData* m_data = nullptr;
    MonitorReference* m_reference = nullptr;
    MonitorRate* m_rate = nullptr;
    MonitorRecording* m_recording = nullptr;
    RecordedMarkers* m_recorded = nullptr; ///< null in a further one
    MonitorStatistics* m_statistics = nullptr;
    QToolBar* m_tools = nullptr;
    QString m_device;   ///< whose plots are shown; empty: the view waits for a device
    MonitorView m_view; ///< as it was set
    bool m_isLeftOutSaid = false;
    bool m_isIncomplete = false; ///< some of m_view is left out, and nothing was changed since
    widgets::MessageBar* m_message = nullptr;
};

} // namespace halbench::app
