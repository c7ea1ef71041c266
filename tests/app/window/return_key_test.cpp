#include "app/workspaces/drive/jog_row.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/stop_button.h"

#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>

namespace halbench::app {
namespace {

class ReturnKeyTest : public WindowTest {
protected:
    /// In the window, shown and with the focus.
    template <typename Button>
    Button* shown(Button* button) {
        button->setGeometry(200, 200, 90, 30);
        button->show();
        button->setFocus();
        return button;
    }
};

TEST_F(ReturnKeyTest, returnAndEnterClickTheButtonWithTheFocus) {
    open();
    auto* push = shown(new QPushButton(QStringLiteral("Push"), window.get()));
    QSignalSpy pushed(push, &QPushButton::clicked);
    QTest::keyClick(push, Qt::Key_Return);
    QTest::keyClick(push, Qt::Key_Enter, Qt::KeypadModifier);
    EXPECT_EQ(pushed.count(), 2);
    QTest::keyClick(push, Qt::Key_Return, Qt::ControlModifier); // a shortcut of a panel
    EXPECT_EQ(pushed.count(), 2);
    auto* tool = shown(new QToolButton(window.get()));
    QSignalSpy used(tool, &QToolButton::clicked);
    QTest::keyClick(tool, Qt::Key_Return);
    EXPECT_EQ(used.count(), 1);
    tool->setEnabled(false);
    QTest::keyClick(tool, Qt::Key_Return);
    EXPECT_EQ(used.count(), 1);
}

TEST_F(ReturnKeyTest, aKeyThatIsHeldIsOneClick) {
    open();
    auto* push = shown(new QPushButton(QStringLiteral("Push"), window.get()));
    QSignalSpy pushed(push, &QPushButton::clicked);
    const auto send = [&](QEvent::Type type, bool isRepeat) {
        QKeyEvent event(type, Qt::Key_Return, Qt::NoModifier, QString(), isRepeat);
        QApplication::sendEvent(push, &event);
    };
    send(QEvent::KeyPress, false);
    for (int i = 0; i < 3; ++i) { // as X11 repeats: let go and pressed again, both marked
        send(QEvent::KeyRelease, true);
        send(QEvent::KeyPress, true);
    }
    EXPECT_EQ(pushed.count(), 0) << "not before it is let go";
    send(QEvent::KeyRelease, false);
    EXPECT_EQ(pushed.count(), 1);
}

TEST_F(ReturnKeyTest, aMotionLastsAsLongAsTheKeyIsDown) {
    open();
    auto* jog = shown(new HoldButton(QStringLiteral("Jog"), window.get()));
    QSignalSpy held(jog, &HoldButton::held);
    QSignalSpy letGo(jog, &HoldButton::letGo);
    QTest::keyPress(jog, Qt::Key_Return);
    EXPECT_EQ(held.count(), 1);
    EXPECT_EQ(letGo.count(), 0);
    QTest::keyRelease(jog, Qt::Key_Return);
    EXPECT_EQ(letGo.count(), 1);
}

TEST_F(ReturnKeyTest, aKeyThatWasPressedElsewhereClicksNothing) {
    open();
    auto* first = shown(new QPushButton(QStringLiteral("First"), window.get()));
    auto* second = new QPushButton(QStringLiteral("Second"), window.get());
    QObject::connect(first, &QPushButton::pressed, second, [&] { shown(second); });
    QSignalSpy firstClicked(first, &QPushButton::clicked);
    QSignalSpy secondClicked(second, &QPushButton::clicked);
    QTest::keyPress(first, Qt::Key_Return);
    QTest::keyRelease(second, Qt::Key_Return); // the focus went there meanwhile
    EXPECT_EQ(firstClicked.count(), 0);
    EXPECT_EQ(secondClicked.count(), 0);
}

TEST_F(ReturnKeyTest, armingByReturnIsOneActAndEndsByEscape) {
    open();
    connectMotor(1.0);
    QPushButton* arm = nullptr;
    for (QPushButton* one : window->findChildren<QPushButton*>()) {
        arm = one->isVisible() && one->text() == "Arm" ? one : arm;
    }
    ASSERT_NE(arm, nullptr);
    ASSERT_TRUE(wait([&] { return arm->isEnabled(); }));
    arm->setFocus();
    QTest::keyPress(arm, Qt::Key_Return);
    EXPECT_FALSE(session().report().board.isArmed) << "not before the key is let go";
    QTest::keyRelease(arm, Qt::Key_Return);
    ASSERT_TRUE(wait([&] { return session().report().board.isArmed; }));
    QTest::keyClick(window.get(), Qt::Key_Escape);
    EXPECT_TRUE(wait([&] { return !session().report().board.isArmed; }));
}

TEST_F(ReturnKeyTest, stopDoesNotWaitUntilTheKeyIsLetGo) {
    open();
    auto* stop = window->findChild<widgets::StopButton*>();
    QSignalSpy stops(stop, &widgets::StopButton::stopRequested);
    stop->setFocus();
    QTest::keyPress(stop, Qt::Key_Return);
    EXPECT_EQ(stops.count(), 1);
    QTest::keyRelease(stop, Qt::Key_Return);
    EXPECT_EQ(stops.count(), 1);
}

} // namespace
} // namespace halbench::app
