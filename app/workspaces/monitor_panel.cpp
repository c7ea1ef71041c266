#include "app/workspaces/monitor_panel.h"

#include "app/workspaces/monitor_data.h"
#include "app/workspaces/monitor_forecast.h"
#include "app/workspaces/monitor_picture.h"
#include "app/workspaces/monitor_plots.h"
#include "app/workspaces/monitor_rate.h"
#include "app/workspaces/monitor_recording.h"
#include "app/workspaces/monitor_reference.h"
#include "app/workspaces/monitor_statistics.h"
#include "app/workspaces/monitor_tools.h"
#include "app/workspaces/monitor_trigger.h"
#include "app/workspaces/pace_steps.h"
#include "app/workspaces/panel_parts.h"
#include "app/workspaces/recorded_markers.h"
#include "widgets/display_units.h"
#include "widgets/empty_state.h"
#include "widgets/live_plot_stack.h"
#include "widgets/message_bar.h"
#include "widgets/phrasebook.h"

#include <QAction>
#include <QEvent>
#include <QLabel>
#include <QStackedWidget>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr int ValuesPeriod_ms = 100;

/// Both on their left axes.
bool isOfQuantity(const widgets::PlotSpec& plot, const widgets::PlotSpec& wanted) {
    return plot.unit == wanted.unit && plot.quantity == wanted.quantity;
}

QString listed(const std::vector<std::string>& names) {
    QStringList list;
    for (const std::string& name : names) {
        list << QString::fromStdString(name);
    }
    return list.join(QStringLiteral(", "));
}

} // namespace

MonitorPanel::MonitorPanel(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    m_pages = new QStackedWidget(this);
    m_empty = new widgets::EmptyState(m_pages);
    m_empty->setIconName(QStringLiteral("connect"));
    auto* plots = new QWidget(m_pages);
    m_stack = new widgets::LivePlotStack(this);
    m_stack->setTheme(widgets::currentTheme());
    m_stack->setHistory(&m_bench.history());
    // A frame shows what has arrived until it is drawn, not what another timer brought up to a frame ago.
    connect(m_stack, &widgets::LivePlotStack::frameStarting, &m_bench, &Workbench::drainSamples);
    m_trigger = new MonitorTrigger(m_bench, *m_stack, *this);
    m_picture = new MonitorPicture(m_bench, *m_stack, *this);
    m_data = new MonitorData(m_bench, *m_stack, *this);
    m_stack->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_stack->addActions({&m_data->copyAction(), &m_data->saveAction(), &m_picture->copyAction(),
                         &m_picture->saveAction(), &m_picture->colourAction()});
    m_reference = new MonitorReference(*m_stack, *this);
    m_rate = new MonitorRate(m_bench, *this);
    m_statistics = new MonitorStatistics(m_bench, *m_stack, *this);
    auto* column = new QVBoxLayout(plots);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(buildTools());
    column->addWidget(&m_trigger->bar());
    m_message = new widgets::MessageBar(plots);
    m_recorded = new RecordedMarkers(m_bench, *m_stack, this);
    m_recording = new MonitorRecording(m_bench, *m_stack, *m_message, *this);
    column->addWidget(m_message);
    column->addWidget(m_stack, 1);
    column->addWidget(&(new MonitorForecast(m_bench, *m_stack, *this))->row());
    column->addWidget(&m_statistics->table());
    m_pages->addWidget(m_empty);
    m_pages->addWidget(plots);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(&m_recording->row());
    whole->addWidget(m_pages);
    connectStack();
    connect(m_empty, &widgets::EmptyState::actionTriggered, this, &MonitorPanel::connectRequested);
    connect(&m_bench, &Workbench::deviceChanged, this, &MonitorPanel::onDevice);
    connect(&m_bench, &Workbench::valuesChanged, this, &MonitorPanel::onValues);
    connect(&m_bench, &Workbench::displayUnitsChanged, this, &MonitorPanel::onValues);
    connect(&m_bench, &Workbench::derivedSignalsChanged, this, &MonitorPanel::onDerived);
    connect(&m_bench.freshness(), &Freshness::changed, this,
            [this] { m_stack->setStale(m_bench.freshness().words()); });
    connect(&m_bench, &Workbench::historyTroubled, this, [this](const Error& error) {
        m_message->showMessage(
            {widgets::Severity::Warning, widgets::inWords(error.message), widgets::inWords(error.hint), {}});
    });
    connect(&m_values, &QTimer::timeout, this, &MonitorPanel::refreshStream);
    connect(&m_bench.liveSignals(), &LiveSignals::changed, this, &MonitorPanel::sayLeftOut);
    connect(m_rate, &MonitorRate::changed, this, &MonitorPanel::sayLeftOut);
    m_values.start(ValuesPeriod_ms);
    addPaceKeys(m_bench, *this);
    refreshWords();
    onDevice();
}

