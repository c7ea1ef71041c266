#include "app/wizards/words_and_pictures.h"
#include "tests/app/workspaces/panel_fixture.h"
#include "widgets/controls/estimate_table.h"

#include <QLabel>

namespace halbench::app {
namespace {

class WordsAndPicturesTest : public PanelTest {
protected:
    WordsAndPicturesTest() {
        table->setRows({{"torque constant", 0.25, 0.24, 0.26, "N*m/A", "identified", {}}});
    }

    widgets::EstimateTable* table = new widgets::EstimateTable;
    QLabel* pictures = new QLabel;
    WordsAndPictures both{table, table, pictures};
};

TEST_F(WordsAndPicturesTest, theTableHasItsWidthAndThePicturesTheRest) {
    show(both, {3 * table->neededWidth(), 300});
    EXPECT_GE(both.sizes().at(0), table->neededWidth());
    EXPECT_LT(both.sizes().at(0), both.width() / 2);
}

TEST_F(WordsAndPicturesTest, thePicturesKeepTwoFifthsOfANarrowWindow) {
    show(both, {table->neededWidth(), 300});
    EXPECT_NEAR(both.sizes().at(1), 0.4 * both.width(), 2.0 + both.handleWidth());
}

TEST_F(WordsAndPicturesTest, whatTheUserSharedStaysUntilThereIsAnotherResult) {
    show(both, {3 * table->neededWidth(), 300});
    const QList<int> first = both.sizes();
    both.setSizes({first.at(0) + 60, first.at(1) - 60});
    both.resize(both.width() + 1, 300);
    EXPECT_GT(both.sizes().at(0), first.at(0) + 30);
    both.shareAnew();
    EXPECT_NEAR(both.sizes().at(0), first.at(0), 1.0);
}

} // namespace
} // namespace halbench::app
