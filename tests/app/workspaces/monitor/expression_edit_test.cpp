#include "app/workspaces/monitor/expression_edit.h"
#include "tests/widgets/gui_fixture.h"
#include "widgets/live_plot/live_plot_spec.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QDropEvent>
#include <QMimeData>
#include <QSignalSpy>
#include <QtTest/QTest>

namespace halbench::app {
namespace {

class ExpressionEditTest : public widgets::GuiTest {
protected:
    ExpressionEditTest() {
        field.setWords(
            {{"hall.a", "Hall A"}, {"hall.b", "Hall B"}, {"position", "Angle"}, {"sqrt(", "square root"}});
        field.show();
    }
    QAbstractItemView& list() { return *field.findChild<QCompleter*>()->popup(); }

    ExpressionEdit field;
};

TEST_F(ExpressionEditTest, aWordIsFoundByEitherOfItsNames) {
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&field));
    QTest::keyClicks(&field, "2*ang"); // the signal tree says "Angle"
    EXPECT_EQ(field.offered(), QStringList("position"));
    EXPECT_TRUE(list().isVisible());
    field.clear();
    QTest::keyClicks(&field, "2*hall.");
    EXPECT_EQ(field.offered(), QStringList({"hall.a", "hall.b"}));
    field.clear();
    QTest::keyClicks(&field, "root");
    EXPECT_EQ(field.offered(), QStringList("sqrt("));
}

TEST_F(ExpressionEditTest, nothingIsOfferedForANumberOrAWholeName) {
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&field));
    QTest::keyClicks(&field, "2");
    EXPECT_FALSE(list().isVisible());
    QTest::keyClicks(&field, "*position");
    EXPECT_FALSE(list().isVisible());
}

TEST_F(ExpressionEditTest, whatIsTakenReplacesTheWordAndEnterDoesNotEnterTheExpression) {
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&field));
    QSignalSpy entered(&field, &QLineEdit::returnPressed);
    QTest::keyClicks(&field, "2*ang");
    ASSERT_TRUE(list().isVisible());
    QTest::keyClick(&list(), Qt::Key_Down);
    QTest::keyClick(&list(), Qt::Key_Return);
    EXPECT_EQ(field.text(), "2*position");
    EXPECT_EQ(entered.count(), 0);
    QTest::keyClick(&field, Qt::Key_Return);
    EXPECT_EQ(entered.count(), 1);
}

TEST_F(ExpressionEditTest, signalsThatAreDroppedAreInserted) {
    QMimeData mime;
    mime.setData(QLatin1String(widgets::SignalsMimeType), "hall.a\nhall.b");
    QDragEnterEvent enter(QPoint(2, 2), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&field, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(2.0, 2.0), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&field, &drop);
    EXPECT_EQ(field.text(), "hall.a + hall.b");
}

} // namespace
} // namespace halbench::app
