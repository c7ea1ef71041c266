#include "app/workspaces/parts/side_columns.h"
#include "tests/widgets/gui_fixture.h"

#include <QScrollArea>

namespace halbench::app {
namespace {

TEST(ColumnsIn, asManyAsFitWithTheirGapsAndAtMostOneAPart) {
    constexpr int Gap_px = 24; // two group spacings of 12
    EXPECT_EQ(columnsIn(3 * 300 + 2 * Gap_px, 300, 3), 3);
    EXPECT_EQ(columnsIn(3 * 300 + 2 * Gap_px - 1, 300, 3), 2);
    EXPECT_EQ(columnsIn(2 * 300 + Gap_px - 1, 300, 3), 1);
    EXPECT_EQ(columnsIn(5000, 300, 3), 3);
    EXPECT_EQ(columnsIn(10, 300, 3), 1);
    EXPECT_EQ(columnsIn(1000, 300, 0), 1) << "a page without parts";
}

class SideColumnsTest : public widgets::GuiTest {
protected:
    void SetUp() override {
        GuiTest::SetUp();
        page = new SideColumns(nullptr);
        place.setWidget(page);
        place.setWidgetResizable(true); // as in a panel
        for (auto*& part : parts) {
            part = new QWidget;
            part->setMinimumSize(100, 50);
            page->addPart(*part);
        }
        place.show();
    }
    void widen(int width_px) {
        place.resize(width_px, 600);
        QApplication::processEvents();
    }

    QScrollArea place;
    SideColumns* page = nullptr;
    std::array<QWidget*, 3> parts{};
};

TEST_F(SideColumnsTest, partsStandBesideEachOtherAndGoBelowInANarrowPlace) {
    widen(3000);
    EXPECT_EQ(page->columns(), 3);
    EXPECT_LT(parts[0]->geometry().right(), parts[1]->geometry().left());
    EXPECT_LT(parts[1]->geometry().right(), parts[2]->geometry().left());
    widen(120);
    EXPECT_EQ(page->columns(), 1);
    EXPECT_LT(parts[0]->geometry().bottom(), parts[1]->geometry().top());
    EXPECT_LT(parts[1]->geometry().bottom(), parts[2]->geometry().top());
    EXPECT_EQ(parts[0]->x(), parts[2]->x());
}

TEST_F(SideColumnsTest, theLastOfTwoColumnsHoldsTheRest) {
    int width_px = 120;
    while (page->columns() != 2 && width_px < 3000) {
        widen(width_px += 20);
    }
    ASSERT_EQ(page->columns(), 2);
    EXPECT_LT(parts[0]->geometry().right(), parts[1]->geometry().left());
    EXPECT_EQ(parts[1]->x(), parts[2]->x());
    EXPECT_LT(parts[1]->geometry().bottom(), parts[2]->geometry().top());
}

// In a scroll area the least width is what decides whether anything is cut off at the right.
TEST_F(SideColumnsTest, needsTheWidthOfOnePartOnlyHoweverManyColumnsThereAre) {
    widen(3000);
    EXPECT_EQ(page->minimumSizeHint().width(), 0) << "parts without a layout ask for nothing";
    widen(120);
    EXPECT_EQ(page->columns(), 1) << "it came back from three";
}

TEST_F(SideColumnsTest, aColumnIsNoWiderThanALineIsRead) {
    widen(3000);
    EXPECT_LT(parts[2]->geometry().right(), 2800);
    EXPECT_EQ(parts[0]->width(), parts[1]->width());
}

} // namespace
} // namespace halbench::app
