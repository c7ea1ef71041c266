#include "app/workspaces/parts/page_chooser.h"
#include "tests/widgets/gui_fixture.h"
#include "widgets/theme/theme_style.h"

#include <QLabel>
#include <QPushButton>
#include <QtTest/QTest>

#include <algorithm>
#include <set>
#include <vector>

namespace halbench::app {
namespace {

class PageChooserTest : public widgets::GuiTest {
protected:
    void SetUp() override {
        GuiTest::SetUp();
        for (const char* title : {"Open loop", "Step of 100", "Small step", "Numbers", "Verification"}) {
            auto* page = new QLabel(title, &chooser);
            pages.push_back(page);
            chooser.addPage(page);
            chooser.setTitle(page, title, QStringLiteral("what it shows"));
        }
    }
    void showAt(int width) {
        host.resize(width, 300);
        chooser.resize(width, 300);
        host.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&host));
        QCoreApplication::processEvents(); // the layout follows the resize
        ASSERT_TRUE(QTest::qWaitFor([&] { return isWhole(); }));
    }
    QList<QPushButton*> buttons() const { return chooser.findChildren<QPushButton*>(); }
    bool isWhole() const {
        const auto all = buttons();
        return std::all_of(all.begin(), all.end(), [](const QPushButton* button) {
            return button->isHidden() || button->width() >= button->sizeHint().width();
        });
    }
    int rows() const {
        std::set<int> tops;
        for (const QPushButton* button : buttons()) {
            tops.insert(button->y());
        }
        return static_cast<int>(tops.size());
    }

    QWidget host; ///< as wide as wished: a window would keep its row whole
    PageChooser chooser{&host};
    std::vector<QLabel*> pages;
};

TEST_F(PageChooserTest, titlesThatDoNotFitTakeAnotherRow) {
    int widest = 0;
    int all = 0;
    for (const QPushButton* button : buttons()) {
        widest = std::max(widest, button->sizeHint().width());
        all += button->sizeHint().width() + widgets::GridStep_px;
    }
    showAt(all);
    EXPECT_EQ(rows(), 1);
    showAt(all - widest / 2);
    EXPECT_EQ(rows(), 2);
    showAt(widest);
    EXPECT_EQ(rows(), 5);
    EXPECT_LE(chooser.minimumSizeHint().width(), widest);
}

TEST_F(PageChooserTest, aButtonShowsItsPageAndOnlyThat) {
    showAt(900);
    EXPECT_TRUE(pages[0]->isVisible());
    QTest::mouseClick(buttons().at(2), Qt::LeftButton);
    EXPECT_TRUE(pages[2]->isVisible());
    EXPECT_FALSE(pages[0]->isVisible());
    QTest::mouseClick(buttons().at(2), Qt::LeftButton); // again: it stays
    EXPECT_TRUE(pages[2]->isVisible());
    chooser.setPageEnabled(pages[4], false);
    QTest::mouseClick(buttons().at(4), Qt::LeftButton);
    EXPECT_TRUE(pages[2]->isVisible());
    chooser.setCurrent(pages[4]);
    EXPECT_TRUE(pages[4]->isVisible());
    EXPECT_TRUE(buttons().at(4)->isChecked());
}

TEST_F(PageChooserTest, twoPagesStandSideBySideWhereThereIsRoom) {
    const QList<QPushButton*> all = buttons();
    chooser.pairWhenWide(pages[0], pages[1], 800);
    showAt(600);
    EXPECT_TRUE(pages[0]->isVisible());
    EXPECT_FALSE(pages[1]->isVisible());
    QTest::mouseClick(all.at(1), Qt::LeftButton);
    EXPECT_TRUE(pages[1]->isVisible());
    EXPECT_FALSE(pages[0]->isVisible());
    showAt(900);
    EXPECT_TRUE(pages[0]->isVisible());
    EXPECT_TRUE(pages[1]->isVisible());
    EXPECT_FALSE(all.at(1)->isVisible());
    EXPECT_EQ(all.at(0)->text(), "Open loop, Step of 100");
    EXPECT_LE(chooser.minimumSizeHint().width(), 600); // it can become narrow again
    QTest::mouseClick(all.at(3), Qt::LeftButton);
    EXPECT_FALSE(pages[0]->isVisible());
    EXPECT_FALSE(pages[1]->isVisible());
    chooser.setCurrent(pages[1]);
    EXPECT_TRUE(pages[0]->isVisible());
    EXPECT_TRUE(pages[1]->isVisible());
    showAt(600);
    EXPECT_TRUE(pages[0]->isVisible());
    EXPECT_FALSE(pages[1]->isVisible());
    EXPECT_EQ(all.at(0)->text(), "Open loop");
    EXPECT_TRUE(all.at(1)->isVisible());
}

} // namespace
} // namespace halbench::app
