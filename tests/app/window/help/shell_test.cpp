#include "app/window/docks/dock_layout.h"
#include "app/window/help/help_pages.h"
#include "app/window/help/help_window.h"
#include "app/workbench/drive_control.h"
#include "app/workspaces/device/device_panel.h"
#include "app/workspaces/device/log_panel.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/stop_button.h"

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QTextBrowser>
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockManager.h>
#include <qtadvanceddocking/DockWidget.h>
#include <qtadvanceddocking/FloatingDockContainer.h>

// Docks, help and menus around the panels.

namespace halbench::app {
namespace {

class ShellTest : public WindowTest {
protected:
    ads::CDockWidget& dock(const QString& id) { return *window->docks().docks().value(id); }

    QAction* action(const QKeySequence& shortcut) {
        for (QAction* one : window->findChildren<QAction*>()) {
            if (one->shortcut() == shortcut) {
                return one;
            }
        }
        return nullptr;
    }

    /// A field of the Parameters panel, which floats in a window that has the focus.
    QWidget* floatParameters() {
        window->docks().raise("parameters");
        dock("parameters").setFloating();
        auto* floating = dock("parameters").floatingDockContainer();
        auto* field = window->docks().panel("parameters")->findChild<QLineEdit*>();
        EXPECT_TRUE(wait([&] { return field->isVisible(); }));
        QApplication::setActiveWindow(floating); // the platform without a screen gives no window the focus
        field->setFocus();
        return field;
    }
    static QString parametersHelp() {
        for (const PanelSpec& spec : panelSpecs()) {
            if (spec.id == "parameters") {
                return spec.helpAddress.section('#', 0, 0);
            }
        }
        return {};
    }

    HelpWindow* help() { return window->findChild<HelpWindow*>(); }
    QString helpWords() { return help()->findChild<QTextBrowser*>()->toPlainText(); }
};

/// What the window has at its first paint.
class FirstPaint : public QObject {
public:
    explicit FirstPaint(MainWindow& window) : QObject(&window), m_window(window) {
        window.installEventFilter(this);
    }

    bool isSeen = false;
    bool hasPanels = false;
    bool hasStop = false;

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::Paint && !isSeen) {
            isSeen = true;
            const QWidget* devices = m_window.docks().panel("devices");
            hasPanels = devices != nullptr && devices->isVisible();
            const auto* stop = m_window.findChild<widgets::StopButton*>();
            hasStop = stop != nullptr && stop->isVisible() && stop->isEnabled();
        }
        return false;
    }

private:
    MainWindow& m_window;
};

TEST_F(ShellTest, theFirstPaintHasThePanelsAndStop) {
    window = std::make_unique<MainWindow>(Preferences{});
    const auto* first = new FirstPaint(*window);
    window->show();
    ASSERT_TRUE(wait([&] { return first->isSeen; }));
    EXPECT_TRUE(first->hasStop);
    EXPECT_TRUE(first->hasPanels);
    EXPECT_TRUE(window->docks().panel("devices")->isAncestorOf(window->focusWidget()));
    EXPECT_NE(action(QKeySequence::Quit), nullptr);
}

TEST_F(ShellTest, aWindowThatWasNeverPaintedHasItsPanelsAsSoonAsTheyAreNeeded) {
    window = std::make_unique<MainWindow>(Preferences{});
    window->connectDevice("sim:htm");
    EXPECT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
}

TEST_F(ShellTest, thePerspectiveOfTheLastSessionIsThereWithItsPanels) {
    Preferences last;
    last.perspective = perspectiveId(Perspective::Tune);
    window = std::make_unique<MainWindow>(last);
    EXPECT_EQ(window->docks().perspective(), Perspective::Tune);
    window->furnish();
    window->show();
    EXPECT_TRUE(wait([&] { return window->docks().panel("tune")->isVisible(); }));
    EXPECT_FALSE(window->docks().panel("monitor")->isVisible());
}