/// A tool bar, so that what does not fit goes into its menu instead of widening the window.
QWidget* MonitorPanel::buildTools() {
    auto* bar = new QToolBar(tr("Plots"), this);
    bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"))->setToolTip(tr("More tools"));
    addPlotTools(*bar, *m_stack);
    for (QAction* action : {&m_reference->menuAction(), &m_trigger->action(), &m_statistics->action(),
                            &m_picture->copyAction(), &m_picture->saveAction(), &m_rate->action()}) {
        addTool(*bar, *action, false);
    }
    auto* space = new QWidget(bar);
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(space);
    m_stream = new QLabel(bar);
    m_stream->setToolTip(tr("What the device sends to the plots"));
    widgets::setRole(*m_stream, widgets::Role::Muted);
    bar->addWidget(m_stream);
    return bar;
}

void MonitorPanel::setFileChooser(FileChooser chooser) {
    m_reference->setFileChooser(chooser);
    m_data->setFileChooser(chooser);
    m_picture->setFileChooser(std::move(chooser));
}

void MonitorPanel::connectStack() {
    const auto sayFailure = [this](const QString& text, const QString& remedy) {
        m_message->showMessage({widgets::Severity::Error, text, remedy, {}});
    };
    connect(m_picture, &MonitorPicture::failed, this, sayFailure);
    connect(m_data, &MonitorData::failed, this, sayFailure);
    connect(m_recorded, &RecordedMarkers::failed, this, [sayFailure](const Error& error) {
        sayFailure(tr("The markers are not kept: %1").arg(widgets::inWords(error.message)),
                   widgets::inWords(error.hint));
    });
    connect(m_data, &MonitorData::done, this, [this](const QString& text) {
        m_message->showMessage({widgets::Severity::Success, text, {}, {}});
    });
    connect(m_reference, &MonitorReference::failed, this, sayFailure);
    connect(m_stack, &widgets::LivePlotStack::signalsDropped, this,
            [this](int plot, const QStringList& names) {
                for (const QString& name : names) {
                    addTo(plot, name.toStdString());
                }
                forgetMissing();
                onPlotsChanged();
            });
    connect(m_stack, &widgets::LivePlotStack::signalsDroppedBeside, this,
            [this](int plot, const QStringList& names) {
                const int added = m_stack->openBeside(plot, {});
                for (const QString& name : names) {
                    addTo(added, name.toStdString());
                }
                forgetMissing();
                onPlotsChanged();
            });
    connect(m_stack, &widgets::LivePlotStack::plotsChanged, this, [this] {
        forgetMissing();
        onValues(); // a curve may have come onto another axis
        onPlotsChanged();
    });
    connect(m_stack, &widgets::LivePlotStack::markersChanged, this, &MonitorPanel::onMarkers);
    connect(m_stack, &widgets::LivePlotStack::addSignalsRequested, this, &MonitorPanel::addSignalsRequested);
}

/// Another device brings its own signals; the same one again keeps its plots.
void MonitorPanel::onDevice() {
    const DeviceSession& session = m_bench.session();
    if (session.state() != SessionState::Connected || session.returns() > 0) {
        return; // a device that came back finds everything as it was
    }
    const QString device = deviceKey(session.info());
    m_pages->setCurrentIndex(1); // and stays: what was measured can be looked at without the device
    m_stack->setMarkers({});
    m_stack->setPaused(false);
    if (!m_trigger->isOn()) {
        m_stack->setFollowing(true);
    }
    m_stack->rescale(device == m_device);
    if (device != m_device) {
        m_trigger->setChoice(m_device.isEmpty() ? m_view.trigger : TriggerChoice{});
        m_view =
            m_device.isEmpty() ? m_view : MonitorView{}; // what was set is for the device that came first
        m_device = device;
        showView();
    }
    onPlotsChanged();
}

/// The plots are the user's now.
void MonitorPanel::forgetMissing() {
    m_isIncomplete = false;
    m_message->clear();
}

/// The limit on the device decides where the bad temperatures begin, the user in which units curves are; the
/// curves stay.
void MonitorPanel::onValues() {
    const TemperatureBands bands =
        temperatureBands(m_bench.catalogue(), m_bench.deviceValue("limit.temperature"));
    std::vector<widgets::PlotSpec> plots =
        inUnits(m_stack->plots(), m_bench.catalogue(), bands, m_bench.displayUnits());
    if (plots != m_stack->plots()) {
        for (std::size_t i = 0; i < plots.size(); ++i) {
            const bool isSameUnit = plots[i].unit == m_stack->plots()[i].unit;
            plots[i].fixedRange = isSameUnit ? m_stack->heldRange(static_cast<int>(i)) : std::nullopt;
        }
        m_stack->setPlots(std::move(plots));
    }
}

/// A curve goes with its signal; the others may mean something else now.
void MonitorPanel::onDerived() {
    const devices::Catalogue& catalogue = m_bench.catalogue();
    if (m_device.isEmpty() || m_bench.session().state() != SessionState::Connected) {
        return;
    }
    for (const std::string& name : plottedSignals(m_stack->plots())) {
        for (int i = static_cast<int>(m_stack->plots().size()) - 1;
             catalogue.findSignal(name) == nullptr && i >= 0; --i) {
            m_stack->removeCurve(i, name);
        }
    }
    onValues();
    onPlotsChanged();
}

