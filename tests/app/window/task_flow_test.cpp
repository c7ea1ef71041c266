#include "app/window/dock_layout.h"
#include "app/window/file_dialogs.h"
#include "app/window/task_flow.h"
#include "tests/app/window/window_test.h"
#include "widgets/stop_button.h"

#include <QFileDialog>
#include <QPushButton>

namespace halbench::app {
namespace {

class TaskFlowTest : public WindowTest {
protected:
    /// The one that can be seen.
    QPushButton* button(const char* panel, const QString& text) {
        for (auto* found : window->docks().panel(panel)->findChildren<QPushButton*>()) {
            if (found->text().remove('&') == text && found->isVisible()) {
                return found;
            }
        }
        return nullptr;
    }
};

TEST_F(TaskFlowTest, withoutAMotorTuneLeadsToIdentify) {
    open();
    window->docks().setPerspective(Perspective::Tune);
    ASSERT_TRUE(wait([&] { return button("tune", "Identify the motor") != nullptr; }));
    QTest::mouseClick(button("tune", "Identify the motor"), Qt::LeftButton);
    EXPECT_EQ(window->docks().perspective(), Perspective::Identify);
    EXPECT_TRUE(wait([&] { return button("identify", "Start identification") != nullptr; }));
    EXPECT_NE(button("identify", "Load model\u2026"), nullptr); // the window has dialogs
}

TEST_F(TaskFlowTest, aFileDialogCarriesASmallStop) {
    open();
    connectMotor(1.0);
    QFileDialog dialog;
    dressFileDialog(dialog, {"Save as model", "model.json", "Model (*.json)"}, true, window->bench());
    EXPECT_EQ(dialog.defaultSuffix(), "json");
    auto* stop = dialog.findChild<widgets::StopButton*>();
    ASSERT_NE(stop, nullptr);
    QTest::mousePress(stop, Qt::LeftButton);
    EXPECT_TRUE(wait([&] { return session().report().board.isStopLatched; }));
}

} // namespace
} // namespace halbench::app