TEST_F(ShellTest, anErrorInDevicesIsSeenToItsLastWord) {
    widgets::applyTheme(application, widgets::loadTheme("light").value()); // its sizes are what is judged
    open();
    window->resize(1440, 900);
    window->connectDevice("banana");
    const auto* message = window->docks().panel("devices")->findChild<widgets::MessageBar*>();
    ASSERT_TRUE(wait([&] { return message->isVisible(); }));
    for (const auto* words : message->findChildren<QLabel*>()) {
        if (words->wordWrap()) {
            EXPECT_TRUE(wait([&] { return words->height() >= words->heightForWidth(words->width()); }))
                << words->height() << " of " << words->heightForWidth(words->width());
            EXPECT_TRUE(words->visibleRegion().boundingRect().contains(words->rect()));
        }
    }
}

TEST_F(ShellTest, devicesBehindAnotherTabAreStillCollectedAndConnected) {
    open();
    window->docks().raise("log");
    dock("devices").dockManager()->addDockWidget(ads::CenterDockWidgetArea, &dock("devices"),
                                                 dock("log").dockAreaWidget());
    dock("log").setAsCurrentTab();
    ASSERT_EQ(window->findChild<DevicePanel*>(), nullptr); // that is what makes it a case
    window->connectDevice("sim:htm");
    EXPECT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    window->close();
    EXPECT_TRUE(wait([&] { return !window->isVisible(); })); // once the device is left
    EXPECT_EQ(window->project().project().device, "sim:htm");
}

TEST_F(ShellTest, theLogTellsWhatTheActuatorDidAndWhoStoppedIt) {
    open();
    connectMotor(1.0);
    const auto* log = qobject_cast<LogPanel*>(window->docks().panel("log"));
    const auto tells = [log](const char* words) { return log->text().contains(words); };
    QPushButton* arm = nullptr;
    for (auto* button : window->docks().panel("drive")->findChildren<QPushButton*>()) {
        arm = button->text().remove('&') == "Arm" ? button : arm;
    }
    ASSERT_NE(arm, nullptr);
    ASSERT_TRUE(wait([&] { return arm->isEnabled(); }));
    arm->click();
    ASSERT_TRUE(wait([&] { return tells("\tarmed"); })) << log->text().toStdString();
    QTest::keyClick(window.get(), Qt::Key_Escape);
    ASSERT_TRUE(wait([&] { return tells("disarmed"); })) << log->text().toStdString();
    EXPECT_FALSE(tells("times)")) << log->text().toStdString(); // one key, however many widgets saw it
    EXPECT_LT(log->text().indexOf("asked for by Esc"), log->text().indexOf("Stopped: by Esc"));
    EXPECT_LT(log->text().indexOf("Stopped: by Esc"), log->text().indexOf("disarmed"));
    const QTemporaryDir folder;
    window->bench().recording().setFolder(folder.path());
    window->bench().recording().start();
    ASSERT_TRUE(wait([&] { return window->bench().recording().status().rows > 0; }));
    window->bench().recording().stop();
    ASSERT_TRUE(wait([&] { return tells("written: "); })) << log->text().toStdString();
    EXPECT_TRUE(tells(("started: " + folder.path()).toUtf8()));
    window->bench().session().disconnectDevice();
    EXPECT_TRUE(wait([&] { return tells("disconnected"); }));
    EXPECT_TRUE(tells("connected sim-htm"));
}

TEST_F(ShellTest, aFloatingDockCarriesAStopOfItsOwn) {
    open();
    connectMotor(1.0);
    window->docks().raise("parameters");
    dock("parameters").setFloating();
    auto* floating = dock("parameters").floatingDockContainer();
    ASSERT_NE(floating, nullptr);
    auto* stop = floating->findChild<widgets::StopButton*>();
    ASSERT_NE(stop, nullptr);
    EXPECT_TRUE(wait([&] { return stop->isVisible(); }));
    EXPECT_FALSE(session().report().board.isStopLatched);
    QTest::mousePress(stop, Qt::LeftButton);
    EXPECT_TRUE(wait([&] { return session().report().board.isStopLatched; }));
}