void MonitorPanel::plot(const QString& name, bool isPlotted) {
    const std::string signal = name.toStdString();
    forgetMissing();
    if (isPlotted) {
        addTo(-1, signal);
    } else {
        for (int i = static_cast<int>(m_stack->plots().size()) - 1; i >= 0; --i) {
            m_stack->removeCurve(i, signal);
        }
    }
    onPlotsChanged();
}

void MonitorPanel::addTo(int plot, const std::string& name) {
    const devices::Catalogue& catalogue = m_bench.catalogue();
    const SignalSpec* spec = catalogue.findSignal(name);
    if (spec == nullptr) {
        return;
    }
    const widgets::PlotSpec wanted = plotFor(
        *spec, temperatureBands(catalogue, m_bench.deviceValue("limit.temperature")), m_bench.displayUnits());
    const std::vector<widgets::PlotSpec>& plots = m_stack->plots();
    if (plot >= 0 && plot < static_cast<int>(plots.size())) {
        addHere(plot, wanted);
        return;
    }
    auto found = std::find_if(plots.begin(), plots.end(),
                              [](const widgets::PlotSpec& each) { return each.curves.empty(); });
    if (found == plots.end()) { // none was opened for it
        found = std::find_if(plots.begin(), plots.end(),
                             [&](const widgets::PlotSpec& each) { return isOfQuantity(each, wanted); });
    }
    if (found == plots.end()) {
        m_stack->openPlot(static_cast<int>(plots.size()), wanted);
    } else {
        addHere(static_cast<int>(found - plots.begin()), wanted);
    }
}

/// What was dropped on a plot is seen there: on the left axis, on the right one, or in a plot below.
void MonitorPanel::addHere(int plot, const widgets::PlotSpec& wanted) {
    std::vector<widgets::PlotSpec> plots = m_stack->plots();
    widgets::PlotSpec& here = plots[static_cast<std::size_t>(plot)];
    widgets::PlotCurve curve = wanted.curves.front();
    const bool isShown =
        std::any_of(here.curves.begin(), here.curves.end(),
                    [&](const widgets::PlotCurve& other) { return other.signal == curve.signal; });
    if (here.curves.empty()) {
        const int column = here.column;
        here = wanted;
        here.column = column;
        m_stack->setPlots(std::move(plots));
    } else if (isOfQuantity(here, wanted) || isShown) {
        m_stack->addCurve(plot, curve);
    } else if (takes(here, true, curve.unit)) {
        curve.isRight = true;
        if (!hasRightAxis(here)) {
            here.right = {wanted.quantity, wanted.unit, {}};
        }
        here.curves.push_back(curve);
        m_stack->setPlots(std::move(plots));
    } else {
        m_stack->openPlot(plot + 1, wanted);
    }
}

void MonitorPanel::onPlotsChanged() {
    const std::set<std::string> plotted = plottedSignals(m_stack->plots());
    Q_EMIT plottedChanged(plotted);
    m_trigger->plotsChanged();
    std::vector<std::string> wanted(plotted.begin(), plotted.end());
    const auto& defaults = m_bench.catalogue().defaultSignals; // for the tree's live values
    wanted.insert(wanted.end(), defaults.begin(), defaults.end());
    m_bench.liveSignals().want(this, std::move(wanted));
}

/// Plotted, but without samples.
void MonitorPanel::sayLeftOut() {
    const QString leftOut = listed(m_bench.liveSignals().leftOut());
    const QString postponed = listed(m_bench.liveSignals().postponed());
    const QString lowered = m_rate->loweredWords();
    if (!leftOut.isEmpty()) {
        m_message->showMessage({widgets::Severity::Warning,
                                tr("Not shown: %1").arg(leftOut),
                                tr("The device samples them at other moments than the rest, or at none that "
                                   "repeat. Plot signals of one event together."),
                                {}});
    } else if (!postponed.isEmpty()) {
        m_message->showMessage(
            {widgets::Severity::Information,
             tr("Not in the running recording: %1").arg(postponed),
             tr("They are added when the recording has ended; until then the stream stays as "
                "it is, so that the recording has no gap."),
             {}});
    } else if (!lowered.isEmpty()) {
        m_message->showMessage({widgets::Severity::Information, lowered, tr("Plot fewer signals."), {}});
    } else if (m_isLeftOutSaid) {
        m_message->clear();
    }
    m_isLeftOutSaid = !leftOut.isEmpty() || !postponed.isEmpty() || !lowered.isEmpty();
}

/// They go into the recording that runs, and into one that is shown.
void MonitorPanel::onMarkers() {
    m_recorded->refresh();
    m_recording->keepMarkers();
}

void MonitorPanel::refreshWords() {
    m_empty->setWords(tr("Nothing to watch yet"),
                      tr("Shows what a connected device measures, live. Choose a device at the left, or try "
                         "the simulated motor."),
                      tr("Connect the simulated motor"), QStringLiteral("Ctrl+Shift+S"));
}

void MonitorPanel::refreshStream() {
    if (isVisible()) {
        m_stream->setText(m_recording->streamWords());
    }
}

void MonitorPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange) {
        m_stack->setTheme(widgets::currentTheme());
    } else if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::app
