#include "app/window/main_window.h"

#include "app/window/dock_layout.h"
#include "app/window/file_dialogs.h"
#include "app/window/help_window.h"
#include "app/window/language.h"
#include "app/window/preferences_dialog.h"
#include "app/window/project_menu.h"
#include "app/window/project_work.h"
#include "app/window/stop_guard.h"
#include "app/window/task_flow.h"
#include "app/window/top_bar.h"
#include "app/window/unkept_bar.h"
#include "app/wizards/calibrate_panel.h"
#include "app/wizards/identify_panel.h"
#include "app/workspaces/arm_button.h"
#include "app/workspaces/device_panel.h"
#include "app/workspaces/link_panel.h"
#include "app/workspaces/monitor_panel.h"
#include "app/workspaces/notes_panel.h"
#include "app/workspaces/return_notice.h"
#include "app/workspaces/tune_panel.h"
#include "widgets/phrasebook.h"
#include "widgets/theme_style.h"

#include <QActionGroup>
#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QMenuBar>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <qtadvanceddocking/DockWidget.h>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr int FramePeriod_ms = 33;
constexpr int AutosavePeriod_ms = 5000;
constexpr QSize FirstSize(1440, 900);

/// Where a project that has no name yet is autosaved.
std::string unnamedProject() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation))
        .filePath("unnamed.toml")
        .toStdString();
}

/// The preferences dialog and the menu choose the same.
void check(const QActionGroup& group, const QVariant& choice) {
    for (QAction* action : group.actions()) {
        action->setChecked(action->data() == choice);
    }
}

} // namespace

MainWindow::MainWindow(Preferences preferences)
    : m_preferences(std::move(preferences)), m_project(unnamedProject()) {
    buildCentre();
    createActions();
    auto* guard = new StopGuard(this);
    connect(guard, &StopGuard::stopRequested, &m_bench.session(), &DeviceSession::stopActuator);
    connect(guard, &StopGuard::escapePressed, this, [this] { noteStop(tr("asked for by Esc")); });
    connect(&m_frame, &QTimer::timeout, &m_bench, &Workbench::drainSamples);
    m_frame.start(FramePeriod_ms);
    connect(&m_project, &ProjectSession::changed, this, &MainWindow::refreshTitle);
    connect(&m_autosave, &QTimer::timeout, this, [this] {
        collectProject();
        m_project.autosave([this](const Result<void>& saved) {
            if (saved) {
                onKept();
            } else {
                sayNotKept(saved.error());
            }
        });
    });
    m_autosave.start(AutosavePeriod_ms);
    m_project.beginWith(shownProject());
    m_devices->setRemembered(m_preferences.lastDevice);
    m_devices->setFocus(); // never STOP first: Enter after the start connects
    resize(FirstSize);
    restoreGeometry(m_preferences.geometry);
    const auto kept =
        std::find_if(std::begin(AllPerspectives), std::end(AllPerspectives),
                     [this](Perspective one) { return perspectiveId(one) == m_preferences.perspective; });
    if (kept != std::end(AllPerspectives)) {
        m_docks->setPerspective(*kept);
    }
}

MainWindow::~MainWindow() {
    m_frame.stop();
    m_project.finishWriting(); // while there is a window to say how it went
    m_bench.session().end();
}

void MainWindow::buildCentre() {
    auto* centre = new QWidget(this);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_bar = new TopBar(m_bench, centre);
    m_bench.setDisplayUnits(m_preferences.units);
    m_bench.stopLatch().setLockOut_ms(m_preferences.stopLockOut_ms);
    m_docks = new DockLayout(m_bench, centre);
    m_devices = static_cast<DevicePanel*>(m_docks->panel("devices"));
    m_notes = static_cast<NotesPanel*>(m_docks->panel("notes"));
    m_message = new widgets::MessageBar(centre);
    connect(m_message, &widgets::MessageBar::actionTriggered, this, [this] {
        const auto remedy = m_remedy; // it may say something else itself
        remedy();
    });
    m_refusal = new widgets::MessageBar(centre);
    connect(m_refusal, &widgets::MessageBar::actionTriggered, this, &MainWindow::closeAnyway);
    connectTaskFlow(*m_docks, m_bench);
    auto* identify = static_cast<IdentifyPanel*>(m_docks->panel("identify"));
    auto* calibrate = static_cast<CalibratePanel*>(m_docks->panel("calibrate"));
    connect(identify, &IdentifyPanel::helpRequested, this, &MainWindow::openHelp);
    connect(calibrate, &CalibratePanel::helpRequested, this, &MainWindow::openHelp);
    m_work = new ProjectWork(m_bench,
                             {*identify, *calibrate, *static_cast<TunePanel*>(m_docks->panel("tune"))}, this);
    m_unkept = new UnkeptBar(centre);
    auto* notice = new ReturnNotice(m_bench, centre);
    for (QWidget* line : std::initializer_list<QWidget*>{m_bar, m_message, m_refusal, m_unkept, notice}) {
        column->addWidget(line);
    }
    column->addWidget(m_docks->widget(), 1);
    column->addWidget(new LinkPanel(m_bench, centre));
    setCentralWidget(centre);
    connect(m_bar, &TopBar::perspectiveChosen, m_docks, &DockLayout::enterPerspective);
    connect(m_bar, &TopBar::consentNeeded, this, &MainWindow::askConsent);
    ConnectButton& connection = m_bar->connection();
    connection.setDevices([this] { return m_devices->devices(); });
    connect(&connection, &ConnectButton::toggleRequested, m_devices, &DevicePanel::toggleConnection);
    connect(&connection, &ConnectButton::deviceChosen, this, &MainWindow::connectDevice);
    connect(m_docks, &DockLayout::stopRequested, &m_bench.session(), &DeviceSession::stopActuator);
    connect(m_docks, &DockLayout::stopRequested, this,
            [this] { noteStop(tr("asked for by STOP of a panel")); });
    connect(m_bar, &TopBar::stopPressed, this, [this] { noteStop(tr("asked for by STOP")); });
    connect(m_docks, &DockLayout::perspectiveChanged, this, &MainWindow::onPerspective);
}