// The docking library hid it then, outside of X11.
TEST_F(ShellTest, aFloatingDockStaysInSightWhenTheWindowBecomesActiveAndWhenItIsLeft) {
    open();
    window->docks().raise("parameters");
    dock("parameters").setFloating();
    auto* floating = dock("parameters").floatingDockContainer();
    ASSERT_NE(floating, nullptr);
    ASSERT_TRUE(wait([&] { return floating->isVisible(); }));
    for (const QEvent::Type change :
         {QEvent::WindowActivate, QEvent::WindowDeactivate, QEvent::WindowActivate}) {
        QEvent event(change);
        QApplication::sendEvent(window.get(), &event);
        EXPECT_TRUE(floating->isVisible()) << change;
    }
}

TEST_F(ShellTest, aFloatingDockOfARestoredArrangementCarriesItsStopToo) {
    open();
    window->docks().raise("parameters");
    dock("parameters").setFloating();
    Preferences preferences;
    preferences.arrangements = window->docks().arrangements();
    window.reset();
    open(preferences);
    window->recoverUnnamed(); // as the program starts
    ASSERT_TRUE(dock("parameters").isFloating());
    connectMotor(1.0);
    window->docks().setPerspective(Perspective::Tune);
    window->docks().setPerspective(Perspective::Monitor);
    auto* floating = dock("parameters").floatingDockContainer();
    ASSERT_NE(floating, nullptr);
    const auto stops = floating->findChildren<widgets::StopButton*>();
    ASSERT_EQ(stops.size(), 1);
    EXPECT_TRUE(wait([&] { return stops.front()->isVisible(); }));
    EXPECT_FALSE(session().report().board.isStopLatched);
    QTest::mousePress(stops.front(), Qt::LeftButton);
    EXPECT_TRUE(wait([&] { return session().report().board.isStopLatched; }));
}

/// A floating dock belongs to its window: F1, arming and the perspectives by key, from the field one types
/// in.
TEST_F(ShellTest, theShortcutsOfTheWindowWorkFromAFloatingDock) {
    open();
    connectMotor(1.0);
    QWidget* field = floatParameters();
    ASSERT_NE(field, nullptr);
    ASSERT_TRUE(wait([&] { return window->bench().drive().canArm(); }));
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(wait([&] { return session().report().board.isArmed; }));
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(wait([&] { return !session().report().board.isArmed; }));
    const QTemporaryDir folder;
    window->bench().recording().setFolder(folder.path());
    QTest::keyClick(field, Qt::Key_R, Qt::ControlModifier);
    EXPECT_TRUE(wait([&] { return window->bench().recording().isRecording(); }));
    QTest::keyClick(field, Qt::Key_R, Qt::ControlModifier);
    EXPECT_TRUE(wait([&] { return !window->bench().recording().isRecording(); }));
    QApplication::setActiveWindow(field->window()); // what ended the recording may have taken the focus
    field->setFocus();
    QTest::keyClick(field, Qt::Key_F1);
    ASSERT_NE(help(), nullptr);
    QTextBrowser page;
    page.setMarkdown(helpText(parametersHelp()));
    EXPECT_EQ(helpWords(), page.toPlainText());
    QApplication::setActiveWindow(field->window());
    QTest::keyClick(field, Qt::Key_2, Qt::ControlModifier);
    EXPECT_NE(window->docks().perspective(), Perspective::Monitor);
}

