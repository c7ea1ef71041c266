// How soon the board commands no current after Esc was pressed, in real time, whatever the window is busy
// with.
#include "app/procedures/identify/identify_procedure.h"
#include "app/session/recorder.h"
#include "app/window/docks/dock_layout.h"
#include "app/window/window_application.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "devices/open/open_device.h"
#include "devices/recording/recording_writer.h"
#include "tests/bench/goal.h"
#include "tests/bench/window_rig.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest/QTest>
#include <qtadvanceddocking/DockWidget.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace halbench::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int Presses = 100;
constexpr double Goal_ms = 50.0;
/// Below the friction of the motor: current flows, nothing turns.
constexpr double Current_A = 0.2;
/// Of the full plotting load.
constexpr std::size_t Signals = 12;
constexpr double Rate_Hz = 1000.0;
constexpr double History_s = 600.0;

/// When the board's current command became zero, as its own stream says; up to a slice of the connection
/// later than it did. Thread: take() the connection's, the others any.
class CurrentWatch {
public:
    void take(const SampleBlock& block) {
        const int column = block.layout->indexOf("current_command");
        if (column < 0 || block.rows() == 0) {
            return;
        }
        const bool isDriven = block.value(block.rows() - 1, static_cast<std::size_t>(column)) != 0.0;
        if (m_isDriven.exchange(isDriven) && !isDriven) {
            m_zero = Clock::now();
        }
    }
    bool isDriven() const { return m_isDriven; }
    Clock::time_point zero() const { return m_zero; }

private:
    std::atomic<bool> m_isDriven = false;
    std::atomic<Clock::time_point> m_zero;
};

/// What the window is busy with while Esc is pressed.
struct Load {
    std::function<bool()> prepare = [] { return true; }; ///< before each press
    std::function<bool()> isBusy = [] { return true; };  ///< at the press
    std::function<void()> end = [] {};                   ///< after each press
};

class StopBench {
public:
    StopBench(Goals& goals, app::MainWindow& window, CurrentWatch& watch)
        : m_goals(goals), m_window(window), m_watch(watch) {}

    void run(const std::string& name, QWidget& target, const Load& load) {
        std::vector<double> latencies_s;
        for (int press = 0; press < Presses; ++press) {
            if (!drive() || !load.prepare()) {
                return m_goals.failed(name, "the motor or the load could not be started");
            }
            const double latency_s = pressToZero_s(target, load, std::chrono::milliseconds(7 + press % 40));
            if (latency_s < 0.0) {
                return m_goals.failed(name, "the window was not busy at the press");
            }
            latencies_s.push_back(latency_s);
            load.end();
        }
        std::sort(latencies_s.begin(), latencies_s.end());
        m_goals.below(name + ", 99th percentile", latencies_s[Presses - 1 - Presses / 100] * 1e3, Goal_ms,
                      "ms");
    }

private:
    app::DeviceSession& session() { return m_window.bench().session(); }

    /// Released, armed and with a current in the coils.
    bool drive() {
        return request(session(),
                       [](devices::Device& device) -> Result<void> {
                           if (Result<void> done = device.clearStop(); !done) {
                               return done;
                           }
                           const ParameterValue mode[] = {{"hb.mode", 1.0}};
                           if (Result<void> done = device.writeParameters(mode); !done) {
                               return done;
                           }
                           if (Result<void> done = device.arm(); !done) {
                               return done;
                           }
                           const ParameterValue current[] = {{"hb.setpoint", Current_A}};
                           return device.writeParameters(current);
                       }) &&
               QTest::qWaitFor([this] { return m_watch.isDriven(); }, Patience_ms);
    }

    /// A hand of its own presses the key at any moment of the window's work, as a person does: in the middle
    /// of a frame or of a save. Negative when the load had ended.
    double pressToZero_s(QWidget& target, const Load& load, Clock::duration after) {
        std::atomic<bool> wasBusy = true;
        Clock::time_point pressed;
        std::thread hand([&] {
            (void)std::promise<void>().get_future().wait_for(after);
            wasBusy = load.isBusy();
            pressed = Clock::now();
            QCoreApplication::postEvent(&target,
                                        new QKeyEvent(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier));
        });
        const Clock::time_point patience = Clock::now() + std::chrono::milliseconds(Patience_ms);
        while (m_watch.isDriven() && Clock::now() < patience) { // as the program waits; a test's wait sleeps
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        }
        const bool hasStopped = !m_watch.isDriven();
        hand.join();
        if (!wasBusy || !hasStopped) {
            return -1.0;
        }
        return std::chrono::duration<double>(m_watch.zero() - pressed).count();
    }

