#include "app/window/main_window.h"

#include "app/window/docks/arrangement_notice.h"
#include "app/window/docks/dock_layout.h"
#include "app/window/docks/panel_needs.h"
#include "app/window/docks/panel_toggle.h"
#include "app/window/docks/perspective_bar.h"
#include "app/window/file_dialogs.h"
#include "app/window/file_drop.h"
#include "app/window/focus_fallback.h"
#include "app/window/frame_clock.h"
#include "app/window/help/help_window.h"
#include "app/window/panel_connections.h"
#include "app/window/preferences/language.h"
#include "app/window/preferences/preferences_dialog.h"
#include "app/window/preferences/recording_place.h"
#include "app/window/preferences/recording_tidying.h"
#include "app/window/project/project_menu.h"
#include "app/window/project/project_work.h"
#include "app/window/project/unsaved_bar.h"
#include "app/window/return_key.h"
#include "app/window/start/recent_lists.h"
#include "app/window/start/sample_files.h"
#include "app/window/start/sample_list.h"
#include "app/window/stop_guard.h"
#include "app/window/top_bar.h"
#include "app/window/tour/tour.h"
#include "app/wizards/calibrate_panel.h"
#include "app/wizards/identify_panel.h"
#include "app/workspaces/device/device_panel.h"
#include "app/workspaces/device/link_panel.h"
#include "app/workspaces/device/log_panel.h"
#include "app/workspaces/device/notes_panel.h"
#include "app/workspaces/device/return_notice.h"
#include "app/workspaces/drive/arm_button.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "app/workspaces/recordings/recordings_panel.h"
#include "app/workspaces/tune/tune_panel.h"
#include "devices/history/page_file.h"
#include "widgets/controls/floating_rows.h"
#include "widgets/controls/wheel_guard.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QActionGroup>
#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QMenuBar>
#include <QScreen>
#include <QScrollArea>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <qtadvanceddocking/DockWidget.h>

#include <algorithm>
#include <utility>

namespace halbench::app {

namespace {

constexpr int AutosavePeriod_ms = 5000;
constexpr QSize FirstSize(1440, 900);
constexpr QSize LeastDockRoom(320, 160);

/// Where a project that has no name yet is autosaved.
std::string unnamedProject() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation))
        .filePath("unnamed.toml")
        .toStdString();
}

/// Of samples that memory has no room for.
std::shared_ptr<devices::PageFile> historyPagesOf(int limit_GB) {
    devices::PageFileConfig config;
    config.limit_bytes = static_cast<std::uint64_t>(limit_GB) * BytesPerGB;
    config.folder = QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation))
                        .filePath("history")
                        .toStdString();
    return std::make_shared<devices::PageFile>(std::move(config));
}

/// The docks, which scroll where their panels need more than the window has: a window that grew with them
/// would leave the screen, and STOP with it.
class DockRoom : public QScrollArea {
public:
    DockRoom(QWidget& docks, QWidget* parent) : QScrollArea(parent) {
        setWidget(&docks);
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus);
    }
    QSize minimumSizeHint() const override { return LeastDockRoom; }
};

} // namespace

MainWindow::MainWindow(Preferences preferences)
    : m_preferences(std::move(preferences)), m_historyPages(historyPagesOf(m_preferences.historyLimit_GB)),
      m_frame(new FrameClock(*this)) {
    m_bench.setHistoryPages(m_historyPages);
    auto* place = new RecordingPlace(m_bench, this); // before the panels, which show it
    connect(this, &MainWindow::furnished, place, &RecordingPlace::tell);
    new widgets::WheelGuard(this); // before the fields
    buildCentre();
    createMenus();
    auto* guard = new StopGuard(this);
    connect(guard, &StopGuard::stopRequested, &m_bench.session(), &DeviceSession::stopActuator);
    guard->setNothingToStop([this] { return m_bench.drive().isNothingToStop(); });
    connect(guard, &StopGuard::escapePressed, this, [this] { noteStop(tr("by Esc")); });
    new ReturnKey(this);
    connect(m_frame, &QTimer::timeout, &m_bench, &Workbench::drainSamples);
    m_frame->start();
    connect(&m_autosave, &QTimer::timeout, this, &MainWindow::autosave);
    new FocusFallback(*m_docks->widget(), this);
    m_docks->widget()->setFocus(); // never STOP first
    setWindowTitle(QStringLiteral("Halbench"));
    resize(FirstSize);
    if (restoreGeometry(m_preferences.geometry)) {
        fitScreen();
    }
    usePreferredPerspective();
}

