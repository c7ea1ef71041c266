#include "app/wizards/result_text.h"
#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/estimate_table.h"

#include <QLabel>

namespace halbench::app {
namespace {

using ResultWordsTest = widgets::GuiTest;

QLabel* labelOf(const QWidget& words, const QString& text) {
    for (auto* label : words.findChildren<QLabel*>()) {
        if (label->text() == text) {
            return label;
        }
    }
    return nullptr;
}

TEST_F(ResultWordsTest, whatIsNotSaidTakesNoRoom) {
    ResultWords words;
    words.setProvenance("from here");
    words.setUse("for this");
    const QLabel* use = labelOf(words, "for this");
    ASSERT_NE(use, nullptr);
    EXPECT_FALSE(use->isHidden());
    words.setUse({});
    EXPECT_TRUE(use->isHidden());
    EXPECT_FALSE(labelOf(words, "from here")->isHidden());
}

TEST_F(ResultWordsTest, aRemarkStandsBetweenTheValuesAndTheirUse) {
    auto* remark = new QLabel("remark");
    ResultWords words(remark);
    words.setUse("for this");
    words.resize(500, 500);
    words.show();
    EXPECT_LT(words.table().mapTo(&words, QPoint()).y(), remark->y());
    EXPECT_LT(remark->y(), labelOf(words, "for this")->y());
}

} // namespace
} // namespace halbench::app
