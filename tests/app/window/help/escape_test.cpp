#include "app/window/help/help_window.h"
#include "app/workbench/drive_control.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/stop_button.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>

#include <atomic>
#include <optional>

namespace halbench::app {
namespace {

/// Esc where it also closes something: in menus, lists of choices and the help.
class EscapeTest : public WindowTest {
protected:
    QMenu* openMenu() {
        auto* menu = window->menuBar()->actions().first()->menu();
        menu->popup(window->mapToGlobal(QPoint(0, 30)));
        EXPECT_EQ(QApplication::activePopupWidget(), menu);
        return menu;
    }
    bool isLatched() { return window->bench().stopLatch().isLatched(); }
    std::uint64_t stops() { return session().stops(); }
    /// Samples come and say that they are new.
    void awaitSamples() {
        ASSERT_TRUE(wait([&] { return window->bench().history().latest("position").has_value(); }));
    }
    HelpWindow* openHelp() {
        QTest::keyClick(window.get(), Qt::Key_F1);
        auto* help = window->findChild<HelpWindow*>();
        EXPECT_NE(help, nullptr);
        EXPECT_TRUE(QTest::qWaitForWindowExposed(help));
        QApplication::setActiveWindow(help); // the platform without a screen does not do it
        EXPECT_EQ(QApplication::activeWindow(), help);
        EXPECT_TRUE(help->isAncestorOf(QApplication::focusWidget()));
        return help;
    }
};

TEST_F(EscapeTest, closesAMenuAndStopsNothingWhileNothingIsArmed) {
    open();
    connectMotor(1.0);
    awaitSamples();
    const std::uint64_t before = stops();
    QMenu* menu = openMenu();
    QTest::keyClick(menu, Qt::Key_Escape);
    EXPECT_FALSE(menu->isVisible());
    EXPECT_EQ(stops(), before);
    QApplication::processEvents();
    QTest::keyClick(window.get(),
                    Qt::Key_Escape); // nothing is open any more: it leaves nothing, and latches nothing
    QApplication::processEvents();
    EXPECT_EQ(stops(), before);
    EXPECT_FALSE(isLatched());
}

TEST_F(EscapeTest, latchesNothingInFieldsAndPanelsWhileNothingIsArmed) {
    open();
    connectMotor(1.0);
    awaitSamples();
    const std::uint64_t before = stops();
    for (QWidget* widget : window->findChildren<QWidget*>()) {
        if (widget->isVisible() && widget->focusPolicy() != Qt::NoFocus) {
            widget->setFocus();
            QTest::keyClick(widget, Qt::Key_Escape);
        }
    }
    EXPECT_EQ(stops(), before);
    EXPECT_FALSE(isLatched());
}

TEST_F(EscapeTest, theStopButtonLatchesWhileNothingIsArmed) {
    open();
    connectMotor(1.0);
    awaitSamples();
    QTest::mousePress(window->findChild<widgets::StopButton*>(), Qt::LeftButton);
    EXPECT_TRUE(wait([&] { return isLatched(); }));
}

TEST_F(EscapeTest, stopsFromAFieldWhatIsArmed) {
    open();
    connectMotor(1.0);
    awaitSamples();
    window->bench().drive().arm();
    ASSERT_TRUE(wait([&] { return session().report().board.isArmed; }));
    QTest::keyClick(window.get(), Qt::Key_Escape);
    EXPECT_TRUE(wait([&] { return isLatched() && !session().report().board.isArmed; }));
}

TEST_F(EscapeTest, closesAListOfChoicesAndStopsNothingWhileNothingIsArmed) {
    open();
    connectMotor(1.0);
    awaitSamples();
    const std::uint64_t before = stops();
    QComboBox box(window.get());
    box.addItems({QStringLiteral("one"), QStringLiteral("two")});
    box.setGeometry(200, 200, 90, 30);
    box.show();
    box.showPopup();
    ASSERT_NE(QApplication::activePopupWidget(), nullptr);
    QTest::keyClick(box.view(), Qt::Key_Escape);
    EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
    EXPECT_EQ(stops(), before);
}

TEST_F(EscapeTest, stopsFromAMenuWhatIsArmed) {
    open();
    connectMotor(1.0);
    awaitSamples();
    window->bench().drive().arm();
    ASSERT_TRUE(wait([&] { return session().report().board.isArmed; }));
    QTest::keyClick(openMenu(), Qt::Key_Escape);
    EXPECT_TRUE(wait([&] { return !session().report().board.isArmed && isLatched(); }));
}

TEST_F(EscapeTest, stopsFromAMenuWhatIsAboutToBeArmed) {
    open();
    connectMotor(1.0);
    awaitSamples();
    QMenu* menu = openMenu();
    const std::uint64_t before = stops();
    window->bench().drive().arm(); // on its way: the board has not said so yet
    QTest::keyClick(menu, Qt::Key_Escape);
    EXPECT_GT(stops(), before);
}

TEST_F(EscapeTest, stopsFromAMenuWhileAProcedureRuns) {
    open();
    connectMotor(1.0);
    awaitSamples();
    std::atomic<bool> isEnded = false;
    ASSERT_TRUE(session().runProcedure(
        QStringLiteral("Test"),
        [](devices::Device& device, const ProcedureObserver& observer) -> Result<void> {
            while (observer.checkAbort()) {
                (void)device.clock().waitFor(0.01);
            }
            return {};
        },
        [&](const Result<void>&) { isEnded = true; }));
    QTest::keyClick(openMenu(), Qt::Key_Escape);
    EXPECT_TRUE(wait([&] { return isEnded.load(); }));
    EXPECT_TRUE(wait([&] { return isLatched(); }));
}

TEST_F(EscapeTest, stopsFromAMenuWhenTheStateIsNotKnown) {
    open();
    connectMotor(1.0);
    awaitSamples();
    session().setLiveStream({}, 100.0); // nothing new comes
    ASSERT_TRUE(wait([&] { return window->bench().freshness().isStale(); }));
    const std::uint64_t before = stops();
    QTest::keyClick(openMenu(), Qt::Key_Escape);
    EXPECT_GT(stops(), before);
}

TEST_F(EscapeTest, stopsBeforeTheFirstValueOfADeviceThatCanBeArmed) {
    open();
    std::optional<std::uint64_t> stopped;
    QObject::connect(&session(), &DeviceSession::stateChanged, window.get(), [&] {
        if (session().state() == SessionState::Connected && !stopped) {
            const std::uint64_t before = stops();
            QTest::keyClick(window.get(), Qt::Key_Escape);
            stopped = stops() - before;
        }
    });
    connectMotor(1.0);
    ASSERT_TRUE(stopped);
    EXPECT_GT(*stopped, 0U);
}

TEST_F(EscapeTest, latchesNothingWhileADisarmedSimulationRunsAsFastAsPossible) {
    open();
    connectMotor(1.0);
    awaitSamples();
    session().setPace({0.0}); // its time stands still until a procedure waits for it
    ASSERT_TRUE(wait([&] { return window->bench().freshness().isStale(); }));
    const std::uint64_t before = stops();
    QMenu* menu = openMenu();
    QTest::keyClick(menu, Qt::Key_Escape);
    EXPECT_FALSE(menu->isVisible());
    EXPECT_EQ(stops(), before);
    QTest::mousePress(window->findChild<widgets::StopButton*>(), Qt::LeftButton);
    EXPECT_TRUE(wait([&] { return isLatched(); }));
}

TEST_F(EscapeTest, stopsAnArmedSimulationThatRunsAsFastAsPossible) {
    open();
    connectMotor(1.0);
    awaitSamples();
    window->bench().drive().arm();
    ASSERT_TRUE(wait([&] { return session().report().board.isArmed; }));
    session().setPace({0.0});
    QTest::keyClick(window.get(), Qt::Key_Escape);
    EXPECT_TRUE(wait([&] { return isLatched() && !session().report().board.isArmed; }));
}

TEST_F(EscapeTest, latchesNothingOnABoardWithNothingToArm) {
    open();
    window->connectDevice(QStringLiteral("sim:spherical"));
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    const std::uint64_t before = stops();
    QMenu* menu = openMenu();
    QTest::keyClick(menu, Qt::Key_Escape);
    EXPECT_FALSE(menu->isVisible());
    QTest::keyClick(window.get(), Qt::Key_Escape);
    EXPECT_EQ(stops(), before);
    EXPECT_FALSE(isLatched());
    QTest::mousePress(window->findChild<widgets::StopButton*>(), Qt::LeftButton);
    EXPECT_GT(stops(), before);
}

TEST_F(EscapeTest, closesTheHelpWhileNothingIsArmed) {
    open();
    connectMotor(1.0);
    awaitSamples();
    const std::uint64_t before = stops();
    QPointer<HelpWindow> help = openHelp();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    EXPECT_TRUE(wait([&] { return help.isNull(); }));
    EXPECT_EQ(stops(), before);
}

TEST_F(EscapeTest, stopsFromTheHelpWhatIsArmedAndLeavesItOpen) {
    open();
    connectMotor(1.0);
    awaitSamples();
    const QPointer<HelpWindow> help = openHelp();
    window->bench().drive().arm();
    ASSERT_TRUE(wait([&] { return session().report().board.isArmed; }));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    EXPECT_TRUE(wait([&] { return isLatched(); }));
    ASSERT_FALSE(help.isNull());
    EXPECT_TRUE(help->isVisible());
}

TEST_F(EscapeTest, controlWClosesTheHelpAlone) {
    open();
    const QPointer<HelpWindow> help = openHelp();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_W, Qt::ControlModifier);
    EXPECT_TRUE(wait([&] { return help.isNull(); }));
    EXPECT_TRUE(window->isVisible());
}

} // namespace
} // namespace halbench::app