/// A place that was kept on another display, or at another scale, may reach beyond this one; STOP with it.
void MainWindow::fitScreen() {
    const QRect room = screen()->availableGeometry();
    if (isMaximized() || isFullScreen() || room.contains(geometry())) {
        return;
    }
    resize(size().boundedTo(room.size()));
    const int left = std::clamp(x(), room.left(), std::max(room.left(), room.right() + 1 - width()));
    const int top = std::clamp(y(), room.top(), std::max(room.top(), room.bottom() + 1 - height()));
    move(left, top);
}

void MainWindow::usePreferredPerspective() {
    if (const auto kept = perspectiveOf(m_preferences.perspective)) {
        m_docks->setPerspective(*kept);
    }
}

MainWindow::~MainWindow() {
    m_frame->stop();
    m_bench.session().end(); // first: a slow disk must not keep it armed
    if (m_project) {
        m_project->finishWriting(); // while there is a window to say how it went
    }
    hide(); // panels that are hidden say which signals they need no more, to a bench that is still there
    for (const ads::CDockWidget* dock : m_docks->docks()) {
        dock->window()->hide(); // one of its own does not go with this one
    }
}

void MainWindow::setVisible(bool isVisible) {
    if (isVisible) {
        furnish();
    }
    QMainWindow::setVisible(isVisible);
}

void MainWindow::furnish() {
    if (std::exchange(m_isFurnished, true)) {
        return;
    }
    m_project = std::make_unique<ProjectSession>(unnamedProject());
    connect(m_project.get(), &ProjectSession::changed, this, &MainWindow::refreshTitle);
    widgets::buildUndressed(*qApp, [this] { m_docks->furnish(m_bench); });
    m_devices = static_cast<DevicePanel*>(m_docks->panel("devices"));
    m_notes = static_cast<NotesPanel*>(m_docks->panel("notes"));
    connectPanels();
    fillMenus();
    createStartPage();
    connectDrops();
    m_project->beginWith(shownProject());
    m_autosave.start(AutosavePeriod_ms);
    m_devices->setRemembered(m_preferences.lastDevice);
    connect(&m_bench.session(), &DeviceSession::stateChanged, this, &MainWindow::keepLastDevice);
    connect(&m_bench.session(), &DeviceSession::stateChanged, this, &MainWindow::leaveConnection);
    connect(&m_bench.session(), &DeviceSession::stateChanged, this, &MainWindow::followDevice);
    connect(m_docks, &DockLayout::offerChanged, this, &MainWindow::followOffer);
    m_devices->setFocus(); // Enter after the start connects
    furnished();
}

/// What stands beside the plots and below them is folded at first: a key or a button each.
void MainWindow::createPanelKeys() {
    const QList<QAction*> actions = {
        makePanelToggle(*m_docks, QStringLiteral("signals"), QKeySequence(QStringLiteral("F6"))),
        makePanelToggle(*m_docks, QStringLiteral("drive"), QKeySequence(QStringLiteral("F7"))),
        makePanelToggle(*m_docks, QStringLiteral("parameters"), QKeySequence(QStringLiteral("F8")))};
    addActions(actions);
    static_cast<MonitorPanel*>(m_docks->panel("monitor"))->addToolsAhead(actions);
    QAction* log = makePanelToggle(*m_docks, QStringLiteral("log"), QKeySequence(QStringLiteral("F9")));
    addAction(log);
    connect(m_link, &LinkPanel::logRequested, log, &QAction::trigger);
    auto* panel = static_cast<LogPanel*>(m_docks->panel("log"));
    connect(panel, &LogPanel::said, m_link, &LinkPanel::showLine);
    connect(panel, &LogPanel::said, m_docks, [docks = m_docks](MessageLevel level) {
        if (level == MessageLevel::Warning || level == MessageLevel::Error) {
            docks->unfold(QStringLiteral("log"));
        }
    });
}

/// The plots, the state and STOP; everything else comes back as it was.
void MainWindow::showPlotsOnly(bool isOnly) {
    if (isOnly) {
        m_docks->setPerspective(Perspective::Monitor);
    }
    m_docks->setMainOnly(isOnly);
}

/// Beside the devices, which are shown until one is connected.
void MainWindow::createStartPage() {
    auto* recent = new RecentLists(m_bench, sampleFolder(), m_devices);
    auto* samples = new SampleList(m_devices);
    m_devices->addPart(*recent);
    m_devices->addPart(*samples);
    connect(recent, &RecentLists::projectChosen, m_projects, &ProjectMenu::open);
    connect(recent, &RecentLists::recordingChosen, this, &MainWindow::openRecording);
    connect(samples, &SampleList::recordingChosen, this, &MainWindow::openRecording);
    connect(samples, &SampleList::tourRequested, m_tour, &Tour::start);
}