void MainWindow::onPerspective() {
    m_bar->setPerspective(m_docks->perspective());
    m_preferences.perspective = perspectiveId(m_docks->perspective());
}

void MainWindow::connectDevice(const QString& uri) {
    m_devices->setAddress(uri);
    m_devices->connectAddress();
}

void MainWindow::createActions() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    QAction* simulated =
        file->addAction(tr("Connect the s&imulated motor"), this, [this] { connectDevice("sim:htm"); });
    simulated->setShortcut(QKeySequence("Ctrl+Shift+M"));
    const auto allow = [this, simulated] { // a device in use is left by Disconnect only
        simulated->setEnabled(m_bench.session().state() == SessionState::Disconnected);
    };
    connect(&m_bench.session(), &DeviceSession::stateChanged, simulated, allow);
    file->addSeparator();
    m_projects = new ProjectMenu(m_project, fileDialogs(m_bench), this);
    m_projects->addTo(*file);
    connect(m_projects, &ProjectMenu::opened, this, &MainWindow::takeOverProject);
    connect(m_projects, &ProjectMenu::refused, this, [this](const QString& text, const QString& hint) {
        onMessage(widgets::Severity::Error, text, hint);
    });
    connect(m_projects, &ProjectMenu::recovered, this, [this](const QString& text, const QString& hint) {
        onMessage(widgets::Severity::Information, text, hint);
    });
    connect(m_projects, &ProjectMenu::collecting, this, &MainWindow::collectProject);
    connect(m_projects, &ProjectMenu::locked, this, &MainWindow::offerCopy);
    connect(m_projects, &ProjectMenu::unkept, m_unkept, &UnkeptBar::showError);
    for (auto signal : {&ProjectMenu::opened, &ProjectMenu::saved}) {
        connect(m_projects, signal, m_unkept, &QWidget::hide);
    }
    connect(m_unkept, &UnkeptBar::tryAgainRequested, m_projects, &ProjectMenu::tryAgain);
    connect(m_unkept, &UnkeptBar::saveAsRequested, m_projects, &ProjectMenu::saveAs);
    connect(m_unkept, &UnkeptBar::discardRequested, m_projects, &ProjectMenu::discard);
    connect(m_unkept, &UnkeptBar::stayRequested, m_projects, &ProjectMenu::stay);
    connect(m_projects, &ProjectMenu::saved, this, &MainWindow::onKept);
    connect(&m_project, &ProjectSession::notKept, this, [this](const Error& error) {
        onMessage(widgets::Severity::Error, widgets::inWords(error.message), widgets::inWords(error.hint));
    });
    file->addSeparator();
    QAction* preferences = file->addAction(tr("&Preferences…"), this, &MainWindow::askPreferences);
    preferences->setShortcut(QKeySequence("Ctrl+,"));
    file->addSeparator();
    QAction* quit = file->addAction(tr("&Quit"), this, &QWidget::close);
    quit->setShortcut(QKeySequence::Quit);
    createViewMenu();
    createHelpMenu();
}

