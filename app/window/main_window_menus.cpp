// The menus of the window, and what is chosen there.
#include "app/window/docks/dock_layout.h"
#include "app/window/docks/dock_menu.h"
#include "app/window/docks/panels.h"
#include "app/window/file_dialogs.h"
#include "app/window/help/about_dialog.h"
#include "app/window/help/shortcut_list.h"
#include "app/window/main_window.h"
#include "app/window/preferences/language.h"
#include "app/window/preferences/preferences_dialog.h"
#include "app/window/preferences/recording_tidying.h"
#include "app/window/project/project_menu.h"
#include "app/window/project/unsaved_bar.h"
#include "app/window/top_bar.h"
#include "app/window/tour/tour.h"
#include "app/workspaces/device/link_panel.h"
#include "app/workspaces/recordings/recordings_panel.h"
#include "app/workspaces/tune/tune_panel.h"
#include "devices/history/page_file.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QAbstractButton>
#include <QActionGroup>
#include <QApplication>
#include <QDir>
#include <QMenuBar>
#include <qtadvanceddocking/DockWidget.h>

namespace halbench::app {

namespace {

/// The preferences dialog and the menu choose the same.
void check(const QActionGroup& group, const QVariant& choice) {
    for (QAction* action : group.actions()) {
        action->setChecked(action->data() == choice);
    }
}

} // namespace

/// Their titles only: what they hold is made with the panels.
void MainWindow::createMenus() {
    m_fileMenu = menuBar()->addMenu(tr("&File"));
    m_editMenu = menuBar()->addMenu(tr("&Edit"));
    m_viewMenu = menuBar()->addMenu(tr("&View"));
    m_helpMenu = menuBar()->addMenu(tr("&Help"));
}

void MainWindow::fillMenus() {
    fillFileMenu();
    fillEditMenu();
    fillViewMenu();
    fillHelpMenu();
}

void MainWindow::fillFileMenu() {
    QAction* simulated =
        m_fileMenu->addAction(tr("Connect the s&imulated motor"), this, [this] { connectDevice("sim:htm"); });
    simulated->setShortcut(QKeySequence("Ctrl+Shift+M"));
    const auto allow = [this, simulated] { // a device in use is left by Disconnect only
        simulated->setEnabled(m_bench.session().state() == SessionState::Disconnected);
    };
    connect(&m_bench.session(), &DeviceSession::stateChanged, simulated, allow);
    m_fileMenu->addSeparator();
    createProjects();
    m_projects->addTo(*m_fileMenu);
    m_fileMenu->addSeparator();
    QAction* import = m_fileMenu->addAction(tr("Import da&ta (CSV)…"), this, [this] {
        m_docks->setPerspective(Perspective::Record);
        static_cast<RecordingsPanel*>(m_docks->panel("recordings"))->importTable();
    });
    import->setShortcut(QKeySequence("Ctrl+I"));
    m_fileMenu->addSeparator();
    QAction* preferences = m_fileMenu->addAction(tr("&Preferences…"), this, &MainWindow::askPreferences);
    preferences->setShortcut(QKeySequence("Ctrl+,"));
    m_fileMenu->addSeparator();
    QAction* quit = m_fileMenu->addAction(tr("&Quit"), this, &QWidget::close);
    quit->setShortcut(QKeySequence::Quit);
}

void MainWindow::createProjects() {
    m_projects = new ProjectMenu(*m_project, fileDialogs(m_bench), this);
    m_projects->setBusy([&session = m_bench.session()] {
        const bool isConnected = session.state() != SessionState::Disconnected;
        return isConnected && (session.report().board.isArmed || !session.procedure().isEmpty());
    });
    connect(m_projects, &ProjectMenu::opened, this, &MainWindow::takeOverProject);
    connect(m_projects, &ProjectMenu::refused, this, [this](const QString& text, const QString& hint) {
        onMessage(widgets::Severity::Error, text, hint);
        m_isProjectRefused = true;
    });
    connect(m_projects, &ProjectMenu::recovered, this, [this](const QString& text, const QString& hint) {
        onMessage(widgets::Severity::Information, text, hint);
    });
    connect(m_projects, &ProjectMenu::collecting, this, &MainWindow::collectProject);
    connect(m_projects, &ProjectMenu::locked, this, &MainWindow::offerCopy);
    connect(m_projects, &ProjectMenu::unkept, m_unkept, &UnsavedBar::showError);
    for (auto signal : {&ProjectMenu::opened, &ProjectMenu::saved}) {
        connect(m_projects, signal, m_unkept, &QWidget::hide);
    }
    connect(m_unkept, &UnsavedBar::tryAgainRequested, m_projects, &ProjectMenu::tryAgain);
    connect(m_unkept, &UnsavedBar::saveAsRequested, m_projects, &ProjectMenu::saveAs);
    connect(m_unkept, &UnsavedBar::discardRequested, m_projects, &ProjectMenu::discard);
    connect(m_unkept, &UnsavedBar::stayRequested, m_projects, &ProjectMenu::stay);
    connect(m_projects, &ProjectMenu::saved, this, [this] {
        m_bench.session().message(MessageLevel::Info, tr("project"),
                                  tr("saved: %1").arg(QString::fromStdString(m_project->path())));
        onKept();
    });
    connect(m_project.get(), &ProjectSession::notKept, this, [this](const Error& error) {
        onMessage(widgets::Severity::Error, widgets::inWords(error.message), widgets::inWords(error.hint));
    });
}

/// Of the proposed gains; it says which change, whatever perspective is shown. Lists and tables have their
/// own.
void MainWindow::fillEditMenu() {
    m_editMenu->addActions(static_cast<TunePanel*>(m_docks->panel("tune"))->historyActions());
}

void MainWindow::fillViewMenu() {
    for (const PanelSpec& panel : panelSpecs()) { // the docks themselves have another order at each start
        QAction* action =
            m_viewMenu->addAction(panel.title, this, [this, id = panel.id] { m_docks->raise(id); });
        connect(m_docks, &DockLayout::offerChanged, action,
                [this, action, id = panel.id] { action->setVisible(m_docks->isOffered(id)); });
    }
    m_viewMenu->addSeparator();
    QAction* plotsOnly = m_viewMenu->addAction(tr("&Plots and STOP only"));
    plotsOnly->setCheckable(true);
    plotsOnly->setShortcut(QKeySequence(QStringLiteral("F11")));
    addAction(plotsOnly); // its key works while the menus are hidden
    connect(plotsOnly, &QAction::triggered, this, &MainWindow::showPlotsOnly);
    connect(m_docks, &DockLayout::mainOnlyChanged, this, [this, plotsOnly] {
        const bool isOnly = m_docks->isMainOnly();
        plotsOnly->setChecked(isOnly);
        menuBar()->setVisible(!isOnly);
        m_link->setVisible(!isOnly);
        m_bar->setStateOnly(isOnly);
    });
    m_viewMenu->addMenu(new DockMenu(*m_docks, m_viewMenu));
    m_viewMenu->addAction(tr("&Reset layout"), m_docks, &DockLayout::reset);
    m_viewMenu->addSeparator();
    QMenu* themes = m_viewMenu->addMenu(tr("&Theme"));
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
    createLanguageMenu(*m_viewMenu->addMenu(tr("Lan&guage")));
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

void MainWindow::fillHelpMenu() {
    m_helpMenu->addAction(tr("&First steps"), this, [this] { openHelp("index.md"); });
    m_tour = new Tour(*this, *m_docks, m_bench.session());
    m_tour->addTo(*m_helpMenu);
    QAction* onPanel = m_helpMenu->addAction(tr("&Help on this panel"), this, &MainWindow::showHelp);
    onPanel->setShortcut(QKeySequence::HelpContents);
    QAction* keys = m_helpMenu->addAction(tr("&Keyboard shortcuts"), this, &MainWindow::showShortcuts);
    keys->setShortcut(QKeySequence(QStringLiteral("Ctrl+F1")));
    m_helpMenu->addSeparator();
    m_helpMenu->addAction(tr("&About Halbench"), this, [this] { openDialog(new AboutDialog(this)); });
}

/// The dialog does not hold up the window; it goes when it is closed.
template <typename Dialog>
void MainWindow::openDialog(Dialog* dialog) {
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &Dialog::stopRequested, &m_bench.session(), &DeviceSession::stopActuator);
    connect(dialog, &Dialog::stopRequested, this, [this] { noteStop(tr("by STOP of a dialog")); });
    dialog->show();
}

/// Of the window, then of each panel in the order of the View menu.
void MainWindow::showShortcuts() {
    QList<QAction*> own = actions() + m_bar->findChildren<QAction*>();
    for (const QMenu* menu : {m_fileMenu, m_editMenu, m_viewMenu, m_helpMenu}) {
        own << menu->actions();
    }
    std::vector<ShortcutRow> rows{{tr("Esc"), tr("Stop the actuator"), tr("Window")}};
    const auto add = [&rows](const std::vector<ShortcutRow>& more) {
        rows.insert(rows.end(), more.begin(), more.end());
    };
    add(shortcutRows(own, tr("Window")));
    add(shortcutRows(m_bar->findChildren<QAbstractButton*>(), tr("Window")));
    for (const PanelSpec& panel : panelSpecs()) {
        if (const QWidget* widget = m_docks->panel(panel.id)) {
            QString title = panel.title;
            title.remove(QLatin1Char('&'));
            add(shortcutRows(widget->findChildren<QAction*>(), title));
            add(shortcutRows(widget->findChildren<QAbstractButton*>(), title));
        }
    }
    openDialog(new ShortcutList(rows, this));
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
    PreferencesDialog dialog(m_preferences, m_bench, m_historyPages->bytes(), this);
    if (dialog.exec() == QDialog::Accepted) {
        usePreferences(dialog.chosen());
    }
}

void MainWindow::useRecordingPreferences() {
    m_bench.recording().setNameMask(m_preferences.recordingNames);
    m_tidying->setLimits(m_preferences.retention, m_preferences.retentionFolders);
}

/// The preferences show what would go; their OK is the word it needs.
void MainWindow::sayWithheld(const QString& folder, int count) {
    const QString text =
        tr("%n recording(s) of %1 exceed the limits in the preferences and are kept for now.", nullptr, count)
            .arg(QDir::toNativeSeparators(folder));
    const QString remedy = tr("Deletion starts only after you have checked the list in Preferences.");
    m_bench.session().message(MessageLevel::Warning, tr("recordings"), text);
    if (folder == m_bench.recording().folder()) { // what the preferences look at
        say({widgets::Severity::Warning, text, remedy, tr("Preferences…")}, [this] {
            m_message->clear();
            askPreferences();
        });
    }
}

void MainWindow::usePreferences(const Preferences& chosen) {
    m_preferences.stopLockOut_ms = chosen.stopLockOut_ms;
    m_bench.stopLatch().setLockOut_ms(chosen.stopLockOut_ms);
    m_preferences.historyLimit_GB = chosen.historyLimit_GB;
    m_historyPages->setLimit_bytes(static_cast<std::uint64_t>(chosen.historyLimit_GB) * BytesPerGB);
    m_preferences.recordingNames = chosen.recordingNames;
    agreeToRetention(m_preferences, chosen.retention, agreedName(m_bench.recording().folder()));
    useRecordingPreferences();
    m_preferences.units = chosen.units;
    m_bench.setDisplayUnits(chosen.units);
    if (chosen.language != m_preferences.language) {
        chooseLanguage(chosen.language);
    }
    chooseTheme(chosen.theme);
}

} // namespace halbench::app
