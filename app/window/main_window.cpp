#include "app/window/main_window.h"

#include "app/window/dock_layout.h"
#include "app/window/help_window.h"
#include "app/window/stop_guard.h"
#include "app/window/top_bar.h"
#include "app/workspaces/device_panel.h"
#include "app/workspaces/link_panel.h"
#include "widgets/theme_style.h"

#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QMenuBar>
#include <QVBoxLayout>
#include <qtadvanceddocking/DockWidget.h>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr int FramePeriod_ms = 33;
constexpr QSize FirstSize(1440, 900);

} // namespace

MainWindow::MainWindow(Preferences preferences) : m_preferences(std::move(preferences)) {
    setWindowTitle(tr("Halbench"));
    buildCentre();
    createActions();
    auto* guard = new StopGuard(this);
    connect(guard, &StopGuard::stopRequested, &m_bench.session(), &DeviceSession::stopActuator);
    connect(&m_frame, &QTimer::timeout, &m_bench, &Workbench::drainSamples);
    m_frame.start(FramePeriod_ms);
    findChild<DevicePanel*>()->setFocus(); // never STOP first: Enter after the start connects
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
    m_bench.session().disconnectDevice();
}

void MainWindow::buildCentre() {
    auto* centre = new QWidget(this);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_bar = new TopBar(m_bench, centre);
    m_bar->setStopLockOut_ms(m_preferences.stopLockOut_ms);
    m_docks = new DockLayout(m_bench, centre);
    column->addWidget(m_bar);
    column->addWidget(m_docks->widget(), 1);
    column->addWidget(new LinkPanel(m_bench, centre));
    setCentralWidget(centre);
    connect(m_bar, &TopBar::perspectiveChosen, m_docks, &DockLayout::setPerspective);
    connect(m_docks, &DockLayout::perspectiveChanged, this, &MainWindow::onPerspective);
}

void MainWindow::onPerspective() {
    m_bar->setPerspective(m_docks->perspective());
    m_preferences.perspective = perspectiveId(m_docks->perspective());
}

void MainWindow::connectDevice(const QString& uri) {
    auto* panel = findChild<DevicePanel*>();
    panel->setAddress(uri);
    panel->connectAddress();
}

void MainWindow::createActions() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    QAction* simulated =
        file->addAction(tr("Connect the &simulated motor"), this, [this] { connectDevice("sim:htm"); });
    simulated->setShortcut(QKeySequence("Ctrl+Shift+S"));
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
    auto* group = new QActionGroup(this);
    const std::pair<ThemeChoice, QString> choices[] = {{ThemeChoice::System, tr("&System")},
                                                       {ThemeChoice::Light, tr("&Light")},
                                                       {ThemeChoice::Dark, tr("&Dark")}};
    for (const auto& [choice, title] : choices) {
        QAction* action = themes->addAction(title, this, [this, choice = choice] { chooseTheme(choice); });
        action->setCheckable(true);
        action->setChecked(choice == m_preferences.theme);
        group->addAction(action);
    }
}

void MainWindow::createHelpMenu() {
    QMenu* help = menuBar()->addMenu(tr("&Help"));
    QAction* contents = help->addAction(tr("&Help on this panel"), this, &MainWindow::showHelp);
    contents->setShortcut(QKeySequence::HelpContents);
}

void MainWindow::chooseTheme(ThemeChoice choice) {
    m_preferences.theme = choice;
    if (const Result<widgets::Theme> theme = widgets::loadTheme(themeName(choice).toStdString())) {
        widgets::applyTheme(*qApp, *theme, {QLocale(), widgets::Dress().fontSize_pt});
    }
    savePreferences(m_preferences);
}

void MainWindow::showHelp() {
    const QString page = m_docks->helpPageOf(QApplication::focusWidget());
    auto* window = new HelpWindow(page.isEmpty() ? QString("index.md") : page, this);
    window->setAttribute(Qt::WA_DeleteOnClose);
    window->show();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    m_preferences.geometry = saveGeometry();
    m_preferences.lastDevice = QString::fromStdString(m_bench.session().info().uri);
    savePreferences(m_preferences);
    QMainWindow::closeEvent(event);
}

} // namespace halbench::app
