#include "app/window/docks/dock_layout.h"
#include "app/window/docks/dock_menu.h"
#include "app/window/docks/dock_moves.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/stop_button.h"

#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QSet>
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockContainerWidget.h>
#include <qtadvanceddocking/DockManager.h>
#include <qtadvanceddocking/DockWidget.h>
#include <qtadvanceddocking/FloatingDockContainer.h>

// Panels arranged without a mouse.

namespace halbench::app {
namespace {

constexpr Qt::KeyboardModifiers ArrangeKeys = Qt::AltModifier | Qt::ShiftModifier;

class DockKeysTest : public WindowTest {
protected:
    /// The window with the focus in a panel; the platform without a screen gives no window the focus.
    void openAt(const char* id) {
        open();
        window->resize(2000, 1000); // no panel is as narrow as it can be
        for (const char* each : {"signals", "parameters", "record", "drive", "derived", "notes", "log"}) {
            window->docks().raise(each);
        }
        window->docks().raise("monitor");
        settle(); // its parts get their room
        QApplication::setActiveWindow(window.get());
        window->docks().raise(id);
        enter(id);
    }

    void enter(const char* id) {
        QWidget* panel = window->docks().panel(id);
        for (QWidget* next = panel->nextInFocusChain(); next != panel; next = next->nextInFocusChain()) {
            if (panel->isAncestorOf(next) && next->isVisible() && next->isEnabled() &&
                (next->focusPolicy() & Qt::TabFocus) != 0) {
                next->setFocus();
                ASSERT_EQ(QApplication::focusWidget(), next);
                return;
            }
        }
        FAIL() << id << " takes no focus";
    }

    /// To what has the focus, as a keyboard does.
    static void press(Qt::Key key, Qt::KeyboardModifiers modifiers = ArrangeKeys) {
        ASSERT_NE(QApplication::focusWidget(), nullptr);
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
        QTest::qWait(0);
    }
    static void pressFloat() { press(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier); }

    ads::CDockWidget& dock(const char* id) { return *window->docks().docks().value(id); }
    bool hasFocus(const char* id) { return dock(id).isAncestorOf(QApplication::focusWidget()); }
    bool areTogether(const char* one, const char* other) {
        return dock(one).dockAreaWidget() == dock(other).dockAreaWidget();
    }
    QRect place(const char* id) {
        const QWidget& area = *dock(id).dockAreaWidget();
        return {area.mapTo(window.get(), QPoint()), area.size()};
    }
    QByteArray arrangement() { return window->docks().arrangements().value("monitor"); }