void MainWindow::openRecording(const QString& path) {
    m_docks->setPerspective(Perspective::Record);
    static_cast<RecordingsPanel*>(m_docks->panel("recordings"))->open(path);
}

void MainWindow::connectDrops() {
    auto* drop = new FileDrop(*this);
    connect(drop, &FileDrop::projectDropped, m_projects, &ProjectMenu::open);
    connect(drop, &FileDrop::recordingDropped, this, &MainWindow::openRecording);
    connect(drop, &FileDrop::refused, this, [this](const QString& text, const QString& hint) {
        onMessage(widgets::Severity::Error, text, hint);
    });
}

void MainWindow::connectPanels() {
    connectPanelConnections(*m_docks, m_bench);
    createPanelKeys();
    auto* identify = static_cast<IdentifyPanel*>(m_docks->panel("identify"));
    auto* calibrate = static_cast<CalibratePanel*>(m_docks->panel("calibrate"));
    connect(identify, &IdentifyPanel::helpRequested, this, &MainWindow::openHelp);
    connect(calibrate, &CalibratePanel::helpRequested, this, &MainWindow::openHelp);
    auto* tune = static_cast<TunePanel*>(m_docks->panel("tune"));
    connect(tune, &TunePanel::gainsLeft, this, &MainWindow::sayGainsLeft);
    m_tidying = new RecordingTidying(m_bench, this);
    connect(m_tidying, &RecordingTidying::withheld, this, &MainWindow::sayWithheld);
    useRecordingPreferences();
    m_work = new ProjectWork(m_bench, {*identify, *calibrate, *tune}, this);
}

/// Whichever perspective is shown: it went with its device, and nothing asked.
void MainWindow::sayGainsLeft(const QString& text, const QString& remedy, const QString& design) {
    say({widgets::Severity::Information, text, remedy, tr("Use them")}, [this, design] {
        m_message->clear();
        m_docks->setPerspective(Perspective::Tune);
        static_cast<TunePanel*>(m_docks->panel("tune"))->takeUpDesign(design.toStdString());
    });
}

void MainWindow::buildCentre() {
    auto* centre = new QWidget(this);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_bar = new TopBar(m_bench, centre);
    m_bench.setDisplayUnits(m_preferences.units);
    m_bench.stopLatch().setLockOut_ms(m_preferences.stopLockOut_ms);
    m_docks = new DockLayout(centre);
    m_message = new widgets::MessageBar(centre);
    m_message->setObjectName(QStringLiteral("window_message"));
    connect(m_message, &widgets::MessageBar::actionTriggered, this, [this] {
        const auto remedy = m_remedy; // it may say something else itself
        remedy();
    });
    m_refusal = new widgets::MessageBar(centre);
    connect(m_refusal, &widgets::MessageBar::actionTriggered, this, &MainWindow::closeAnyway);
    m_unkept = new UnsavedBar(centre);
    auto* notice = new ReturnNotice(m_bench, centre);
    auto* arrangement = new ArrangementNotice(*m_docks, centre);
    column->addWidget(m_bar);
    auto* room = new DockRoom(*m_docks->widget(), centre);
    column->addWidget(room, 1);
    auto* banners = new widgets::FloatingRows(*room, Qt::BottomEdge, centre);
    for (QWidget* row :
         std::initializer_list<QWidget*>{m_message, m_refusal, m_unkept, arrangement, notice}) {
        banners->addRow(*row);
    }
    m_link = new LinkPanel(m_bench, centre);
    column->addWidget(m_link);
    setCentralWidget(centre);
    connect(m_bar, &TopBar::perspectiveChosen, m_docks, &DockLayout::enterPerspective);
    connect(m_bar, &TopBar::consentNeeded, this, &MainWindow::askConsent);
    ConnectButton& connection = m_bar->connection();
    connection.setDevices([this] {
        furnish();
        return m_devices->devices();
    });
    connect(&connection, &ConnectButton::toggleRequested, this, [this] {
        furnish();
        m_devices->toggleConnection();
    });
    connect(&connection, &ConnectButton::deviceChosen, this, &MainWindow::connectDevice);
    connect(m_docks, &DockLayout::stopRequested, &m_bench.session(), &DeviceSession::stopActuator);
    connect(m_docks, &DockLayout::stopRequested, this, [this] { noteStop(tr("by STOP of a panel window")); });
    connect(m_bar, &TopBar::stopPressed, this, [this] { noteStop(tr("by STOP")); });
    connect(m_docks, &DockLayout::perspectiveChanged, this, &MainWindow::onPerspective);
}

