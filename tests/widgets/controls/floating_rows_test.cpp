#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/floating_rows.h"
#include "widgets/controls/message_bar.h"

#include <QVBoxLayout>
#include <QtTest/QTest>

namespace halbench::widgets {
namespace {

class FloatingRowsTest : public GuiTest {
protected:
    FloatingRowsTest() {
        auto* column = new QVBoxLayout(&window);
        below = new QWidget(&window);
        column->addWidget(below);
        bar = new MessageBar(&window);
        rows = new FloatingRows(*below, Qt::BottomEdge, &window);
        rows->addRow(*bar);
        window.resize(900, 500);
        window.show();
    }

    void say(const QString& text) {
        bar->showMessage({Severity::Information, text, {}, {}});
        QCoreApplication::processEvents();
    }

    QWidget window;
    QWidget* below = nullptr;
    MessageBar* bar = nullptr;
    FloatingRows* rows = nullptr;
};

TEST_F(FloatingRowsTest, aMessageMovesNothingBelowIt) {
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    const QRect before = below->geometry();
    EXPECT_FALSE(rows->isVisible());
    say("word");
    EXPECT_TRUE(bar->isVisible());
    EXPECT_GE(bar->height(), bar->sizeHint().height());
    EXPECT_EQ(below->geometry(), before);
    EXPECT_TRUE(below->geometry().contains(rows->geometry()));
    EXPECT_GT(rows->y(), before.center().y()); // the lower part
    bar->clear();
    QCoreApplication::processEvents();
    EXPECT_FALSE(rows->isVisible()); // no sheet that takes the mouse stays behind
    EXPECT_EQ(below->geometry(), before);
}

TEST_F(FloatingRowsTest, rowsOfAPanelDoNotCoverThoseOfTheWindow) {
    auto* other = new MessageBar(&window);
    auto* upper = new FloatingRows(*below, Qt::TopEdge, &window);
    upper->addRow(*other);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    other->showMessage({Severity::Warning, "of the panel", {}, {}});
    say("of the window");
    EXPECT_TRUE(below->geometry().contains(upper->geometry()));
    EXPECT_FALSE(upper->geometry().intersects(rows->geometry()));
}

TEST_F(FloatingRowsTest, aRowThatIsAlwaysThereFloatsWhenSomethingInItIsShown) {
    auto* always = new QWidget(&window);
    auto* column = new QVBoxLayout(always);
    column->setContentsMargins(0, 0, 0, 0);
    auto* inner = new MessageBar(always);
    column->addWidget(inner);
    rows->addRow(*always);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    QCoreApplication::processEvents();
    EXPECT_FALSE(rows->isVisible());
    inner->showMessage({Severity::Warning, "inside", {}, {}});
    EXPECT_TRUE(inner->isVisible());
    QCoreApplication::processEvents();
    EXPECT_GE(inner->height(), inner->minimumSizeHint().height());
    inner->clear();
    QCoreApplication::processEvents();
    EXPECT_FALSE(rows->isVisible());
}

TEST_F(FloatingRowsTest, itStaysInTheCornerOfAWindowThatShrinksAndGrowsWithItsWords) {
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    say("word");
    const int oneLine_px = rows->height();
    window.resize(400, 300);
    QCoreApplication::processEvents();
    EXPECT_TRUE(below->geometry().contains(rows->geometry()));
    say(QString("many words ").repeated(40));
    EXPECT_GT(rows->height(), oneLine_px);
    EXPECT_TRUE(below->geometry().contains(rows->geometry()));
}

} // namespace
} // namespace halbench::widgets
