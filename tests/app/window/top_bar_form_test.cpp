#include "app/window/connect_button.h"
#include "app/window/record_button.h"
#include "app/workspaces/drive/arm_button.h"
#include "app/workspaces/drive/mode_box.h"
#include "tests/app/window/top_bar_fixture.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace halbench::app {
namespace {

// What the bar looks like in each width and state.

TEST_F(TopBarTest, isNarrowWhereTheWindowIsAndItsKeysStay) {
    const auto theme = widgets::loadTheme("light"); // the program's letters
    ASSERT_TRUE(theme);
    widgets::applyTheme(application, *theme, {QLocale(), widgets::Dress().fontSize_pt});
    open();
    window->resize(window->minimumSizeHint().expandedTo({1280, 0}));
    QTest::qWait(0);
    EXPECT_LE(window->width(), 1280);
    EXPECT_NE(perspective("Tune"), nullptr);
    QWidget narrow;
    TopBar bar(window->bench(), &narrow);
    std::optional<Perspective> chosen;
    QObject::connect(&bar, &TopBar::perspectiveChosen,
                     [&chosen](Perspective perspective) { chosen = perspective; });
    narrow.show();
    bar.resize(bar.minimumSizeHint());
    const auto buttons = bar.findChild<PerspectiveBar*>()->findChildren<QToolButton*>();
    EXPECT_EQ(std::count_if(buttons.begin(), buttons.end(),
                            [](const QToolButton* button) { return button->isVisible(); }),
              1); // a menu now
    QApplication::setActiveWindow(&narrow);
    QTest::keyClick(&narrow, Qt::Key_3, Qt::ControlModifier);
    EXPECT_EQ(chosen, Perspective::Tune);
}

TEST_F(TopBarTest, takesTheFormOfItsWidthAtOnce) {
    open();
    const auto hasMenu = [this] { return perspective("Monitor") == nullptr; };
    const auto resize = [this](const QSize& size) {
        window->resize(size);
        QTest::qWait(0);
    };
    resize(window->minimumSizeHint());
    EXPECT_TRUE(hasMenu());
    resize({1700, 900});
    EXPECT_FALSE(hasMenu());
    resize(window->minimumSizeHint());
    EXPECT_TRUE(hasMenu());
    resize(window->minimumSizeHint().expandedTo({1440, 0}));
    const bool atOnce = hasMenu();
    for (int pass = 0; pass < 3; ++pass) { // no event between brings another form
        QTest::qWait(0);
        EXPECT_EQ(hasMenu(), atOnce) << pass;
    }
}

TEST_F(TopBarTest, hasItsWordsWhereTheWindowFillsASmallScreen) {
    const auto theme = widgets::loadTheme("light"); // the program's letters
    ASSERT_TRUE(theme);
    widgets::applyTheme(application, *theme, {QLocale(), widgets::Dress().fontSize_pt});
    open();
    window->resize(1431, 859); // what a screen of 1440 x 900 leaves
    QTest::qWait(0);
    QTest::qWait(0);
    EXPECT_EQ(inBar<ConnectButton>()->toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
    EXPECT_NE(perspective("Tune"), nullptr);
    EXPECT_EQ(inBar<RecordButton>()->text(), "Record data");
}

/// Counts how often a layout is asked to arrange itself anew.
class LayoutCount : public QObject {
public:
    bool eventFilter(QObject* receiver, QEvent* event) override {
        if (event->type() == QEvent::LayoutRequest) {
            ++requests;
        }
        return QObject::eventFilter(receiver, event);
    }
    int requests = 0;
};

TEST_F(TopBarTest, aWindowAtRestArrangesNothing) {
    // A layout that asks for itself again in answer to a request keeps a core busy for ever.
    open();
    for (const int width_px : {1280, 1440, 1700}) {
        window->resize(window->minimumSizeHint().expandedTo({width_px, 900}));
        for (int pass = 0; pass < 10; ++pass) { // docks settle in a few turns
            QTest::qWait(0);
        }
        LayoutCount count;
        application.installEventFilter(&count);
        for (int pass = 0; pass < 20; ++pass) {
            QTest::qWait(0);
        }
        application.removeEventFilter(&count);
        EXPECT_EQ(count.requests, 0) << width_px;
    }
}

TEST_F(TopBarTest, nothingMovesWhenTheStateChanges) {
    const auto theme = widgets::loadTheme("light"); // the program's letters
    ASSERT_TRUE(theme);
    widgets::applyTheme(application, *theme, {QLocale(), widgets::Dress().fontSize_pt});
    open();
    window->resize(1280, 800);
    QTest::qWait(0);
    const auto places = [this] {
        std::vector<QRect> all;
        for (QWidget* control :
             std::initializer_list<QWidget*>{inBar<ConnectButton>(), inBar<ArmButton>(), inBar<ModeBox>(),
                                             inBar<RecordButton>(), inBar<PerspectiveBar>()}) {
            all.push_back(control->geometry());
        }
        return all;
    };
    const auto atFirst = places();
    connectMotor(1.0);
    QTest::qWait(0);
    EXPECT_EQ(places(), atFirst) << "connected";
    ASSERT_TRUE(wait([&] { return inBar<ArmButton>()->isEnabled(); }));
    QTest::mouseClick(inBar<ArmButton>(), Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return isArmed(); }));
    QTest::qWait(0);
    EXPECT_EQ(places(), atFirst) << "armed";
    key(Qt::Key_Escape, Qt::NoModifier);
    ASSERT_TRUE(wait([&] { return window->bench().stopLatch().isLatched(); }));
    QTest::qWait(0);
    EXPECT_EQ(places(), atFirst) << "stopped";
}

} // namespace
} // namespace halbench::app
