#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/stop_button.h"

#include <QSignalSpy>
#include <QtTest/QTest>

namespace halbench::widgets {
namespace {

using StopButtonTest = GuiTest;

TEST_F(StopButtonTest, stopsWhenPressedNotWhenLetGo) {
    StopButton button(StopButton::Variant::Full);
    QSignalSpy stops(&button, &StopButton::stopRequested);
    QTest::mousePress(&button, Qt::LeftButton);
    EXPECT_EQ(stops.count(), 1);
    QTest::mouseRelease(&button, Qt::LeftButton);
    EXPECT_EQ(stops.count(), 1);
}

TEST_F(StopButtonTest, stopsBySpaceAndReturn) {
    StopButton button(StopButton::Variant::Compact);
    QSignalSpy stops(&button, &StopButton::stopRequested);
    QTest::keyPress(&button, Qt::Key_Space);
    EXPECT_EQ(stops.count(), 1);
    QTest::keyRelease(&button, Qt::Key_Space);
    QTest::keyClick(&button, Qt::Key_Return);
    EXPECT_EQ(stops.count(), 2);
}

TEST_F(StopButtonTest, everyPressStopsLatchedOrNot) {
    StopButton button(StopButton::Variant::Full);
    QSignalSpy stops(&button, &StopButton::stopRequested);
    QObject::connect(&button, &StopButton::stopRequested, &button, [&button] { button.setLatched(true); });
    for (int i = 0; i < 5; ++i) {
        QTest::mouseClick(&button, Qt::LeftButton);
    }
    EXPECT_EQ(stops.count(), 5);
}

TEST_F(StopButtonTest, isLargeSaysWhyAndKeepsItsSize) {
    StopButton button(StopButton::Variant::Full);
    const QSize size = button.sizeHint();
    EXPECT_GE(size.width(), 88);
    EXPECT_GE(size.height(), 40);
    EXPECT_EQ(roleOf(button), Role::Stop);
    EXPECT_FALSE(button.accessibleName().isEmpty());
    EXPECT_TRUE(button.toolTip().contains(QStringLiteral("Esc")));
    button.setLatched(true, QStringLiteral("link lost"));
    EXPECT_EQ(button.sizeHint(), size);
    EXPECT_EQ(button.text(), QStringLiteral("STOP")); // at all times
    EXPECT_TRUE(button.toolTip().contains(QStringLiteral("link lost")));
}

} // namespace
} // namespace halbench::widgets
