#pragma once

#include "app/workbench/live_trigger.h"
#include "app/workbench/workbench.h"
#include "widgets/live_plot/plot_marker.h"

#include <QObject>

#include <vector>

class QAction;
class QWidget;

namespace halbench::widgets {
class CursorPairs;
class LivePlotStack;
} // namespace halbench::widgets

namespace halbench::app {

class MonitorCapture;
class TriggerBar;

/// The Monitor as an oscilloscope: while it is on, the plots show a window of time around the newest event
/// until the next one comes (resources/help/monitor.md, "Trigger"). Following the newest sample ends it.
class MonitorTrigger : public QObject {
    Q_OBJECT

public:
    /// `panel` gets the actions and the bar.
    MonitorTrigger(Workbench& bench, widgets::LivePlotStack& stack, QWidget& panel);

    QAction& action() { return *m_onOff; }
    QWidget& bar();

    TriggerChoice choice() const;
    void setChoice(const TriggerChoice& choice);
    bool isOn() const { return m_isOn; }
    /// Of the view when it is off.
    bool isFollowingOtherwise() const { return m_wasFollowing; }
    void plotsChanged();
    /// The pairs on the time axis of the live samples, also while a capture is shown.
    const widgets::CursorPairs& livePairs() const;
    void setLivePairs(widgets::CursorPairs pairs);
    /// The same of markers: a capture has none.
    const std::vector<widgets::PlotMarker>& liveMarkers() const;
    void setLiveMarkers(std::vector<widgets::PlotMarker> markers);
    void addLiveMarker(widgets::PlotMarker marker);

Q_SIGNALS:
    void liveMarkersChanged(); ///< while a capture is shown; else the plots say so

private:
    void createActions(QWidget& panel);
    void switchTo(bool isOn);
    void onDevice();
    void restart();
    void startLive(const TriggerChoice& chosen, const SetPointSignals& setPoint);
    void startBoard(const TriggerChoice& chosen);
    void leaveBoard();
    void update();
    void showEvent();
    void showLevel();
    void takeMiddle();
    void moveLevel(double level);
    void say();
    void sayLive();

    Workbench& m_bench;
    widgets::LivePlotStack& m_stack;
    LiveTrigger m_trigger;
    QAction* m_onOff = nullptr;
    QAction* m_again = nullptr;
    TriggerBar* m_bar = nullptr;
    MonitorCapture* m_capture = nullptr; ///< the board's own
    QString m_device;
    bool m_isOn = false;
    bool m_wasFollowing = true;
    std::optional<double> m_event_s; ///< at which the view stands
};

} // namespace halbench::app
