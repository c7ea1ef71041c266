#include "tests/widgets/dragged_handle.h"
#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/share_splitter.h"

#include <QtTest/QTest>

namespace halbench::widgets {
namespace {

class ShareSplitterTest : public GuiTest {
protected:
    void SetUp() override {
        GuiTest::SetUp();
        splitter.setHandleWidth(4);
        for (int i = 0; i < 3; ++i) {
            auto* part = new QWidget(&splitter);
            part->setMinimumHeight(20);
            splitter.addWidget(part);
        }
        resize(608); // two lines of 4 px, 600 px to share
        splitter.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&splitter));
        QObject::connect(&splitter, &ShareSplitter::sharesChanged, &splitter, [this] { ++changes; });
    }
    void resize(int height) {
        splitter.resize(100, height);
        QApplication::processEvents();
    }

    ShareSplitter splitter{Qt::Vertical};
    int changes = 0;
};

TEST_F(ShareSplitterTest, partsHaveTheirSharesOfAnyRoom) {
    splitter.setShares({1.5, 1.0, 0.5});
    EXPECT_EQ(splitter.sizes(), (QList<int>{300, 200, 100}));
    resize(308);
    EXPECT_EQ(splitter.sizes(), (QList<int>{150, 100, 50}));
    resize(98); // the last one cannot be smaller
    EXPECT_EQ(splitter.sizes().last(), 20);
    resize(38); // nor can any
    resize(608);
    EXPECT_EQ(splitter.sizes(), (QList<int>{300, 200, 100})) << "nothing is lost on the way";
    EXPECT_EQ(splitter.shares(), (std::vector<double>{1.5, 1.0, 0.5}));
    EXPECT_EQ(changes, 0) << "nobody dragged";
}

TEST_F(ShareSplitterTest, aDraggedLineIsWhatTheUserWants) {
    splitter.setShares({1.0, 1.0, 1.0});
    dragHandle(splitter, 1, 50);
    EXPECT_GT(changes, 0);
    EXPECT_EQ(splitter.sizes(), (QList<int>{250, 150, 200}));
    EXPECT_EQ(splitter.shares(), (std::vector<double>{1.25, 0.75, 1.0}));
    resize(308);
    EXPECT_EQ(splitter.sizes(), (QList<int>{125, 75, 100}));
    resize(608);
    dragHandle(splitter, 1, -50);
    EXPECT_EQ(splitter.shares(), (std::vector<double>{1.0, 1.0, 1.0}));
}

TEST_F(ShareSplitterTest, aDoubleClickOnALineSharesEvenly) {
    splitter.setShares({4.0, 1.0, 1.0});
    QTest::mouseDClick(splitter.handle(2), Qt::LeftButton);
    EXPECT_EQ(splitter.sizes(), (QList<int>{200, 200, 200}));
    EXPECT_EQ(splitter.shares(), (std::vector<double>{1.0, 1.0, 1.0}));
    EXPECT_EQ(changes, 1);
}

TEST_F(ShareSplitterTest, aPartGrowsByStepsAsFarAsThereIsRoom) {
    splitter.setShares({1.0, 1.0, 1.0});
    EXPECT_TRUE(splitter.grow(0, 1.25));
    EXPECT_NEAR(splitter.sizes()[0], 600 * 1.25 / 3.25, 1.0); // of 3.25 shares
    EXPECT_NEAR(splitter.sizes()[1], splitter.sizes()[2], 1); // the pixel that cannot be shared
    int steps = 0;
    while (splitter.grow(0, 1.25) && steps < 100) {
        ++steps;
    }
    EXPECT_LT(steps, 100) << "it says when there is no more room";
    EXPECT_EQ(splitter.sizes(), (QList<int>{560, 20, 20}));
    EXPECT_FALSE(splitter.grow(3, 1.25));
    EXPECT_TRUE(splitter.grow(0, 0.8)) << "and back at once";
}

TEST_F(ShareSplitterTest, aPartThatNeedsMoreForAWhileGivesItBack) {
    splitter.setShares({1.5, 1.0, 0.5});
    splitter.widget(2)->setMinimumHeight(300);
    QApplication::processEvents();
    EXPECT_EQ(splitter.sizes()[2], 300);
    splitter.widget(2)->setMinimumHeight(20);
    QApplication::processEvents();
    EXPECT_EQ(splitter.sizes(), (QList<int>{300, 200, 100}));
    EXPECT_EQ(changes, 0);
}

TEST_F(ShareSplitterTest, aPartThatComesOrGoesLeavesNoneWithoutRoom) {
    splitter.setShares({4.0, 1.0, 1.0});
    delete splitter.widget(0);
    resize(308); // nobody gave shares of what is there now
    EXPECT_NEAR(splitter.sizes()[0], splitter.sizes()[1], 1);
}

TEST(SettledShares, haveAMeanOfOneToAHundredth) {
    EXPECT_EQ(settledShares({200, 100}), (std::vector<double>{1.33, 0.67}));
    EXPECT_EQ(settledShares({1.33, 0.67}), (std::vector<double>{1.33, 0.67}));
    EXPECT_EQ(settledShares({1e9, 1.0}), (std::vector<double>{2.0, 0.01})) << "none is nothing";
    EXPECT_EQ(settledShares({0.0, 0.0}), (std::vector<double>{1.0, 1.0}));
    EXPECT_TRUE(settledShares({}).empty());
}

} // namespace
} // namespace halbench::widgets
