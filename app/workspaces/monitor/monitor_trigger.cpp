#include "app/workspaces/monitor/monitor_trigger.h"

#include "app/workbench/recording_trigger.h"
#include "app/workspaces/monitor/monitor_capture.h"
#include "app/workspaces/monitor/trigger_bar.h"
#include "control/base/assert.h"
#include "widgets/language/display_units.h"
#include "widgets/live_plot/live_plot_stack.h"
#include "widgets/theme/icons.h"

#include <QAction>

#include <utility>

namespace halbench::app {

namespace {

constexpr double Hysteresis_ratio = 0.05; ///< of what the source does in the view
constexpr int TimeDecimals = 3;

QAction* makeAction(QWidget& panel, const QString& text, const QString& what, const char* icon,
                    const char* shortcut) {
    auto* action = new QAction(widgets::themedIcon(QLatin1String(icon)), text, &panel);
    action->setShortcut(QKeySequence(QLatin1String(shortcut)));
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    action->setToolTip(
        QStringLiteral("%1 (%2)").arg(what, action->shortcut().toString(QKeySequence::NativeText)));
    panel.addAction(action);
    return action;
}

} // namespace

MonitorTrigger::MonitorTrigger(Workbench& bench, widgets::LivePlotStack& stack, QWidget& panel)
    : QObject(&panel), m_bench(bench), m_stack(stack), m_trigger(bench.history()) {
    createActions(panel);
    m_bar = new TriggerBar(*m_again, &panel);
    m_bar->hide();
    m_capture = new MonitorCapture(bench, stack, this);
    connect(m_capture, &MonitorCapture::changed, this, &MonitorTrigger::say);
    connect(m_capture, &MonitorCapture::shown, this, &MonitorTrigger::say);
    connect(m_onOff, &QAction::toggled, this, &MonitorTrigger::switchTo);
    connect(m_again, &QAction::triggered, this, [this] {
        m_capture->isOn() ? m_capture->again() : m_trigger.rearm();
        say();
    });
    connect(m_bar, &TriggerBar::edited, this, &MonitorTrigger::restart);
    connect(m_bar, &TriggerBar::sourceChosen, this, &MonitorTrigger::takeMiddle);
    connect(m_bar, &TriggerBar::middleRequested, this, &MonitorTrigger::takeMiddle);
    connect(&m_stack, &widgets::LivePlotStack::levelMoved, this, &MonitorTrigger::moveLevel);
    connect(&m_stack, &widgets::LivePlotStack::followingChanged, this, [this](bool isFollowing) {
        if (isFollowing && (m_event_s || m_capture->isShown())) {
            m_onOff->setChecked(false);
        }
    });
    connect(&m_bench, &Workbench::samplesArrived, this, &MonitorTrigger::update);
    connect(&m_bench, &Workbench::deviceChanged, this, &MonitorTrigger::onDevice);
    connect(&m_bench, &Workbench::displayUnitsChanged, this, &MonitorTrigger::onDevice);
    connect(&m_bench, &Workbench::derivedSignalsChanged, this, &MonitorTrigger::onDevice);
}

void MonitorTrigger::createActions(QWidget& panel) {
    m_onOff = makeAction(panel, tr("Trigger"), tr("Oscilloscope view: time around the latest event"),
                         "trigger", "T");
    m_onOff->setCheckable(true);
    m_again = makeAction(panel, tr("Re-arm trigger"), tr("Clear the event and wait for the next one"),
                         "waiting", "Shift+T");
    m_again->setEnabled(false);
}

QWidget& MonitorTrigger::bar() {
    return *m_bar;
}

TriggerChoice MonitorTrigger::choice() const {
    TriggerChoice choice = m_bar->choice();
    choice.isOn = m_isOn;
    return choice;
}

void MonitorTrigger::setChoice(const TriggerChoice& choice) {
    m_bar->setChoice(choice);
    m_onOff->setChecked(choice.isOn);
    restart();
}

void MonitorTrigger::onDevice() {
    const DeviceSession& session = m_bench.session();
    if (session.state() == SessionState::Connected) {
        if (session.returns() == 0 && deviceKey(session.info()) != m_device) {
            leaveBoard(); // what another one caught
            m_device = deviceKey(session.info());
        }
        std::vector<std::string> derived;
        for (const devices::DerivedSignal& one : m_bench.derivedSignals()) {
            derived.push_back(one.name);
        }
        m_bar->setCatalogue(m_bench.catalogue(), m_bench.displayUnits(), std::move(derived));
        restart();
    }
}

void MonitorTrigger::switchTo(bool isOn) {
    m_isOn = isOn;
    m_again->setEnabled(isOn);
    m_bar->setVisible(isOn);
    if (isOn) {
        m_wasFollowing = m_stack.isFollowing();
    } else {
        const bool wasShown = std::exchange(m_event_s, std::nullopt).has_value() || m_capture->isShown();
        m_capture->stop();
        m_trigger.stop();
        if (wasShown && m_wasFollowing) {
            m_stack.setFollowing(true);
        }
    }
    restart();
}

/// With what is chosen, from now on. What is shown stays until the next event.
void MonitorTrigger::restart() {
    const devices::Catalogue& catalogue = m_bench.session().catalogue();
    const SetPointSignals setPoint{catalogue.signalForRole("reference"),
                                   catalogue.signalForRole("current_command")};
    const TriggerChoice& chosen = m_bar->choice();
    m_bench.recordingTrigger().setChoice(chosen, m_bar->eventWords());
    std::vector<std::string> wanted;
    if (m_isOn && chosen.source.empty()) {
        wanted = {setPoint.reference, setPoint.command};
    } else if (m_isOn) {
        wanted = {chosen.source};
    }
    m_bench.liveSignals().want(this, std::move(wanted));
    if (m_isOn && chosen.isBoard) {
        startBoard(chosen);
    } else {
        startLive(chosen, setPoint);
    }
    showLevel();
    say();
}

void MonitorTrigger::startBoard(const TriggerChoice& chosen) {
    m_trigger.stop();
    if (std::exchange(m_event_s, std::nullopt)) {
        m_stack.setEvent(std::nullopt);
    }
    m_capture->start(chosen);
}

/// Back to the live samples; the newest ones until an event comes.
void MonitorTrigger::leaveBoard() {
    const bool wasShown = m_capture->isShown();
    m_capture->stop();
    if (wasShown) {
        m_stack.setFollowing(true);
    }
}

void MonitorTrigger::startLive(const TriggerChoice& chosen, const SetPointSignals& setPoint) {
    leaveBoard();
    if (m_isOn) {
        const Result<void> started = m_trigger.start(chosen, setPoint);
        HB_ASSERT(started.has_value()); // the fields allow nothing else
    }
    if (m_event_s) { // the same event in the window as it is now
        m_stack.showTimeRange({*m_event_s - chosen.preTrigger_ratio * chosen.window_s,
                               *m_event_s + (1.0 - chosen.preTrigger_ratio) * chosen.window_s});
    }
    m_stack.setEvent(m_event_s);
}

void MonitorTrigger::setLivePairs(widgets::CursorPairs pairs) {
    if (m_capture->isShown()) {
        m_capture->setLivePairs(std::move(pairs));
    } else {
        m_stack.setCursorPairs(std::move(pairs));
    }
}

const widgets::CursorPairs& MonitorTrigger::livePairs() const {
    return m_capture->isShown() ? m_capture->livePairs() : m_stack.cursorPairs();
}

const std::vector<widgets::PlotMarker>& MonitorTrigger::liveMarkers() const {
    return m_capture->isShown() ? m_capture->liveMarkers() : m_stack.markers();
}

void MonitorTrigger::setLiveMarkers(std::vector<widgets::PlotMarker> markers) {
    if (m_capture->isShown()) {
        m_capture->setLiveMarkers(std::move(markers));
        Q_EMIT liveMarkersChanged();
    } else {
        m_stack.setMarkers(std::move(markers)); // which says so
    }
}

void MonitorTrigger::addLiveMarker(widgets::PlotMarker marker) {
    if (m_capture->isShown()) {
        std::vector<widgets::PlotMarker> markers = m_capture->liveMarkers();
        markers.push_back(std::move(marker));
        setLiveMarkers(std::move(markers));
    } else {
        m_stack.addMarker(std::move(marker)); // the chosen one stays chosen
    }
}

void MonitorTrigger::plotsChanged() {
    m_capture->plotsChanged();
}

void MonitorTrigger::update() {
    if (!m_isOn || m_capture->isOn()) {
        return;
    }
    if (m_trigger.update() && !m_stack.isPaused()) {
        showEvent();
    }
    say();
}

/// Where the user looks around in the window, he does so around the next event too.
void MonitorTrigger::showEvent() {
    const control::TriggerEvent& event = *m_trigger.shown();
    control::TimeRange view{event.begin_s, event.end_s};
    if (m_event_s) {
        const double by_s = event.time_s - *m_event_s;
        view = {m_stack.timeRange().begin_s + by_s, m_stack.timeRange().end_s + by_s};
    }
    m_event_s = event.time_s;
    m_stack.setEvent(m_event_s);
    m_stack.showTimeRange(view);
}

void MonitorTrigger::showLevel() {
    const TriggerChoice& chosen = m_bar->choice();
    m_stack.setLevel(m_isOn && !chosen.source.empty()
                         ? std::optional(widgets::PlotLevel{chosen.source, chosen.level,
                                                            chosen.isBoard ? 0.0 : chosen.hysteresis})
                         : std::nullopt);
}

void MonitorTrigger::moveLevel(double level) {
    TriggerChoice choice = m_bar->choice();
    choice.level = level;
    m_bar->setChoice(choice);
    restart();
}

void MonitorTrigger::takeMiddle() {
    TriggerChoice choice = m_bar->choice();
    const control::Extremes extremes = m_stack.history()->extremes(choice.source, m_stack.timeRange());
    if (!extremes.isEmpty()) {
        choice.level = 0.5 * (extremes.min + extremes.max);
        choice.hysteresis = Hysteresis_ratio * (extremes.max - extremes.min);
        m_bar->setChoice(choice);
    }
    restart();
}

void MonitorTrigger::say() {
    if (!m_capture->isOn()) {
        sayLive();
        return;
    }
    const TriggerWords words = m_capture->words(m_bar->eventWords());
    m_bar->setState(words.words, words.sentence, words.role);
}

void MonitorTrigger::sayLive() {
    const auto& shown = m_trigger.shown();
    const bool isByItself = shown && shown->cause == control::TriggerCause::Wait;
    const QString when = shown ? widgets::fixedText(shown->time_s, TimeDecimals) : QString();
    const std::string& source = m_bar->choice().source;
    if (!source.empty() && !m_bench.history().contains(source)) {
        m_bar->setState(tr("No samples"), tr("No samples of %1").arg(signalWords(source)),
                        widgets::Role::Warn);
        return;
    }
    switch (m_trigger.state()) {
    case TriggerState::Off:
        m_bar->setState({}, {}, widgets::Role::Muted);
        break;
    case TriggerState::Waiting:
        m_bar->setState(tr("Waiting"), tr("Waiting until %1").arg(m_bar->eventWords()), widgets::Role::Muted);
        break;
    case TriggerState::Filling:
    case TriggerState::Shown:
        if (!shown) {
            m_bar->setState(tr("Triggered"), tr("Triggered; filling the window"), widgets::Role::Good);
        } else if (isByItself) {
            m_bar->setState(tr("Auto: no event"),
                            tr("Auto: no event, free-running; waiting until %1").arg(m_bar->eventWords()),
                            widgets::Role::Muted);
        } else {
            m_bar->setState(tr("Triggered at %1 s").arg(when),
                            tr("Triggered at %1 s; waiting for the next").arg(when), widgets::Role::Good);
        }
        break;
    case TriggerState::Stopped:
        m_bar->setState(tr("Stopped at %1 s").arg(when),
                        tr("Stopped after the event at %1 s (Shift+T re-arms)").arg(when),
                        widgets::Role::Warn);
        break;
    }
}

} // namespace halbench::app
