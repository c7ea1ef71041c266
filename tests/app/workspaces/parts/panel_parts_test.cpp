#include "app/workspaces/device/configuration_panel.h"
#include "app/workspaces/device/parameters_panel.h"
#include "app/workspaces/drive/drive_panel.h"
#include "app/workspaces/drive/jog_row.h"
#include "app/workspaces/field/field_panel.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "app/workspaces/parts/panel_parts.h"
#include "app/workspaces/recordings/record_panel.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/quantity_edit.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QStackedWidget>

namespace halbench::app {
namespace {

class PanelPartsTest : public BenchTest {
protected:
    /// Every control that takes the focus has a name for screen readers and says what it does.
    static void expectWords(const QWidget& panel) {
        for (const QWidget* widget : panel.findChildren<QWidget*>()) {
            const bool isControl = qobject_cast<const QAbstractButton*>(widget) != nullptr ||
                                   qobject_cast<const QComboBox*>(widget) != nullptr ||
                                   qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
                                   qobject_cast<const QAbstractItemView*>(widget) != nullptr ||
                                   qobject_cast<const QLineEdit*>(widget) != nullptr;
            const bool isPart = widget->objectName().startsWith("qt_") ||
                                qobject_cast<const QAbstractSpinBox*>(widget->parent()) != nullptr ||
                                QString(widget->metaObject()->className()).contains("Private") ||
                                widget->parent()->inherits("QComboBoxPrivateContainer");
            if (!isControl || isPart || widget->isHidden() || widget->focusPolicy() == Qt::NoFocus) {
                continue;
            }
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            const bool isNamed =
                !widget->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty());
            const std::string who = std::string(panel.metaObject()->className()) + ": " +
                                    widget->metaObject()->className() + " " +
                                    widget->accessibleName().toStdString();
            EXPECT_TRUE(isNamed) << who;
            EXPECT_FALSE(widget->toolTip().isEmpty()) << who;
        }
    }
};

TEST_F(PanelPartsTest, everyControlOfEveryPanelHasItsWords) {
    connectTo("sim:htm", 5.0);
    expectWords(MonitorPanel(bench()));
    expectWords(DrivePanel(bench()));
    expectWords(ParametersPanel(bench()));
    expectWords(RecordPanel(bench()));
    expectWords(FieldPanel(bench()));
}

TEST_F(PanelPartsTest, aHeldButtonEndsWhenItIsHiddenOrDisabled) {
    QWidget window;
    HoldButton button(QStringLiteral("hold"), &window);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    QSignalSpy held(&button, &HoldButton::held);
    QSignalSpy letGo(&button, &HoldButton::letGo);
    QTest::mousePress(&button, Qt::LeftButton);
    button.setEnabled(false);
    EXPECT_EQ(letGo.count(), 1);
    button.setEnabled(true);
    QTest::mousePress(&button, Qt::LeftButton);
    button.hide();
    EXPECT_EQ(held.count(), 2);
    EXPECT_EQ(letGo.count(), 2);
}

TEST_F(PanelPartsTest, aNumberFieldSaysItsPurposeAndWhatIsAllowed) {
    const std::unique_ptr<widgets::QuantityEdit> field(makeNumberField(
        {QStringLiteral("Speed"), QStringLiteral("How fast"), QStringLiteral("r/min"), 1, -5.0, 5.0},
        nullptr));
    EXPECT_EQ(field->accessibleName(), "Speed");
    EXPECT_TRUE(field->toolTip().startsWith("How fast"));
    EXPECT_TRUE(field->toolTip().contains("5"));
    EXPECT_EQ(field->maximum(), 5.0);
}

TEST_F(PanelPartsTest, aMessageBelowAColumnIsAsHighAsItsWordsAndNoHigher) {
    RecordPanel panel(bench());
    panel.resize(360, 620);
    panel.show();
    auto* message = panel.findChild<widgets::MessageBar*>();
    message->showMessage({widgets::Severity::Success, "Rows were written", "Settings are beside them.", {}});
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    QCoreApplication::processEvents();
    EXPECT_EQ(message->height(), message->heightForWidth(message->width()));
}

TEST_F(PanelPartsTest, aMessageOfTheConfigurationMovesNothing) {
    ConfigurationPanel panel(bench());
    panel.resize(600, 500);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    auto* pages = panel.findChild<QStackedWidget*>();
    const QRect before = pages->geometry();
    auto* message = panel.findChild<widgets::MessageBar*>();
    message->showMessage({widgets::Severity::Error, "File not read", "Choose another file.", {}});
    QCoreApplication::processEvents();
    ASSERT_TRUE(message->isVisible());
    EXPECT_EQ(pages->geometry(), before);
}

} // namespace
} // namespace halbench::app
