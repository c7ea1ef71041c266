#pragma once

#include "app/window/preferences.h"
#include "app/workspaces/workbench.h"

#include <QMainWindow>
#include <QTimer>

namespace halbench::app {

class DockLayout;
class TopBar;

/// The workstation: top bar, docked panels, menus. Everything it does goes through the workbench.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(Preferences preferences);
    ~MainWindow() override;

    Workbench& bench() { return m_bench; }
    DockLayout& docks() { return *m_docks; }
    const Preferences& preferences() const { return m_preferences; }

    /// As if the user had written the address and pressed Connect.
    void connectDevice(const QString& uri);

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void buildCentre();
    void createActions();
    void createViewMenu();
    void createHelpMenu();
    void chooseTheme(ThemeChoice choice);
    void showHelp();
    void onPerspective();

    Preferences m_preferences;
    Workbench m_bench;
    QTimer m_frame; ///< one for all that moves
    TopBar* m_bar = nullptr;
    DockLayout* m_docks = nullptr;
};

} // namespace halbench::app