    /// Floated and docked again it is where it was, with the focus where it was. Among tabs it comes last, as
    /// by the mouse.
    void expectThereAndBack(const char* id) {
        SCOPED_TRACE(id);
        enter(id);
        const QWidget* focus = QApplication::focusWidget();
        const QRect before = place(id);
        const QList<ads::CDockWidget*> together = dock(id).dockAreaWidget()->openedDockWidgets();
        pressFloat();
        ASSERT_TRUE(dock(id).isFloating());
        EXPECT_EQ(QApplication::focusWidget(), focus);
        auto* stop = dock(id).floatingDockContainer()->findChild<widgets::StopButton*>();
        ASSERT_NE(stop, nullptr);
        EXPECT_TRUE(wait([&] { return stop->isVisible(); }));
        pressFloat();
        EXPECT_FALSE(dock(id).isInFloatingContainer());
        EXPECT_EQ(QApplication::focusWidget(), focus);
        QTest::qWait(0);
        EXPECT_EQ(place(id), before);
        const QList<ads::CDockWidget*> again = dock(id).dockAreaWidget()->openedDockWidgets();
        EXPECT_EQ(QSet<ads::CDockWidget*>(again.begin(), again.end()),
                  QSet<ads::CDockWidget*>(together.begin(), together.end()));
    }
};

TEST_F(DockKeysTest, aPanelFloatsWithItsStopAndComesBackToItsPlace) {
    openAt("signals");
    ASSERT_EQ(dock("signals").dockAreaWidget()->openDockWidgetsCount(), 1); // alone in its area
    ASSERT_GT(dock("drive").dockAreaWidget()->openDockWidgetsCount(), 1);   // among others
    for (const char* id : {"signals", "drive", "monitor", "notes"}) {
        dock(id).setAsCurrentTab();
        expectThereAndBack(id);
    }
}

TEST_F(DockKeysTest, aPanelThatIsAfloatSinceTheLastSessionComesBackToItsFirstPlace) {
    openAt("drive");
    pressFloat();
    const QByteArray afloat = arrangement();
    window.reset();
    open();
    window->docks().setArrangements({{"monitor", afloat}});
    ASSERT_TRUE(dock("drive").isFloating());
    QApplication::setActiveWindow(dock("drive").floatingDockContainer());
    enter("drive");
    pressFloat();
    EXPECT_TRUE(areTogether("drive", "parameters"));
}

TEST_F(DockKeysTest, aPanelMovesBehindTheNextOneOnEachSide) {
    openAt("signals");
    press(Qt::Key_Right);
    EXPECT_TRUE(areTogether("signals", "monitor"));
    EXPECT_EQ(dock("signals").dockAreaWidget()->currentDockWidget(), &dock("signals"));
    EXPECT_TRUE(hasFocus("signals"));
    press(Qt::Key_Right);
    EXPECT_TRUE(areTogether("signals", "drive"));
    press(Qt::Key_Left);
    press(Qt::Key_Down);
    EXPECT_TRUE(areTogether("signals", "log"));
    press(Qt::Key_Up);
    EXPECT_TRUE(hasFocus("signals"));
    EXPECT_FALSE(areTogether("signals", "log"));
}

TEST_F(DockKeysTest, whereNoPanelIsNextItGoesAlongTheEdgeAndStaysThere) {
    openAt("drive");
    press(Qt::Key_Right);
    EXPECT_FALSE(areTogether("drive", "parameters"));
    EXPECT_EQ(dock("drive").dockAreaWidget()->openDockWidgetsCount(), 1);
    EXPECT_GT(place("drive").left(), place("parameters").right());
    EXPECT_GE(place("drive").height(), window->docks().widget()->height() - 2);
    EXPECT_TRUE(hasFocus("drive"));
    const QByteArray there = arrangement();
    press(Qt::Key_Right);
    EXPECT_EQ(arrangement().toStdString(), there.toStdString());
}

TEST_F(DockKeysTest, aPanelGrowsAndShrinksAtTheCostOfItsNeighbour) {
    openAt("drive");
    const QRect before = place("drive");
    const QRect centre = place("monitor");
    press(Qt::Key_End);
    EXPECT_GT(place("drive").width(), before.width());
    EXPECT_LT(place("monitor").width(), centre.width());
    EXPECT_EQ(place("drive").width() + place("monitor").width(), before.width() + centre.width());
    press(Qt::Key_Home);
    EXPECT_EQ(place("drive"), before);
    enter("signals");
    const QRect signalList = place("signals");
    press(Qt::Key_PageUp);
    EXPECT_LT(place("signals").height(), signalList.height());
    press(Qt::Key_PageDown);
    EXPECT_EQ(place("signals"), signalList);
}

TEST_F(DockKeysTest, aPanelAfloatMovesAndGrowsAsAWindow) {
    openAt("log");
    pressFloat();
    QWidget* afloat = dock("log").floatingDockContainer();
    ASSERT_NE(afloat, nullptr);
    afloat->resize(400, 300); // smaller than the screen
    afloat->move(100, 100);
    const QRect before = afloat->geometry();
    press(Qt::Key_Right);
    press(Qt::Key_Down);
    EXPECT_GT(afloat->x(), before.x());
    EXPECT_GT(afloat->y(), before.y());
    EXPECT_EQ(afloat->size(), before.size());
    press(Qt::Key_End);
    EXPECT_GT(afloat->width(), before.width());
    for (int i = 0; i < 100; ++i) {
        press(Qt::Key_Left);
        press(Qt::Key_Up);
    }
    EXPECT_TRUE(afloat->screen()->availableGeometry().contains(afloat->pos()));
}

/// Alt+V and the menu's own keys: which panel it is about is said.
TEST_F(DockKeysTest, theMenuNamesThePanelAndEveryKeyInItsTooltips) {
    openAt("devices");
    enter("drive");
    QMenu* arrange = nullptr;
    for (QMenu* menu : window->menuBar()->findChildren<QMenu*>()) {
        arrange = menu->title().startsWith("P&anel layout") ? menu : arrange;
    }
    ASSERT_NE(arrange, nullptr);
    Q_EMIT arrange->aboutToShow();
    EXPECT_TRUE(arrange->title().contains("Drive")) << arrange->title().toStdString();
    int keys = 0;
    for (const QAction* action : arrange->actions()) {
        if (!action->isSeparator()) {
            EXPECT_FALSE(action->shortcut().isEmpty()) << action->text().toStdString();
            EXPECT_TRUE(action->toolTip().contains(action->shortcut().toString()))
                << action->toolTip().toStdString();
            ++keys;
        }
    }
    EXPECT_EQ(keys, 11);
    EXPECT_TRUE(arrange->toolTipsVisible());
    arrange->actions().first()->trigger();
    EXPECT_TRUE(dock("drive").isFloating());
    ASSERT_TRUE(wait([&] { return hasFocus("drive"); }));
    Q_EMIT arrange->aboutToShow();
    EXPECT_EQ(arrange->actions().first()->text(), "Dock it &back");
}

TEST_F(DockKeysTest, theTabsOfAnAreaAreGoneThroughByKeyWithTheFocus) {
    openAt("drive");
    const ads::CDockAreaWidget& area = *dock("drive").dockAreaWidget();
    const QList<ads::CDockWidget*> tabs = area.openedDockWidgets();
    ASSERT_GE(tabs.size(), 3);
    const int begin = static_cast<int>(tabs.indexOf(&dock("drive")));
    const int count = static_cast<int>(tabs.size());
    for (int step = 1; step <= count; ++step) {
        press(Qt::Key_PageDown, Qt::ControlModifier);
        ads::CDockWidget* wanted = tabs[(begin + step) % count];
        EXPECT_EQ(area.currentDockWidget(), wanted);
        EXPECT_TRUE(wanted->isAncestorOf(QApplication::focusWidget())) << step;
    }
    press(Qt::Key_PageUp, Qt::ControlModifier);
    EXPECT_EQ(area.currentDockWidget(), tabs[(begin - 1 + count) % count]);
    EXPECT_EQ(area.openedDockWidgets(), tabs) << "nothing is closed";
}

TEST_F(DockKeysTest, ofAPanelThatWasClosedTheKeysDoNothing) {
    openAt("devices");
    dock("notes").setAsCurrentTab();
    enter("notes");
    window->docks().widget()->setFocus(); // in no panel
    dock("notes").toggleView(false);
    const QByteArray closed = arrangement();
    QTest::keyClick(window.get(), Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    QTest::keyClick(window.get(), Qt::Key_Left, ArrangeKeys);
    QTest::keyClick(window.get(), Qt::Key_End, ArrangeKeys);
    EXPECT_EQ(arrangement().toStdString(), closed.toStdString());
}

} // namespace
} // namespace halbench::app
