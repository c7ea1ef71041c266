#include "app/workspaces/monitor/monitor_capture.h"

#include "app/workbench/display_quantity.h"
#include "app/workbench/drive_control.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QAction>
#include <QSignalBlocker>

#include <algorithm>

namespace halbench::app {

namespace {

using State = LoopCapture::State;
constexpr std::size_t Budget_bytes = std::size_t{1} << 23; ///< 4096 rows of four signals and their pyramids
constexpr double MostBefore_ratio = 0.99;                  ///< one row at least lies behind the event

control::TimeRange windowOf(const TriggerChoice& choice) {
    const double before_s = std::min(choice.preTrigger_ratio, MostBefore_ratio) * choice.window_s;
    return {-before_s, choice.window_s - before_s};
}

/// Other samples in the same plots; axes that the user holds stay.
void showHistory(widgets::LivePlotStack& stack, const control::SampleHistory& history) {
    std::vector<widgets::PlotSpec> plots = stack.plots();
    for (std::size_t i = 0; i < plots.size(); ++i) {
        plots[i].fixedRange = stack.heldRange(static_cast<int>(i));
        plots[i].right.fixedRange = stack.heldRange(static_cast<int>(i), true);
    }
    stack.setHistory(&history);
    stack.setPlots(std::move(plots));
}

} // namespace

MonitorCapture::MonitorCapture(Workbench& bench, widgets::LivePlotStack& stack, QObject* parent)
    : QObject(parent), m_bench(bench), m_stack(stack), m_capture(bench.session()), m_history(Budget_bytes) {
    connect(&m_capture, &LoopCapture::changed, this, &MonitorCapture::changed);
    connect(&m_capture, &LoopCapture::captured, this, &MonitorCapture::take);
    connect(&m_stack, &widgets::LivePlotStack::pausedChanged, this, [this](bool isPaused) {
        if (!isPaused && m_isOwed) {
            show();
        }
    });
    connect(&m_bench.recording(), &RecordingControl::changed, this,
            [this] { m_capture.setRecordingWritten(m_bench.recording().isRecording()); });
}

QString MonitorCapture::obstacle(const devices::Catalogue& catalogue) {
    return canCapture(catalogue) ? QString() : tr("This device has no capture function.");
}

void MonitorCapture::start(const TriggerChoice& choice) {
    const bool isSame = m_isOn && choice == m_choice;
    m_choice = choice;
    m_isOn = true;
    if (!isSame) {
        begin();
        if (m_isShown) {
            m_stack.showTimeRange(windowOf(m_choice));
        }
    }
}

void MonitorCapture::again() {
    begin();
}

void MonitorCapture::stop() {
    m_isOn = false;
    m_isOwed = false;
    m_capture.stop();
    if (!std::exchange(m_isShown, false)) {
        return;
    }
    showHistory(m_stack, m_bench.history());
    if (!m_stack.isFollowing()) {
        m_stack.showTimeRange(m_liveView);
    }
    m_stack.setMarkersEditable(true);
    const QSignalBlocker quiet(m_stack); // they are no new ones
    m_stack.setMarkers(std::exchange(m_liveMarkers, {}));
    m_stack.setEvent(std::nullopt);
    exchangePairs();
}

/// Other signals in the plots: the next capture has them.
void MonitorCapture::plotsChanged() {
    if (m_isOn && m_capture.state() != State::Done && capturable() != m_capture.config().signals) {
        begin();
    }
}

/// Of the plots, from the top. A reference that is none is sent as zero, far from an angle of many turns.
std::vector<std::string> MonitorCapture::capturable() const {
    const devices::Catalogue& catalogue = m_bench.session().catalogue();
    const std::string reference = m_bench.drive().mode() == devices::BoardMode::Position
                                      ? std::string()
                                      : catalogue.signalForRole("reference");
    std::vector<std::string> names;
    for (const widgets::PlotSpec& plot : m_stack.plots()) {
        for (const widgets::PlotCurve& curve : plot.curves) {
            const bool isNew = std::find(names.begin(), names.end(), curve.signal) == names.end();
            if (isNew && names.size() < CaptureSignals && curve.signal != reference &&
                catalogue.findSignal(curve.signal) != nullptr) {
                names.push_back(curve.signal);
            }
        }
    }
    return names;
}

void MonitorCapture::begin() {
    CaptureConfig config;
    config.signals = capturable();
    config.rate_Hz = captureRateFor_Hz(m_choice.window_s);
    config.pretrigger_ratio = std::min(m_choice.preTrigger_ratio, MostBefore_ratio);
    config.trigger.kind =
        m_choice.source.empty() ? CaptureTrigger::Kind::Reference : CaptureTrigger::Kind::Level;
    config.trigger.signal = m_choice.source;
    config.trigger.level = m_choice.level;
    config.trigger.isRising = m_choice.slope != control::TriggerSlope::Falling;
    m_capture.start(config);
}

void MonitorCapture::take() {
    m_isOwed = true;
    if (!m_stack.isPaused()) {
        show();
    }
    if (m_choice.mode != control::TriggerMode::Single) {
        begin();
    }
}

/// Where the user looks around in the window, he does so in the next one too.
void MonitorCapture::show() {
    m_isOwed = false;
    const Recording& caught = m_capture.recording();
    SampleBlock block;
    block.layout = caught.layout;
    block.time_s = caught.time_s;
    block.values = caught.values;
    m_history.clear();
    m_history.append(block);
    if (!m_isShown) {
        enter();
    }
    Q_EMIT shown();
}

/// A mark in the live samples has no place here, and none made here has one there.
void MonitorCapture::enter() {
    m_isShown = true;
    m_liveMarkers = m_stack.markers();
    m_liveView = m_stack.timeRange();
    {
        const QSignalBlocker quiet(m_stack);
        m_stack.setMarkers({});
    }
    m_stack.setMarkersEditable(false);
    showHistory(m_stack, m_history);
    m_stack.setEvent(0.0);
    const control::TimeRange window = windowOf(m_choice);
    m_stack.showTimeRange(window);
    exchangePairs();
    if (!m_stack.cursorPairs().areKept()) {
        m_stack.setCursor(0, 0.0);
        m_stack.setCursor(1, 0.5 * window.end_s);
    }
}

/// Two time axes: what was put at a moment of one says nothing on the other.
void MonitorCapture::exchangePairs() {
    widgets::CursorPairs shown = std::exchange(m_otherPairs, m_stack.cursorPairs());
    shown.setVisible(m_otherPairs.cursors().isVisible);
    m_stack.setCursorPairs(std::move(shown));
}

QString MonitorCapture::whatIsCaught() const {
    QStringList names;
    for (const std::string& name : m_capture.config().signals) {
        names << signalWords(name);
    }
    const double rate_Hz = m_capture.config().rate_Hz;
    return tr("%1 at %2 Hz, %3 s, starting %4 s before the event")
        .arg(names.join(QStringLiteral(", ")), widgets::numberText(rate_Hz, 4),
             widgets::numberText(CaptureRows / rate_Hz, 4),
             widgets::numberText(m_capture.config().pretrigger_ratio * CaptureRows / rate_Hz, 3));
}

TriggerWords MonitorCapture::words(const QString& event) const {
    using widgets::Role;
    switch (m_capture.state()) {
    case State::Off:
        return {};
    case State::Held:
        return {tr("On hold"), tr("A procedure is using the device; the capture continues afterwards"),
                Role::Warn};
    case State::Begins:
        return {tr("Starting"), tr("Setting up the capture of %1").arg(whatIsCaught()), Role::Muted};
    case State::Filling:
        return {tr("Filling pre-trigger"), tr("Capturing the time before the event: %1").arg(whatIsCaught()),
                Role::Muted};
    case State::Waiting:
        return {tr("Waiting"), tr("Waiting until %1; captures %2").arg(event, whatIsCaught()), Role::Muted};
    case State::Running:
        return {tr("Triggered"), tr("Triggered; capturing the time after the event"), Role::Good};
    case State::Full:
        return {tr("Captured"),
                tr("Captured; read from the device after the recording, so that no sample is lost"),
                Role::Good};
    case State::Reading: {
        const QString percent = widgets::fixedText(100.0 * m_capture.fraction(), 0);
        return {tr("Reading, %1 %").arg(percent),
                tr("Reading the capture from the device, %1 %").arg(percent), Role::Good};
    }
    case State::Done:
        return {tr("Stopped"), tr("Stopped after an event (Shift+T re-arms); %1").arg(whatIsCaught()),
                Role::Warn};
    case State::Failed:
        return {widgets::inWords(m_capture.error().message),
                tr("%1; %2").arg(widgets::inWords(m_capture.error().message),
                                 widgets::inWords(m_capture.error().hint)),
                Role::Bad};
    }
    return {};
}

} // namespace halbench::app
