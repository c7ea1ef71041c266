#include "tests/widgets/gui_fixture.h"
#include "widgets/language/translated_text.h"

#include <QEvent>
#include <QWidget>

#include <memory>

namespace halbench::widgets {
namespace {

class SayWordsTest : public GuiTest {};

TEST_F(SayWordsTest, saysNowAndWithEveryLanguageAlsoInsideAnotherWidget) {
    QWidget window;
    auto* child = new QWidget(&window);
    int said = 0;
    sayWords(*child, [&said] { ++said; });
    EXPECT_EQ(said, 1);
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(&window, &change);
    EXPECT_EQ(said, 2);
    delete child;
    QCoreApplication::sendEvent(&window, &change);
    EXPECT_EQ(said, 2);
}

} // namespace
} // namespace halbench::widgets