    Goals& m_goals;
    app::MainWindow& m_window;
    CurrentWatch& m_watch;
};

void benchDialog(StopBench& bench, app::MainWindow& window) {
    QDialog dialog(&window);
    dialog.setModal(true);
    QWidget inner(&dialog);
    Load load;
    load.prepare = [&] {
        dialog.show(); // the last Esc closed it
        return QTest::qWaitForWindowExposed(&dialog);
    };
    bench.run("with a modal dialog open", inner, load);
}

/// All of a short identification, in virtual time and without the window.
Result<app::IdentifyResult> identified(const app::IdentifyConfig& config) {
    auto device = devices::openDevice("sim:htm", {});
    return device ? app::runIdentify(**device, config, {}) : failure(device.error());
}

/// The session's procedure thread fits that motion again and again; Esc ends it as it ends any procedure.
void benchFit(Goals& goals, StopBench& bench, app::MainWindow& window) {
    app::IdentifyConfig config;
    config.given.inertia_kg_m2 = 5.5e-4;
    const auto motion = identified(config);
    if (!motion) {
        return goals.failed("during a fit", motion.error().message);
    }
    app::DeviceSession& session = window.bench().session();
    std::atomic<bool> isFitting = false;
    Load load;
    load.prepare = [&] {
        return session.runProcedure(
                   "fit",
                   [&](devices::Device&, const app::ProcedureObserver& observer) -> Result<void> {
                       while (observer.checkAbort()) {
                           isFitting = true;
                           if (auto fit = app::identifyRecording(motion->recording, config); !fit) {
                               return failure(fit.error());
                           }
                       }
                       isFitting = false;
                       return {};
                   },
                   [](const Result<void>&) {}) &&
               QTest::qWaitFor([&] { return isFitting.load(); }, Patience_ms);
    };
    load.isBusy = [&] { return isFitting.load(); };
    load.end = [&] { (void)QTest::qWaitFor([&] { return session.procedure().isEmpty(); }, Patience_ms); };
    bench.run("during a fit", window, load);
}

/// Ten minutes of twelve signals at 1 kHz, as an export writes them.
Recording longRecording() {
    constexpr std::size_t Rows = 600000;
    constexpr std::size_t Columns = 12;
    StreamLayout layout;
    layout.period_s = 1e-3;
    for (std::size_t column = 0; column < Columns; ++column) {
        layout.columns.push_back({"signal." + std::to_string(column), "A"});
    }
    Recording recording;
    recording.layout = std::make_shared<const StreamLayout>(std::move(layout));
    for (std::size_t row = 0; row < Rows; ++row) {
        recording.time_s.push_back(1e-3 * static_cast<double>(row));
        for (std::size_t column = 0; column < Columns; ++column) {
            recording.values.push_back(1.0 / static_cast<double>(1 + row * Columns + column));
        }
    }
    return recording;
}

/// Everything that writes files at once: the recording of the stream, an export of a long recording on a
/// worker, and the project with long notes, which the window itself saves.
void benchSave(StopBench& bench, app::MainWindow& window, CurrentWatch& watch) {
    const QTemporaryDir folder;
    const auto path = [&](const char* name) { return folder.filePath(name).toStdString(); };
    app::Workbench& workbench = window.bench();
    app::RecorderConfig recorded;
    recorded.path = path("stream.csv");
    recorded.layout.period_s = 1.0 / workbench.liveSignals().rate_Hz();
    for (const std::string& name : workbench.liveSignals().streamed()) {
        recorded.layout.columns.push_back({name, ""});
    }
    const auto recorder = std::make_shared<app::Recorder>(std::move(recorded));
    workbench.session().setBlockSink([recorder, &watch](const TimedBlock& block) {
        recorder->push(block);
        watch.take(*block.block);
    });
    std::atomic<bool> isEnding = false;
    std::thread exporter([&] {
        const Recording recording = longRecording();
        while (!isEnding) {
            (void)devices::writeRecordingFile(path("export.csv"), recording, {});
        }
    });
    app::Project project = window.project().project();
    project.notes = std::string(200000, 'n');
    window.project().update(project);
    QTimer saving;
    QObject::connect(&saving, &QTimer::timeout, &window,
                     [&] { window.project().save(path("project.toml"), [](const Result<void>&) {}); });
    saving.start(10);
    bench.run("during a file save", window, {});
    isEnding = true;
    exporter.join();
    workbench.session().setBlockSink([&watch](const TimedBlock& block) { watch.take(*block.block); });
    window.project().startNew();
}

