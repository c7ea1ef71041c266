#include "app/workspaces/tune/settings_splitter.h"
#include "tests/widgets/gui_fixture.h"

#include <QtTest/QTest>

namespace halbench::app {
namespace {

class SettingsSplitterTest : public widgets::GuiTest {
protected:
    SettingsSplitterTest() {
        settings->setMinimumWidth(200);
        splitter.setStretchFactor(0, 1); // as the docks do with every splitter
        splitter.resize(900, 300);
        splitter.show();
    }
    bool isAtLeast() {
        return QTest::qWaitFor([&] { return settings->width() == settings->minimumWidth(); });
    }

    QWidget* settings = new QWidget;
    SettingsSplitter splitter{settings, new QWidget};
};

TEST_F(SettingsSplitterTest, picturesGetTheRestOfTheWidth) {
    EXPECT_TRUE(isAtLeast());
    splitter.resize(1400, 300);
    EXPECT_TRUE(isAtLeast());
}

TEST_F(SettingsSplitterTest, movedHandleStays) {
    ASSERT_TRUE(isAtLeast());
    splitter.setSizes({400, 500});
    Q_EMIT splitter.splitterMoved(400, 1);
    splitter.resize(1200, 300);
    QTest::qWait(1); // for what is due
    EXPECT_GE(settings->width(), 400);
}

} // namespace
} // namespace halbench::app
