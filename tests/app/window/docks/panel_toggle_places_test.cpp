// A click that is meant for the button of a panel must not meet another one there.
#include "app/window/docks/dock_layout.h"
#include "app/workspaces/drive/arm_button.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "tests/app/window/window_test.h"

#include <QToolBar>
#include <QToolButton>

namespace halbench::app {
namespace {

class PanelTogglePlacesTest : public WindowTest, public testing::WithParamInterface<QSize> {
protected:
    QToolButton* toggle(const char* title) {
        auto* tools = window->findChild<MonitorPanel*>()->findChild<QToolBar*>();
        for (auto* button : tools->findChildren<QToolButton*>()) {
            if (button->accessibleName() == QLatin1String(title) && button->isVisible()) {
                return button;
            }
        }
        return nullptr;
    }
    QPoint placeOf(const QWidget& widget) { return widget.mapTo(window.get(), widget.rect().center()); }
    QRect frameOf(const QWidget& widget) { return {widget.mapTo(window.get(), QPoint()), widget.size()}; }
};

TEST_P(PanelTogglePlacesTest, theButtonsOfDriveAndParametersStayWhereDriveOpens) {
    open();
    window->resize(GetParam());
    connectMotor(1.0);
    settle();
    QToolButton* drive = toggle("Drive");
    QToolButton* parameters = toggle("Parameters");
    ASSERT_NE(drive, nullptr);
    ASSERT_NE(parameters, nullptr);
    const QRect driveFrame = frameOf(*drive);
    const QRect parametersFrame = frameOf(*parameters);
    QTest::mouseClick(drive, Qt::LeftButton);
    settle();
    EXPECT_TRUE(drive->isVisible());
    EXPECT_TRUE(parameters->isVisible());
    EXPECT_EQ(frameOf(*drive), driveFrame);
    EXPECT_EQ(frameOf(*parameters), parametersFrame);
    for (const ArmButton* arm : window->findChildren<ArmButton*>()) {
        EXPECT_FALSE(arm->isVisible() && frameOf(*arm).intersects(driveFrame | parametersFrame));
    }
}

INSTANTIATE_TEST_SUITE_P(Window, PanelTogglePlacesTest,
                         testing::Values(QSize(960, 540), QSize(1280, 720), QSize(1366, 768),
                                         QSize(1500, 938), QSize(1920, 1200)));

} // namespace
} // namespace halbench::app