/// Twelve signals of the device at their full rate, what the watch looks at among them.
std::vector<std::string> twelveSignals(const app::DeviceSession& session) {
    std::vector<std::string> names = {"current_command"};
    for (const SignalSpec& spec : session.catalogue().signals) {
        if (spec.maxRate_Hz >= Rate_Hz && spec.name != names.front() && names.size() < Signals) {
            names.push_back(spec.name);
        }
    }
    return names;
}

/// All of them in four plots over the whole history, with statistics of what is seen.
void plotTwelve(app::MainWindow& window, const std::vector<std::string>& names) {
    app::MonitorView view;
    for (std::size_t first = 0; first < names.size(); first += Signals / 4) {
        app::PlotChoice plot;
        for (std::size_t i = first; i < std::min(first + Signals / 4, names.size()); ++i) {
            plot.signalNames.push_back(names[i]);
        }
        view.plots.push_back(std::move(plot));
    }
    view.span_s = History_s;
    auto* monitor = static_cast<app::MonitorPanel*>(window.docks().panel("monitor"));
    monitor->setView(view);
    for (QAction* action : monitor->findChildren<QAction*>()) {
        if (action->isCheckable() && action->shortcut() == QKeySequence(Qt::Key_S)) {
            action->setChecked(true);
        }
    }
}

/// As fast as this machine simulates it; then in real time again.
bool fillHistory(app::MainWindow& window) {
    constexpr int Longest_ms = 300000;
    constexpr double Hurry_ratio = 100.0;
    app::Workbench& workbench = window.bench();
    workbench.clearHistory();
    workbench.session().setPace({Hurry_ratio});
    const bool isFull = QTest::qWaitFor(
        [&] {
            const auto held = workbench.history().range();
            return held && held->length_s() >= History_s;
        },
        Longest_ms);
    workbench.session().setPace({1.0});
    return isFull;
}

/// Ten minutes of twelve signals in the plots, their statistics, the spectrum and the XY picture in windows
/// of their own, all of them live.
void benchFullLoad(Goals& goals, StopBench& bench, app::MainWindow& window) {
    const std::string name = "while 10 min of 12 signals, statistics, spectrum and XY are drawn";
    const std::vector<std::string> names = twelveSignals(window.bench().session());
    plotTwelve(window, names);
    if (names.size() != Signals || !fillHistory(window)) {
        return goals.failed(name, "the history did not get full");
    }
    for (const char* id : {"spectrum", "xy"}) {
        window.docks().docks().value(QString::fromLatin1(id))->setFloating();
        const QWidget* panel = window.docks().panel(QString::fromLatin1(id));
        if (!QTest::qWaitFor([&] { return panel->isVisible(); }, Patience_ms)) {
            return goals.failed(name, "a picture is not seen");
        }
    }
    bench.run(name, window, {});
    goals.below("the same: rows lost", static_cast<double>(window.bench().history().lostRows()), 1.0, "rows");
}

/// All cases, or only that of the full plotting load.
int run(bool isFullLoadAlone) {
    Goals goals;
    const auto window = openWindow();
    if (!connectMotor(*window)) {
        goals.failed("stop", "the simulated motor could not be connected");
        return goals.exitCode();
    }
    CurrentWatch watch;
    window->bench().session().setBlockSink([&watch](const TimedBlock& block) { watch.take(*block.block); });
    StopBench bench(goals, *window, watch);

    if (!isFullLoadAlone) {
        bench.run("Esc to zero current command on the board while plots draw", *window, {});
        benchDialog(bench, *window);
        benchFit(goals, bench, *window);
        benchSave(bench, *window, watch);
    }
    benchFullLoad(goals, bench, *window);
    window->bench().session().setBlockSink({});
    window->bench().session().disconnectDevice();
    return goals.exitCode();
}

} // namespace
} // namespace halbench::bench

int main(int count, char** arguments) {
    QStandardPaths::setTestModeEnabled(true);
    const halbench::app::WindowApplication application(count, arguments);
    return halbench::bench::run(count > 1 && std::string(arguments[1]) == "full");
}
