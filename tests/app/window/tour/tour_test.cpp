#include "app/window/docks/dock_layout.h"
#include "app/window/preferences/language.h"
#include "app/window/tour/tour.h"
#include "app/window/tour/tour_card.h"
#include "app/window/tour/tour_frame.h"
#include "app/window/tour/tour_steps.h"
#include "app/window/window_program.h"
#include "app/workspaces/drive/arm_button.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/stop_button.h"

#include <QLabel>
#include <QMenuBar>
#include <QPushButton>
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockWidget.h>

#include <algorithm>

namespace halbench::app {
namespace {

class TourTest : public WindowTest {
protected:
    void openAt(const QSize& size, const Preferences& preferences = {}) {
        window = makeWindow(application, preferences);
        window->furnish();
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        QApplication::setActiveWindow(window.get());
        for (int time = 0; time < 2; ++time) { // the bar takes its narrow form with the first
            window->resize(size);
            settle();
        }
    }
    void connectTo(const QString& uri) {
        window->connectDevice(uri);
        ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
        settle();
    }
    Tour& tour() { return *window->findChild<Tour*>(); }
    TourCard& card() { return *window->findChild<TourCard*>(); }
    TourFrame& frame() { return *window->findChild<TourFrame*>(); }
    bool isFocusInCard() { return card().isAncestorOf(QApplication::focusWidget()); }
    static void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
    }
    QStringList walk() {
        QStringList ids;
        tour().start();
        while (tour().isRunning()) {
            ids << tour().step().id;
            tour().next();
        }
        return ids;
    }
    QRect placeOf(const QWidget& widget) { return {widget.mapTo(window.get(), QPoint()), widget.size()}; }
    void expectStopFree() {
        int seen = 0;
        for (const auto* stop : window->findChildren<widgets::StopButton*>()) {
            if (stop->isVisible() && stop->window() == window.get()) {
                ++seen;
                EXPECT_FALSE(card().geometry().intersects(placeOf(*stop)));
                EXPECT_EQ(stop->visibleRegion().boundingRect(), stop->rect());
            }
        }
        EXPECT_GT(seen, 0);
    }
    void expectStepInPlace() {
        SCOPED_TRACE(tour().step().id.toStdString());
        EXPECT_TRUE(card().isVisible());
        EXPECT_TRUE(window->rect().contains(card().geometry()));
        EXPECT_TRUE(frame().isVisible());
        EXPECT_TRUE(window->rect().contains(frame().geometry()));
        EXPECT_TRUE(isFocusInCard());
        for (const auto* label : card().findChildren<QLabel*>()) {
            EXPECT_TRUE(label->height() >= label->heightForWidth(label->width()))
                << label->text().toStdString();
            EXPECT_TRUE(card().rect().contains(QRect(label->pos(), label->size())));
        }
        for (const auto* button : card().findChildren<QPushButton*>()) {
            EXPECT_TRUE(card().rect().contains(button->geometry())) << button->text().toStdString();
            EXPECT_GE(button->width(), button->sizeHint().width()) << button->text().toStdString();
        }
        const QString panel = tour().step().panel;
        if (!panel.isEmpty()) {
            EXPECT_TRUE(window->docks().panel(panel)->isVisible());
            const QWidget* shown = window->docks().docks().value(panel)->dockAreaWidget();
            if (!tour().step().part.isEmpty()) {
                shown = window->docks().panel(panel)->findChild<QWidget*>(tour().step().part);
                ASSERT_NE(shown, nullptr);
            }
            const QWidget* seen = window->docks().widget()->parentWidget(); // it may scroll
            const QRect expected = placeOf(*shown) & placeOf(*seen);
            EXPECT_TRUE(frame().geometry().contains(expected));
            constexpr int Air_px = 8; // around a part; a dock area is framed at its edge
            EXPECT_LE(frame().width(), expected.width() + (tour().step().part.isEmpty() ? 0 : 2 * Air_px));
        }
        expectStopFree();
    }
};

TEST_F(TourTest, hasEveryStepWhileNothingIsConnected) {
    openAt({1358, 728});
    QStringList all;
    for (const TourStep& step : tourSteps()) {
        all << step.id;
        EXPECT_FALSE(step.title.isEmpty());
        EXPECT_TRUE(step.panel.isEmpty() || window->docks().docks().contains(step.panel))
            << step.id.toStdString();
    }
    EXPECT_EQ(walk(), all);
}

TEST_F(TourTest, followsWhatTheActuatorHas) {
    const std::vector<std::pair<const char*, QStringList>> cases{
        {"sim:htm", {"monitor", "drive", "calibrate", "identify", "tune", "record", "help"}},
        {"sim:planar", {"monitor", "drive", "calibrate", "identify", "tune", "record", "help"}},
        {"sim:spherical", {"monitor", "calibrate", "record", "help"}}};
    for (const auto& [uri, steps] : cases) {
        SCOPED_TRACE(uri);
        openAt({952, 500}); // 960x540 without the desktop's frame
        connectTo(uri);
        tour().start();
        for (const QString& id : steps) {
            ASSERT_TRUE(tour().isRunning());
            EXPECT_EQ(tour().step().id, id);
            settle();
            expectStepInPlace();
            tour().next();
        }
        EXPECT_FALSE(tour().isRunning());
        EXPECT_FALSE(session().report().board.isArmed);
        EXPECT_EQ(session().procedure(), QString());
        window.reset();
    }
}

TEST_F(TourTest, fitsASmallWindowInEveryLanguage) {
    for (const char* language : {"de", "zh_CN", "en"}) {
        SCOPED_TRACE(language);
        Preferences preferences;
        preferences.language = language;
        openAt({952, 500}, preferences);
        tour().start();
        while (tour().isRunning()) {
            settle();
            expectStepInPlace();
            tour().next();
        }
        window.reset();
    }
    speak(application, "en");
}

TEST_F(TourTest, followsTheWindowWhenItIsResized) {
    openAt({1358, 728});
    tour().start();
    window->resize(952, 500);
    settle();
    expectStepInPlace();
    window->resize(1900, 1100);
    settle();
    expectStepInPlace();
}

TEST_F(TourTest, keysGoOnAndBackAndEscapeLeaves) {
    openAt({1358, 728});
    tour().start();
    press(Qt::Key_Right);
    EXPECT_EQ(tour().step().id, "monitor");
    press(Qt::Key_Return);
    EXPECT_EQ(tour().step().id, "drive");
    press(Qt::Key_Left);
    EXPECT_EQ(tour().step().id, "monitor");
    press(Qt::Key_Up);
    press(Qt::Key_Up); // the first step has none before it
    EXPECT_EQ(tour().step().id, "connect");
    press(Qt::Key_Escape);
    EXPECT_FALSE(tour().isRunning());
    EXPECT_FALSE(card().isVisible());
    EXPECT_FALSE(frame().isVisible());
    EXPECT_EQ(QApplication::focusWidget(), window->docks().widget()) << "where no key does anything";
}

TEST_F(TourTest, escapeStopsNothingWhereNothingMoves) {
    openAt({1358, 728});
    connectTo("sim:htm");
    ASSERT_TRUE(wait([&] { return window->bench().drive().isNothingToStop(); }));
    tour().start();
    press(Qt::Key_Escape);
    EXPECT_FALSE(tour().isRunning());
    EXPECT_FALSE(window->bench().stopLatch().isLatched());
    EXPECT_FALSE(session().report().board.isStopLatched);
}

TEST_F(TourTest, tabStaysInTheCardAtEveryStep) {
    openAt({1358, 728});
    connectTo("sim:htm");
    tour().start();
    while (tour().isRunning()) {
        for (const Qt::Key key : {Qt::Key_Tab, Qt::Key_Tab, Qt::Key_Tab, Qt::Key_Tab, Qt::Key_Backtab,
                                  Qt::Key_Backtab, Qt::Key_Backtab, Qt::Key_Backtab}) {
            press(key);
            ASSERT_TRUE(isFocusInCard()) << tour().step().id.toStdString();
        }
        tour().next();
    }
}

TEST_F(TourTest, shiftF1LeadsToThePanelNeverToWhatMovesAndBack) {
    openAt({1358, 728});
    connectTo("sim:htm");
    tour().start();
    while (tour().isRunning()) {
        SCOPED_TRACE(tour().step().id.toStdString());
        const QString panel = tour().step().panel;
        if (!panel.isEmpty()) {
            press(Qt::Key_F1, Qt::ShiftModifier);
            settle();
            QWidget* focus = QApplication::focusWidget();
            ASSERT_NE(focus, nullptr);
            EXPECT_TRUE(window->docks().panel(panel)->isAncestorOf(focus));
            EXPECT_EQ(qobject_cast<ArmButton*>(focus), nullptr);
            if (const auto* button = qobject_cast<const QAbstractButton*>(focus)) {
                for (const char* word : {"Start", "Go", "Apply", "Arm"}) {
                    EXPECT_FALSE(button->text().remove('&').startsWith(word)) << button->text().toStdString();
                }
            }
            press(Qt::Key_F1, Qt::ShiftModifier);
            settle();
            EXPECT_TRUE(isFocusInCard());
        }
        tour().next();
    }
}

TEST_F(TourTest, theStepOfConnectingIsDoneWhenADeviceIsThere) {
    openAt({1358, 728});
    tour().start();
    ASSERT_EQ(tour().step().id, "connect");
    connectTo("sim:spherical");
    EXPECT_EQ(tour().step().id, "monitor");
    settle();
    expectStepInPlace();
    tour().next();
    EXPECT_EQ(tour().step().id, "calibrate") << "there is no drive";
    session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    settle();
    EXPECT_EQ(tour().step().id, "calibrate") << "it stays where it is";
    tour().back();
    EXPECT_EQ(tour().step().id, "drive") << "without a device every panel is there";
}

TEST_F(TourTest, isInTheHelpMenuAndOnTheStartPage) {
    openAt({1358, 728});
    const auto* page = window->docks().panel("devices");
    const auto buttons = page->findChildren<QPushButton*>();
    const auto found = std::find_if(buttons.begin(), buttons.end(),
                                    [](const auto* one) { return one->text() == "Five-minute tour"; });
    ASSERT_NE(found, buttons.end());
    (*found)->click();
    EXPECT_TRUE(tour().isRunning());
    tour().leave();
    int actions = 0;
    for (QAction* action : window->findChildren<QAction*>()) {
        if (action->text() == "Five-minute &tour") {
            ++actions;
            EXPECT_EQ(action->shortcut(), QKeySequence("Shift+F1"));
            action->trigger();
        }
    }
    EXPECT_EQ(actions, 1);
    EXPECT_TRUE(tour().isRunning());
}

TEST_F(TourTest, aPanelThatIsClosedMeanwhileHasNoFrame) {
    openAt({1358, 728});
    tour().start();
    tour().next();
    tour().next();
    ASSERT_EQ(tour().step().id, "drive");
    settle();
    ASSERT_TRUE(frame().isVisible());
    window->docks().docks().value("drive")->toggleView(false);
    settle();
    EXPECT_FALSE(frame().isVisible());
    EXPECT_TRUE(card().isVisible());
}

// A floating panel that the frame was drawn on is deleted when another arrangement is chosen.
TEST_F(TourTest, frameComesHomeBeforeItsPanelGoes) {
    QWidget home;
    auto floating = std::make_unique<QWidget>();
    floating->resize(200, 100);
    const QPointer<TourFrame> drawn = new TourFrame(&home);
    drawn->surround(*floating, {10, 10, 50, 50});
    EXPECT_EQ(drawn->parentWidget(), floating.get());
    drawn->surround(home, {});
    floating.reset();
    ASSERT_FALSE(drawn.isNull());
    EXPECT_EQ(drawn->parentWidget(), &home);
    EXPECT_FALSE(drawn->isVisible());
}

} // namespace
} // namespace halbench::app