void MainWindow::onPerspective() {
    m_bar->setPerspective(m_docks->perspective());
    m_preferences.perspective = perspectiveId(m_docks->perspective());
}

/// One that is lost may come back, and one that is being left is there yet.
void MainWindow::followDevice() {
    const DeviceSession& session = m_bench.session();
    m_docks->setDeviceOpen(session.state() != SessionState::Disconnected &&
                           session.state() != SessionState::Connecting);
    if (session.state() == SessionState::Connected) {
        m_docks->setAbsent(absentPanels(session.info(), session.catalogue()));
    } else if (session.state() == SessionState::Disconnected) {
        m_docks->setAbsent({});
    }
}

void MainWindow::followOffer() {
    for (const Perspective perspective : AllPerspectives) {
        m_bar->perspectives().setOffered(perspective, m_docks->isOffered(perspective));
    }
    m_bar->setOffered(m_docks->isOffered(QStringLiteral("drive")),
                      m_docks->isOffered(QStringLiteral("record")));
    m_editMenu->menuAction()->setVisible(m_docks->isOffered(Perspective::Tune)); // the gains' history
}

/// At once, so that a crash does not forget it.
void MainWindow::keepLastDevice() {
    if (m_bench.session().state() == SessionState::Connected &&
        m_preferences.lastDevice != m_devices->remembered()) {
        m_preferences.lastDevice = m_devices->remembered();
        savePreferences(m_preferences);
    }
}

/// What connected disconnects from now on: the focus goes on to the signals, or where no key does anything.
void MainWindow::leaveConnection() {
    QWidget* focus = focusWidget();
    const bool isThere = focus == nullptr || focus == &m_bar->connection() || m_devices->isAncestorOf(focus);
    if (m_bench.session().state() != SessionState::Connected || !isThere) {
        return;
    }
    QWidget* signalList = m_docks->panel("signals");
    (signalList->isVisible() ? signalList : m_docks->widget())->setFocus(Qt::OtherFocusReason);
}

void MainWindow::connectDevice(const QString& uri) {
    furnish();
    m_devices->setAddress(uri);
    m_devices->connectAddress();
}

void MainWindow::showHelp() {
    const QString address = m_docks->helpAddressOf(QApplication::focusWidget());
    openHelp(address.isEmpty() ? QString("index.md") : address);
}

void MainWindow::openHelp(const QString& address) {
    auto* window = new HelpWindow(address, this);
    window->setAttribute(Qt::WA_DeleteOnClose);
    window->setNothingToStop([this] { return m_bench.drive().isNothingToStop(); });
    connect(window, &HelpWindow::stopRequested, &m_bench.session(), &DeviceSession::stopActuator);
    connect(window, &HelpWindow::stopRequested, this, [this] { noteStop(tr("by STOP of the help window")); });
    window->show();
}

/// The stop itself is on its way already; what the board made of it follows in the log.
void MainWindow::noteStop(const QString& by) {
    const SessionState state = m_bench.session().state();
    if (state == SessionState::Connected || state == SessionState::Reconnecting) {
        m_bench.setStopAsker(by);
        m_bench.session().message(MessageLevel::Warning, tr("stop"), tr("requested %1").arg(by));
    }
}

void MainWindow::onMessage(widgets::Severity severity, const QString& text, const QString& hint) {
    say({severity, text, hint, {}}, {});
}

void MainWindow::say(const widgets::Message& message, std::function<void()> remedy) {
    m_isNotKept = false;
    m_isProjectRefused = false;
    m_remedy = std::move(remedy);
    m_message->showMessage(message);
}

/// The question goes with its device: consent is never taken over to another one.
void MainWindow::askConsent() {
    DriveControl& drive = m_bench.drive();
    say(armingWarning(), [&drive] {
        drive.giveConsent();
        drive.arm();
    });
    auto* asked = new QObject(this); // as long as the question stands
    connect(m_message, &widgets::MessageBar::dismissed, asked, [&drive] { drive.dismissConsent(); });
    connect(&drive, &DriveControl::consentSettled, asked, [this, asked] {
        asked->deleteLater();
        if (m_message->message().text == armingWarning().text) {
            m_message->clear();
        }
    });
}

} // namespace halbench::app
