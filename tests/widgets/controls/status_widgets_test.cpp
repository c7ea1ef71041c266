#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/number_label.h"
#include "widgets/controls/progress_row.h"
#include "widgets/controls/status_strip.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest/QTest>

#include <limits>

namespace halbench::widgets {
namespace {

using StatusWidgets = GuiTest;

bool showsText(const QWidget& widget, const QString& text) {
    for (const QLabel* label : widget.findChildren<QLabel*>()) {
        if (label->isVisibleTo(&widget) && label->text().contains(text)) {
            return true;
        }
    }
    return false;
}

TEST_F(StatusWidgets, stripSaysTheStateInWordsAndRole) {
    StatusStrip strip;
    EXPECT_EQ(strip.stateText(), QStringLiteral("Disconnected"));
    const QString friction = QStringLiteral("friction sweep");
    strip.setState(WorkState::Running, friction);
    EXPECT_EQ(strip.stateText(), QStringLiteral("Running friction sweep"));
    EXPECT_EQ(roleOf(strip), Role::Armed);
    strip.setState(WorkState::Stopped, QStringLiteral("Esc"));
    EXPECT_EQ(strip.stateText(), QStringLiteral("Stopped (Esc)"));
    EXPECT_EQ(roleOf(strip), Role::Bad);
    strip.setState(WorkState::Fault, QStringLiteral("coil B over 80 °C"));
    EXPECT_TRUE(showsText(strip, QStringLiteral("Fault (coil B over 80 °C)")));
    strip.setState(WorkState::Connected);
    EXPECT_EQ(roleOf(strip), Role::Good);
}

/// The strip as it looks at every change, with its words.
bool blinks(StatusStrip& strip) {
    strip.show();
    const QImage first = strip.grab().toImage();
    bool hasChanged = false;
    bool hasComeBack = false;
    (void)QTest::qWaitFor(
        [&] {
            hasChanged = hasChanged || strip.grab().toImage() != first;
            hasComeBack = hasChanged && strip.grab().toImage() == first;
            EXPECT_TRUE(showsText(strip, strip.stateText())); // always to be read
            return hasComeBack;
        },
        500);
    return hasComeBack;
}

TEST_F(StatusWidgets, aLatchedFaultBlinksUntilItIsClearedAndNothingElseDoes) {
    QApplication::setCursorFlashTime(20); // the default of 1 s is a slow blink, not a quick test
    StatusStrip strip;
    strip.setState(WorkState::Fault, QStringLiteral("coil B over 80 °C"));
    EXPECT_FALSE(blinks(strip)); // e.g. a connection that was lost: nobody can clear it
    strip.setFaultLatched(true);
    strip.setFaultLatched(true); // every report says it again
    EXPECT_TRUE(blinks(strip));
    strip.setFaultLatched(false);
    const QImage rest = strip.grab().toImage();
    EXPECT_FALSE(blinks(strip));
    StatusStrip fresh;
    fresh.setState(WorkState::Fault, QStringLiteral("coil B over 80 °C"));
    fresh.resize(strip.size());
    fresh.show();
    EXPECT_EQ(fresh.grab().toImage(), rest); // with its symbol
}

TEST_F(StatusWidgets, nothingBlinksWhereTheDesktopWantsNoBlinking) {
    QApplication::setCursorFlashTime(0);
    StatusStrip strip;
    strip.setState(WorkState::Fault, QStringLiteral("coil B over 80 °C"));
    strip.setFaultLatched(true);
    EXPECT_FALSE(blinks(strip));
    QApplication::setCursorFlashTime(1000);
}

TEST_F(StatusWidgets, stripShowsDeviceAndSimulation) {
    StatusStrip strip;
    EXPECT_FALSE(showsText(strip, QStringLiteral("SIMULATED")));
    strip.setDevice(QStringLiteral("sim:htm"), SourceKind::Simulation);
    EXPECT_TRUE(showsText(strip, QStringLiteral("SIMULATED")));
    EXPECT_TRUE(showsText(strip, QStringLiteral("sim:htm")));
    EXPECT_TRUE(strip.accessibleDescription().contains(QStringLiteral("simulated")));
    strip.clearDevice();
    EXPECT_FALSE(showsText(strip, QStringLiteral("SIMULATED")));
    EXPECT_TRUE(showsText(strip, QStringLiteral("No device")));
}

TEST_F(StatusWidgets, numberKeepsItsDecimalsAndItsWidth) {
    NumberLabel number;
    number.setFormat({2, QStringLiteral("A"), -4.0, 4.0});
    const QSize size = number.sizeHint();
    number.setValue(1.0);
    EXPECT_EQ(number.valueText(), QStringLiteral("1.00"));
    number.setValue(-3.14159);
    EXPECT_EQ(number.valueText(), QStringLiteral("-3.14"));
    EXPECT_EQ(number.sizeHint(), size);
    EXPECT_EQ(number.text(), QStringLiteral("-3.14\u00a0A"));
}

TEST_F(StatusWidgets, numberThatRoundsToZeroHasNoSign) {
    NumberLabel number;
    number.setFormat({2, {}, -4.0, 4.0});
    number.setValue(-0.004);
    EXPECT_EQ(number.valueText(), QStringLiteral("0.00"));
}

TEST_F(StatusWidgets, numberShowsAbsentAndOldValuesAsSuch) {
    NumberLabel number;
    EXPECT_EQ(number.valueText(), QStringLiteral("–"));
    number.setValue(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(number.valueText(), QStringLiteral("–"));
    number.setValue(2.0);
    number.setStale(true);
    EXPECT_TRUE(number.accessibleDescription().contains(QStringLiteral("old")));
    EXPECT_FALSE(number.toolTip().isEmpty());
}

TEST_F(StatusWidgets, messageOffersItsRemedyAsAButton) {
    MessageBar bar;
    EXPECT_TRUE(bar.isHidden());
    bar.showMessage({Severity::Error, QStringLiteral("Port is busy."), QStringLiteral("Close it."),
                     QStringLiteral("Try again")});
    EXPECT_FALSE(bar.isHidden());
    EXPECT_EQ(roleOf(bar), Role::Bad);
    QSignalSpy actions(&bar, &MessageBar::actionTriggered);
    auto* button = bar.findChild<QPushButton*>();
    ASSERT_NE(button, nullptr);
    EXPECT_EQ(button->text(), QStringLiteral("Try again"));
    button->click();
    EXPECT_EQ(actions.count(), 1);
    QSignalSpy dismissals(&bar, &MessageBar::dismissed);
    QTest::keyClick(&bar, Qt::Key_Delete);
    EXPECT_EQ(dismissals.count(), 1);
    EXPECT_TRUE(bar.isHidden());
}

TEST_F(StatusWidgets, aMessageOfOneRowIsOneRowInANarrowPanelToo) {
    const QString remedy = QStringLiteral("A remedy of many words ").repeated(10);
    MessageBar bar;
    bar.resize(260, 100);
    bar.showMessage(
        {Severity::Error, QStringLiteral("Stopped: by STOP"), remedy, QStringLiteral("Release"), true});
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&bar));
    const int row_px = bar.findChild<QPushButton*>()->sizeHint().height();
    EXPECT_LT(bar.sizeHint().height(), 2 * row_px);
    EXPECT_TRUE(bar.findChild<ElidedLabel*>()->toolTip().contains(remedy)); // nothing is lost
    EXPECT_TRUE(bar.accessibleDescription().contains(remedy));
    bar.showMessage({Severity::Error, QStringLiteral("Refused"), remedy, {}});
    EXPECT_GT(bar.heightForWidth(260), 2 * row_px); // other messages say all of it
}

TEST_F(StatusWidgets, emptyPanelOffersTheOneActionThatFillsIt) {
    EmptyState empty;
    empty.setIconName(QStringLiteral("connect"));
    empty.setWords(QStringLiteral("No device"), QStringLiteral("Signals appear here."),
                   QStringLiteral("Connect simulated motor"), QStringLiteral("Ctrl+1"));
    QSignalSpy actions(&empty, &EmptyState::actionTriggered);
    auto* button = empty.findChild<QPushButton*>();
    QTest::keyClick(button, Qt::Key_Space);
    EXPECT_EQ(actions.count(), 1);
    EXPECT_TRUE(button->toolTip().contains(QStringLiteral("Ctrl+1")));
    empty.setWords(QStringLiteral("No faults"), QStringLiteral("Faults appear here."));
    EXPECT_TRUE(button->isHidden());
}

TEST_F(StatusWidgets, progressShowsShareTimeLeftAndCancels) {
    ProgressRow row;
    row.setText(QStringLiteral("Friction sweep, plateau 3 of 26"));
    row.setProgress(0.999, 75.0);
    EXPECT_TRUE(showsText(row, QStringLiteral("99 %")));
    EXPECT_TRUE(showsText(row, QStringLiteral("1:15 left")));
    QSignalSpy cancels(&row, &ProgressRow::cancelRequested);
    row.findChild<QPushButton*>()->click();
    EXPECT_EQ(cancels.count(), 1);
    EXPECT_FALSE(row.findChild<QPushButton*>()->isEnabled());
    row.setProgress(std::nullopt);
    EXPECT_EQ(row.findChild<QProgressBar*>()->maximum(), 0);
    EXPECT_TRUE(row.findChild<QPushButton*>()->isEnabled());
}

TEST_F(StatusWidgets, durationsReadLikeAClock) {
    EXPECT_EQ(durationText(7.4), QStringLiteral("0:07"));
    EXPECT_EQ(durationText(754.0), QStringLiteral("12:34"));
    EXPECT_EQ(durationText(3723.0), QStringLiteral("1:02:03"));
    EXPECT_EQ(durationText(-5.0), QStringLiteral("0:00"));
}

} // namespace
} // namespace halbench::widgets
