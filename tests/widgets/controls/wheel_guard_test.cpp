#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/controls/wheel_guard.h"

#include <QApplication>
#include <QComboBox>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <QtTest/qtestspontaneevent.h>

namespace halbench::widgets {
namespace {

/// Fields in a panel that is higher than its place.
class WheelGuardTest : public GuiTest {
protected:
    void SetUp() override {
        guard = new WheelGuard(&area);
        auto* panel = new QWidget;
        auto* column = new QVBoxLayout(panel);
        number = new QuantityEdit(panel);
        number->setFormat({QStringLiteral("A"), 0.0, 100.0, 1.0, 1});
        number->setQuantity(20.0);
        choice = new QComboBox(panel);
        choice->addItems({"a", "b", "c"});
        choice->setCurrentIndex(1);
        slider = new QSlider(Qt::Horizontal, panel);
        slider->setRange(0, 100);
        slider->setValue(50);
        for (QWidget* field : std::initializer_list<QWidget*>{number, choice, slider}) {
            column->addWidget(field);
        }
        column->addSpacing(1000);
        area.setWidget(panel);
        area.setWidgetResizable(true);
        area.resize(200, 200);
        area.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&area));
        area.setFocus();
    }
    /// Whether somebody took it; what nobody takes goes on to the panel behind.
    bool turn(QWidget* over) {
        const QPoint place = over->rect().center();
        QWheelEvent event(place, over->mapToGlobal(place), {}, QPoint(0, -120), Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QSpontaneKeyEvent::setSpontaneous(&event); // of any event: as if it came from the system
        QApplication::sendEvent(over, &event);
        return event.isAccepted();
    }

    QScrollArea area;
    WheelGuard* guard = nullptr;
    QuantityEdit* number = nullptr;
    QComboBox* choice = nullptr;
    QSlider* slider = nullptr;
};

TEST_F(WheelGuardTest, scrollingPastAFieldChangesNothing) {
    for (QWidget* field : std::initializer_list<QWidget*>{number, choice, slider}) {
        EXPECT_FALSE(turn(field)) << field->metaObject()->className();
        EXPECT_FALSE(field->hasFocus()) << "the wheel takes no focus";
    }
    EXPECT_EQ(number->value(), 20.0);
    EXPECT_EQ(choice->currentIndex(), 1);
    EXPECT_EQ(slider->value(), 50);
}

TEST_F(WheelGuardTest, aFieldWithTheFocusTurns) {
    number->setFocus();
    ASSERT_TRUE(number->hasFocus());
    EXPECT_TRUE(turn(number));
    EXPECT_LT(number->value(), 20.0);
}

TEST_F(WheelGuardTest, theScrollBarItselfTurns) {
    turn(area.verticalScrollBar());
    EXPECT_GT(area.verticalScrollBar()->value(), 0);
}

} // namespace
} // namespace halbench::widgets
