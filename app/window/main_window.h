#pragma once

#include "app/window/preferences/preferences.h"
#include "app/window/project/project_session.h"
#include "app/workbench/workbench.h"
#include "widgets/controls/message_bar.h"

#include <QMainWindow>
#include <QTimer>

#include <functional>
#include <memory>

class QActionGroup;
class QMenu;

namespace halbench::app {

class DevicePanel;
class DockLayout;
class FrameClock;
class LinkPanel;
class NotesPanel;
class ProjectMenu;
class ProjectWork;
class RecordingTidying;
class TopBar;
class Tour;
class UnsavedBar;

/// The workstation: top bar, docked panels, menus. Everything it does goes through the workbench.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(Preferences preferences);
    ~MainWindow() override;

    /// Makes the panels, before the window is shown at the latest: its first paint is complete. Again does
    /// nothing.
    void furnish();
    void setVisible(bool isVisible) override;

    Workbench& bench() { return m_bench; }
    DockLayout& docks() { return *m_docks; }
    const Preferences& preferences() const { return m_preferences; }
    /// Of samples that memory has no room for.
    const devices::PageFile& historyPages() const { return *m_historyPages; }

    ProjectSession& project() { return *m_project; } ///< after furnish()
    void openProject(const QString& path);
    /// Opens again what had no name yet when the window was closed or the program was interrupted, with the
    /// panels as they were.
    void recoverUnnamed();

    /// As if the user had written the address and pressed Connect.
    void connectDevice(const QString& uri);

    /// The terminal or the session that the program belongs to is gone: stops what may move, restores and
    /// disarms, closes. Dialogs do not hold it up; a project that cannot be kept does not either.
    void closeBySignal();

Q_SIGNALS:
    void furnished();

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void buildCentre();
    void connectPanels();
    void fitScreen();
    void usePreferredPerspective();
    void createMenus();
    void fillMenus();
    void fillFileMenu();
    void createProjects();
    void fillEditMenu();
    void fillViewMenu();
    void createLanguageMenu(QMenu& menu);
    void fillHelpMenu();
    template <typename Dialog>
    void openDialog(Dialog* dialog);
    void showShortcuts();
    void createStartPage();
    void connectDrops();
    void openRecording(const QString& path);
    void chooseTheme(ThemeChoice choice);
    void chooseLanguage(const QString& id);
    void askPreferences();
    void usePreferences(const Preferences& chosen);
    void useRecordingPreferences();
    void showHelp();
    void openHelp(const QString& address);
    void noteStop(const QString& by);
    void keepLastDevice();
    void createPanelKeys();
    void showPlotsOnly(bool isOnly);
    void followDevice();
    void followOffer();
    void leaveConnection();
    void onPerspective();
    void onMessage(widgets::Severity severity, const QString& text, const QString& hint);
    void say(const widgets::Message& message, std::function<void()> remedy);
    void sayWithheld(const QString& folder, int count);
    void sayGainsLeft(const QString& text, const QString& remedy, const QString& design);
    void sayNotKept(const Error& error);
    void onKept();
    void closeAnyway();
    Project shownProject() const;
    void autosave();
    void collectProject();
    void takeOverProject();
    void askConsent();
    void offerCopy(const QString& path);
    void offerInterrupted();
    void refreshTitle();
    void leaveThenClose();

    bool m_isFurnished = false;
    bool m_isClosing = false; ///< waits for the device
    bool m_hasLeft = false;   ///< the device is left, or waiting for it was given up
    Preferences m_preferences;
    std::shared_ptr<devices::PageFile> m_historyPages;
    Workbench m_bench;
    std::unique_ptr<ProjectSession> m_project; ///< since furnish(): taking its lock waits for the disk
    FrameClock* m_frame = nullptr;
    QTimer m_autosave; ///< at most so much work is lost in a crash
    widgets::MessageBar* m_message = nullptr;
    std::function<void()> m_remedy;           ///< what the button of the message does
    widgets::MessageBar* m_refusal = nullptr; ///< why the window did not close
    bool m_isNotKept = false;                 ///< the message says so
    bool m_isProjectRefused = false;          ///< the message says so
    bool m_isLossAccepted = false;
    UnsavedBar* m_unkept = nullptr; ///< why the project was not left
    ProjectMenu* m_projects = nullptr;
    ProjectWork* m_work = nullptr;
    RecordingTidying* m_tidying = nullptr;
    TopBar* m_bar = nullptr;
    LinkPanel* m_link = nullptr;
    QMenu* m_fileMenu = nullptr;
    QMenu* m_editMenu = nullptr;
    QMenu* m_viewMenu = nullptr;
    QMenu* m_helpMenu = nullptr;
    Tour* m_tour = nullptr;
    QActionGroup* m_themes = nullptr;
    QActionGroup* m_languages = nullptr;
    DockLayout* m_docks = nullptr;
    DevicePanel* m_devices = nullptr; ///< kept: a panel behind another tab is nobody's child
    NotesPanel* m_notes = nullptr;
};

} // namespace halbench::app
