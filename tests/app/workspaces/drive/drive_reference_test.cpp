#include "tests/app/workspaces/drive/drive_panel_fixture.h"

#include <QLocale>
#include <QRegularExpression>
#include <QToolTip>

namespace halbench::app {
namespace {

/// What the Drive panel says beside its fields before something moves.
class DriveReferenceTest : public DrivePanelTest {
protected:
    bool isSaid(const QString& words) {
        for (const QLabel* label : panel->findChildren<QLabel*>()) {
            if (label->isVisible() && label->text().contains(words)) {
                return true;
            }
        }
        return false;
    }
    /// "up to 20.00° from the arming position"
    double wholeWay_deg() {
        for (const QLabel* label : panel->findChildren<QLabel*>()) {
            const QString after = label->text().section(", up to ", 1);
            if (label->isVisible() && !after.isEmpty()) {
                return after.section(QRegularExpression("[^0-9.]"), 0, 0).toDouble();
            }
        }
        return 0.0;
    }
    QPushButton* start() { return find<QPushButton>(*panel, "Start"); }
};

TEST_F(DriveReferenceTest, whatTheSetPointCountsFromStandsBesideTheField) {
    EXPECT_TRUE(isSaid("Position relative to the arming position"));
    connectTo("sim:htm", 5.0);
    armByClick();
    ASSERT_TRUE(wait([&] { return bench().drive().origin_rad().has_value(); }));
    const double origin_deg = radiansToDegrees(*bench().drive().origin_rad());
    EXPECT_TRUE(isSaid("Position relative to the arming position (" + QString::number(origin_deg, 'f', 2)));
    chooseMode(1);
    EXPECT_TRUE(wait([&] { return !isSaid("Angle from"); }));
    chooseMode(2);
    EXPECT_TRUE(wait([&] { return isSaid("Position relative to the mode's start ("); }));
}

TEST_F(DriveReferenceTest, whileAReferenceRunsNoOtherStartsAndThePanelSaysWhy) {
    connectTo("sim:htm", 5.0);
    armByClick();
    find<QDoubleSpinBox>(*panel, "Duration")->setValue(3600.0);
    const QString usual = start()->toolTip();
    click(*panel, "Start");
    EXPECT_FALSE(start()->isEnabled()) << "at once, not when the board has said so";
    ASSERT_TRUE(wait([&] { return latest("reference.running") > 0.5; }));
    EXPECT_FALSE(start()->isEnabled());
    EXPECT_TRUE(isSaid("A motion is running"));
    EXPECT_TRUE(start()->toolTip().contains("End it to start another"));
    EXPECT_EQ(start()->accessibleDescription(), start()->toolTip());
    click(*panel, "End");
    EXPECT_TRUE(wait([&] { return start()->isEnabled(); }));
    EXPECT_FALSE(isSaid("A motion is running"));
    EXPECT_EQ(start()->toolTip(), usual);
}

TEST_F(DriveReferenceTest, theWholeWayFromWhereItWasArmedIsSaidBeforeAFurtherStart) {
    connectTo("sim:htm", 5.0);
    armByClick();
    find<QDoubleSpinBox>(*panel, "Amplitude")->setValue(10.0);
    find<QDoubleSpinBox>(*panel, "Duration")->setValue(0.5);
    EXPECT_TRUE(isSaid("Travel: up to 10.00"));
    EXPECT_FALSE(isSaid(", up to"));
    for (const double whole_deg : {20.0, 30.0}) { // a step of 10 degrees each, held where it ends
        click(*panel, "Start");
        ASSERT_TRUE(wait([&] { return latest("reference.running") > 0.5; }));
        ASSERT_TRUE(wait([&] { return start()->isEnabled(); }));
        // The window knows where it was armed by a sample: noise and ripple of the reading are below a
        // degree.
        EXPECT_NEAR(wholeWay_deg(), whole_deg, 1.0);
    }
}

TEST_F(DriveReferenceTest, aLetterAndAForeignDecimalSignAreNamedInTheFieldAndWhenRefused) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
    connectTo("sim:htm", 5.0);
    armByClick();
    auto* field = find<QDoubleSpinBox>(*panel, "Set-point");
    type(field, "12,5");
    EXPECT_TRUE(QToolTip::text().contains("Use '.'")) << QToolTip::text().toStdString();
    QTest::keyClick(field, Qt::Key_Return);
    const auto* bar = panel->findChild<widgets::MessageBar*>();
    EXPECT_TRUE(message().contains("'12,5")) << message().toStdString();
    EXPECT_TRUE(bar->message().remedy.contains("Use '.'")) << bar->message().remedy.toStdString();
    type(find<QDoubleSpinBox>(*panel, "Amplitude"), "2x");
    click(*panel, "Start");
    EXPECT_TRUE(bar->message().remedy.contains("'x' is not allowed in a number"));
    EXPECT_LT(latest("reference.running"), 0.5);
    QLocale::setDefault(before);
}

} // namespace
} // namespace halbench::app