TEST_F(ShellTest, theShortcutsOfTheWindowAreDeadInItsDialogsAndInTheHelp) {
    open();
    connectMotor(1.0);
    QWidget* field = floatParameters();
    ASSERT_NE(field, nullptr);
    ASSERT_TRUE(wait([&] { return window->bench().drive().canArm(); }));
    HelpWindow page("index.md", window.get());
    page.show();
    QApplication::setActiveWindow(&page);
    QTest::keyClick(&page, Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_FALSE(window->bench().drive().isPending());
    QDialog dialog(window.get());
    dialog.setModal(true);
    dialog.show();
    for (QWidget* active : {static_cast<QWidget*>(&dialog), field->window()}) {
        QApplication::setActiveWindow(active);
        QTest::keyClick(active, Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
        EXPECT_FALSE(window->bench().drive().isPending());
    }
}

TEST_F(ShellTest, resettingBringsMovedAndFloatingPanelsBack) {
    open();
    const QPoint devicesPlace = dock("devices").mapTo(window.get(), QPoint());
    window->docks().raise("log");
    window->docks().raise("parameters");
    dock("parameters").setFloating();
    dock("devices").dockManager()->addDockWidget(ads::CenterDockWidgetArea, &dock("devices"),
                                                 dock("log").dockAreaWidget());
    window->docks().reset();
    EXPECT_FALSE(dock("parameters").isFloating());
    EXPECT_TRUE(dock("log").isClosed()) << "folded, as at first";
    EXPECT_TRUE(wait([&] { return dock("devices").mapTo(window.get(), QPoint()) == devicesPlace; }));
}

TEST_F(ShellTest, helpOpensThePageOfThePanelThatHasTheFocus) {
    open();
    auto* list = window->findChild<DevicePanel*>()->findChild<QListWidget*>();
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
    list->setFocus();
    ASSERT_TRUE(wait([&] { return QApplication::focusWidget() == list; }));
    QTest::keyClick(list, Qt::Key_F1);
    ASSERT_NE(help(), nullptr);
    QTextBrowser page;
    page.setMarkdown(helpText("monitor.md"));
    EXPECT_EQ(helpWords(), page.toPlainText());
    EXPECT_EQ(help()->findChild<QTextBrowser*>()->textCursor().block().text(), "Devices");
}

TEST_F(ShellTest, aLinkIntoAPageShowsItsSection) {
    open();
    HelpWindow page("identification.md#62-two-currents-of-friction");
    EXPECT_EQ(page.findChild<QTextBrowser*>()->textCursor().block().text(), "6.2 Two currents of friction");
    page.openPage("#1-what-can-be-known-from-what");
    EXPECT_TRUE(page.findChild<QTextBrowser*>()->textCursor().block().text().startsWith("1. What can"));
}

TEST_F(ShellTest, theHelpGoesBackToThePageBefore) {
    open();
    action(QKeySequence::HelpContents)->trigger();
    ASSERT_NE(help(), nullptr);
    const QString first = helpWords();
    help()->openPage("tuning.md");
    EXPECT_NE(helpWords(), first);
    QApplication::setActiveWindow(help()); // the platform without a screen gives no window the focus
    QTest::keyClick(help()->findChild<QTextBrowser*>(), Qt::Key_Left, Qt::AltModifier);
    EXPECT_EQ(helpWords(), first);
    QTest::keyClick(help()->findChild<QTextBrowser*>(), Qt::Key_Left,
                    Qt::AltModifier); // there is no page before
    EXPECT_EQ(helpWords(), first);
}

TEST_F(ShellTest, theHelpCarriesAStop) {
    open();
    connectMotor(1.0);
    action(QKeySequence::HelpContents)->trigger();
    QTest::mousePress(help()->findChild<widgets::StopButton*>(), Qt::LeftButton);
    EXPECT_TRUE(wait([&] { return session().report().board.isStopLatched; }));
}

TEST_F(ShellTest, aDeviceInUseIsNotLeftByTheShortcutOfTheSimulatedMotor) {
    open();
    QAction* simulated = action(QKeySequence("Ctrl+Shift+M"));
    ASSERT_NE(simulated, nullptr);
    EXPECT_TRUE(simulated->isEnabled());
    connectMotor(1.0);
    EXPECT_FALSE(simulated->isEnabled());
}

} // namespace
} // namespace halbench::app