void MainWindow::createViewMenu() {
    QMenu* view = menuBar()->addMenu(tr("&View"));
    for (ads::CDockWidget* dock : m_docks->docks()) {
        view->addAction(dock->toggleViewAction());
    }
    view->addSeparator();
    view->addAction(tr("&Reset the arrangement"), m_docks, &DockLayout::reset);
    view->addSeparator();
    QMenu* themes = view->addMenu(tr("&Theme"));
    m_themes = new QActionGroup(this);
    const std::pair<ThemeChoice, QString> choices[] = {{ThemeChoice::System, tr("&System")},
                                                       {ThemeChoice::Light, tr("&Light")},
                                                       {ThemeChoice::Dark, tr("&Dark")}};
    for (const auto& [choice, title] : choices) {
        QAction* action = themes->addAction(title, this, [this, choice = choice] { chooseTheme(choice); });
        action->setCheckable(true);
        action->setData(static_cast<int>(choice));
        m_themes->addAction(action);
    }
    check(*m_themes, static_cast<int>(m_preferences.theme));
    createLanguageMenu(*view->addMenu(tr("Lan&guage")));
}

void MainWindow::createLanguageMenu(QMenu& menu) {
    m_languages = new QActionGroup(this);
    const auto add = [&](const QString& title, const QString& id) {
        QAction* action = menu.addAction(title, this, [this, id] { chooseLanguage(id); });
        action->setCheckable(true);
        action->setData(id);
        m_languages->addAction(action);
    };
    add(tr("&System"), {});
    for (const Language& language : languages()) {
        add(language.name, language.id);
    }
    check(*m_languages, m_preferences.language);
}

void MainWindow::createHelpMenu() {
    QMenu* help = menuBar()->addMenu(tr("&Help"));
    help->addAction(tr("&First steps"), this, [this] { openHelp("index.md"); });
    QAction* onPanel = help->addAction(tr("&Help on this panel"), this, &MainWindow::showHelp);
    onPanel->setShortcut(QKeySequence::HelpContents);
}

void MainWindow::chooseTheme(ThemeChoice choice) {
    m_preferences.theme = choice;
    check(*m_themes, static_cast<int>(choice));
    if (const Result<widgets::Theme> theme = widgets::loadTheme(themeName(choice).toStdString())) {
        widgets::applyTheme(*qApp, *theme, {QLocale(), widgets::Dress().fontSize_pt});
    }
    savePreferences(m_preferences);
}

void MainWindow::chooseLanguage(const QString& id) {
    m_preferences.language = id;
    check(*m_languages, id);
    savePreferences(m_preferences);
    onMessage(widgets::Severity::Information, tr("The language changes at the next start."), {});
}

void MainWindow::askPreferences() {
    PreferencesDialog dialog(m_preferences, m_bench, this);
    if (dialog.exec() == QDialog::Accepted) {
        usePreferences(dialog.chosen());
    }
}

void MainWindow::usePreferences(const Preferences& chosen) {
    m_preferences.stopLockOut_ms = chosen.stopLockOut_ms;
    m_bench.stopLatch().setLockOut_ms(chosen.stopLockOut_ms);
    m_preferences.units = chosen.units;
    m_bench.setDisplayUnits(chosen.units);
    if (chosen.language != m_preferences.language) {
        chooseLanguage(chosen.language);
    }
    chooseTheme(chosen.theme);
}

void MainWindow::showHelp() {
    const QString page = m_docks->helpPageOf(QApplication::focusWidget());
    openHelp(page.isEmpty() ? QString("index.md") : page);
}

void MainWindow::openHelp(const QString& page) {
    auto* window = new HelpWindow(page, this);
    window->setAttribute(Qt::WA_DeleteOnClose);
    connect(window, &HelpWindow::stopRequested, &m_bench.session(), &DeviceSession::stopActuator);
    connect(window, &HelpWindow::stopRequested, this,
            [this] { noteStop(tr("asked for by STOP of the help")); });
    window->show();
}

/// The stop itself is on its way already; what the board made of it follows in the log.
void MainWindow::noteStop(const QString& who) {
    const SessionState state = m_bench.session().state();
    if (state == SessionState::Connected || state == SessionState::Reconnecting) {
        m_bench.session().message(MessageLevel::Warning, tr("stop"), who);
    }
}

void MainWindow::onMessage(widgets::Severity severity, const QString& text, const QString& hint) {
    say({severity, text, hint, {}}, {});
}

void MainWindow::say(const widgets::Message& message, std::function<void()> remedy) {
    m_isNotKept = false;
    m_remedy = std::move(remedy);
    m_message->showMessage(message);
}

/// The question goes with its device: consent is never taken over to another one.
void MainWindow::askConsent() {
    say(armingWarning(), [this] {
        m_message->clear();
        m_bench.drive().giveConsent();
        m_bench.drive().arm();
    });
    const auto asked = std::make_shared<QMetaObject::Connection>();
    *asked = connect(&m_bench.session(), &DeviceSession::stateChanged, this, [this, asked] {
        disconnect(*asked);
        if (m_message->message().text == armingWarning().text) {
            m_message->clear();
        }
    });
}

} // namespace halbench::app
