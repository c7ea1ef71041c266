#pragma once

#include "app/workbench/signals/loop_capture.h"
#include "app/workbench/trigger_choice.h"
#include "app/workbench/workbench.h"
#include "control/history/sample_history.h"
#include "widgets/live_plot/cursor_pairs.h"
#include "widgets/live_plot/plot_marks.h"
#include "widgets/theme/theme_style.h"

#include <QObject>
#include <QStringList>

#include <utility>

namespace halbench::widgets {
class LivePlotStack;
}

namespace halbench::app {

/// Trigger in words: in short, and all of it.
struct TriggerWords {
    QString words;
    QString sentence;
    widgets::Role role = widgets::Role::Muted;
};

/// The board's own capture in the Monitor's plots (resources/help/monitor.md, "Trigger"): what the board
/// caught takes the place of the live samples, with zero at the event, until stop(). The live ones are kept
/// meanwhile as ever.
class MonitorCapture : public QObject {
    Q_OBJECT

public:
    MonitorCapture(Workbench& bench, widgets::LivePlotStack& stack, QObject* parent);

    /// With the first signals of the plots, as many as the board takes. What is shown stays until the next.
    void start(const TriggerChoice& choice);
    void again();
    /// The live samples are shown again.
    void stop();
    void plotsChanged();
    bool isOn() const { return m_isOn; }
    bool isShown() const { return m_isShown; }
    /// Of the live samples, while these are not shown; those of captures are kept meanwhile.
    const widgets::CursorPairs& livePairs() const { return m_otherPairs; }
    void setLivePairs(widgets::CursorPairs pairs) { m_otherPairs = std::move(pairs); }
    /// The same of markers, which a capture has none of.
    const std::vector<widgets::PlotMarker>& liveMarkers() const { return m_liveMarkers; }
    void setLiveMarkers(std::vector<widgets::PlotMarker> markers) { m_liveMarkers = std::move(markers); }
    /// `event`: what is waited for.
    TriggerWords words(const QString& event) const;

    /// Why a connected device cannot do it; empty: it can.
    static QString obstacle(const devices::Catalogue& catalogue);

Q_SIGNALS:
    void changed();
    void shown(); ///< another one

private:
    std::vector<std::string> capturable() const;
    void begin();
    void take();
    void show();
    void enter();
    void exchangePairs();
    QString whatIsCaught() const;

    Workbench& m_bench;
    widgets::LivePlotStack& m_stack;
    LoopCapture m_capture;
    TriggerChoice m_choice;
    control::SampleHistory m_history;
    std::vector<widgets::PlotMarker> m_liveMarkers; ///< and the view, while this one is shown
    control::TimeRange m_liveView;
    widgets::CursorPairs m_otherPairs; ///< of the live samples or of the captures: the ones not shown
    bool m_isOn = false;
    bool m_isShown = false;
    bool m_isOwed = false; ///< caught, not shown: the view is paused
};

} // namespace halbench::app
