#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/elided_label.h"

namespace halbench::widgets {
namespace {

class ElidedLabelTest : public GuiTest {};

TEST_F(ElidedLabelTest, leavesOutWhatDoesNotFitAndTellsItInTheTooltip) {
    ElidedLabel label(6);
    label.setWords(QStringLiteral("Stopped (by the watchdog)"));
    label.show();
    label.resize(label.sizeHint());
    EXPECT_EQ(label.text(), label.words());
    EXPECT_LT(label.minimumSizeHint().width(), label.sizeHint().width());
    label.resize(label.minimumSizeHint());
    EXPECT_TRUE(label.text().endsWith(QChar(0x2026)));
    EXPECT_EQ(label.toolTip(), label.words());
    label.resize(label.sizeHint());
    EXPECT_EQ(label.text(), label.words()); // comes back
}

TEST_F(ElidedLabelTest, asksForNoMoreThanShortWordsNeed) {
    ElidedLabel label(20);
    label.setWords(QStringLiteral("Idle"));
    EXPECT_EQ(label.minimumSizeHint().width(), label.sizeHint().width());
}

} // namespace
} // namespace halbench::widgets
