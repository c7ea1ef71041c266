#include "app/window/docks/dock_layout.h"
#include "app/window/focus_fallback.h"
#include "app/workbench/drive_control.h"
#include "app/workspaces/monitor/trigger_bar.h"
#include "tests/app/window/window_test.h"
#include "widgets/live_plot/live_plot.h"

#include <QAbstractButton>
#include <QDialog>
#include <QHideEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <qtadvanceddocking/DockWidget.h>

namespace halbench::app {
namespace {

bool isSafe(const QWidget* focus) {
    return focus == nullptr || (focus->isVisible() && qobject_cast<const QAbstractButton*>(focus) == nullptr);
}

std::string nameOf(const QObject* object) {
    return object == nullptr
               ? "nothing"
               : std::string(object->metaObject()->className()) + ' ' + object->objectName().toStdString();
}

/// Where the keys go after what had them is gone, in the whole window.
class FocusFallbackTest : public WindowTest {
protected:
    void openActive() {
        open();
        QApplication::setActiveWindow(window.get());
    }

    std::vector<QPointer<QWidget>> focusable() const {
        std::vector<QPointer<QWidget>> found;
        for (QWidget* widget : window->findChildren<QWidget*>()) {
            if (widget->isVisible() && widget->isEnabled() && widget->focusPolicy() != Qt::NoFocus &&
                widget->window() == window.get()) {
                found.emplace_back(widget);
            }
        }
        return found;
    }
};

TEST_F(FocusFallbackTest, noHiddenContainerGivesItsKeysToAButton) {
    openActive();
    connectMotor(1.0);
    for (const auto perspective : {Perspective::Monitor, Perspective::Identify, Perspective::Tune,
                                   Perspective::Record, Perspective::Field}) {
        window->docks().setPerspective(perspective);
        QApplication::processEvents();
        for (const QPointer<QWidget>& widget : focusable()) {
            if (!widget || !widget->isVisible()) {
                continue;
            }
            for (QWidget* part = widget; part != nullptr && !part->isWindow(); part = part->parentWidget()) {
                widget->setFocus();
                if (QApplication::focusWidget() != widget) {
                    continue; // it cannot have the keys now
                }
                part->hide();
                EXPECT_TRUE(isSafe(QApplication::focusWidget()))
                    << nameOf(part) << " hidden, " << nameOf(widget)
                    << " had the keys: " << nameOf(QApplication::focusWidget());
                part->show();
            }
        }
    }
}

// T shows the trigger's settings, T hides them again with the keys in one of them, and Space comes next. (T
// itself goes to the plot, as from its menu: in a list it chooses.)
TEST_F(FocusFallbackTest, theTriggersSettingsThatGoArmNothing) {
    openActive();
    connectMotor(1.0);
    window->docks().setPerspective(Perspective::Monitor);
    QWidget* monitor = window->docks().panel("monitor");
    ASSERT_NE(monitor, nullptr);
    auto* bar = monitor->findChild<TriggerBar*>();
    ASSERT_NE(bar, nullptr);
    auto* plot = monitor->findChild<widgets::LivePlot*>();
    ASSERT_NE(plot, nullptr);
    plot->setFocus();
    QTest::keyClick(plot, Qt::Key_T);
    ASSERT_TRUE(bar->isVisible());
    int tried = 0;
    for (QWidget* setting : bar->findChildren<QWidget*>()) {
        if (!setting->isVisible() || setting->focusPolicy() == Qt::NoFocus) {
            continue;
        }
        setting->setFocus();
        if (QApplication::focusWidget() != setting) {
            continue;
        }
        ++tried;
        QTest::keyClick(plot, Qt::Key_T);
        ASSERT_FALSE(bar->isVisible());
        QWidget* focus = QApplication::focusWidget();
        EXPECT_TRUE(isSafe(focus)) << nameOf(setting) << ": " << nameOf(focus);
        QTest::keyClick(focus == nullptr ? window.get() : focus, Qt::Key_Space);
        settle();
        EXPECT_FALSE(session().report().board.isArmed) << nameOf(setting);
        QTest::keyClick(plot, Qt::Key_T);
        ASSERT_TRUE(bar->isVisible());
    }
    EXPECT_GE(tried, 3);
}

TEST_F(FocusFallbackTest, noHiddenPartOfOtherActuatorsGivesItsKeysToAButton) {
    openActive();
    for (const char* uri : {"sim:planar", "sim:spherical"}) {
        window->connectDevice(uri);
        ASSERT_TRUE(wait(
            [&] { return session().state() == SessionState::Connected && session().info().uri == uri; }));
        int tried = 0;
        for (const QPointer<QWidget>& widget : focusable()) {
            QWidget* part = widget ? widget->parentWidget() : nullptr;
            if (part == nullptr || part->isWindow()) {
                continue;
            }
            for (const bool isHidden : {false, true}) {
                widget->setFocus();
                if (QApplication::focusWidget() != widget) {
                    continue;
                }
                ++tried;
                isHidden ? part->hide() : part->setEnabled(false);
                EXPECT_TRUE(isSafe(QApplication::focusWidget()))
                    << uri << ": " << nameOf(part) << ", " << nameOf(widget)
                    << " had the keys: " << nameOf(QApplication::focusWidget());
                isHidden ? part->show() : part->setEnabled(true);
            }
        }
        EXPECT_GE(tried, 20) << uri;
    }
}

TEST_F(FocusFallbackTest, noDisabledContainerGivesItsKeysToAButton) {
    openActive();
    connectMotor(1.0);
    for (const QPointer<QWidget>& widget : focusable()) {
        for (QWidget* part = widget; part != nullptr && !part->isWindow(); part = part->parentWidget()) {
            widget->setFocus();
            if (QApplication::focusWidget() != widget) {
                continue;
            }
            part->setEnabled(false);
            EXPECT_TRUE(isSafe(QApplication::focusWidget()))
                << nameOf(part) << " disabled: " << nameOf(QApplication::focusWidget());
            part->setEnabled(true);
        }
    }
}

TEST_F(FocusFallbackTest, closedAndFloatedPanelsGiveTheirKeysToNoButton) {
    openActive();
    connectMotor(1.0);
    for (ads::CDockWidget* dock : window->docks().docks()) {
        for (const bool isFloated : {false, true}) {
            dock->toggleView(true);
            dock->raise();
            QApplication::processEvents();
            QWidget* inside = dock->widget()->findChild<QAbstractButton*>();
            if (inside == nullptr || !inside->isVisible()) {
                continue;
            }
            inside->setFocus();
            if (isFloated) {
                dock->setFloating();
                QApplication::processEvents();
            }
            dock->toggleView(false);
            QApplication::processEvents();
            EXPECT_TRUE(isSafe(QApplication::focusWidget()))
                << nameOf(dock) << (isFloated ? " floated, closed: " : " closed: ")
                << nameOf(QApplication::focusWidget());
        }
    }
    EXPECT_FALSE(session().report().board.isArmed);
}

/// A bar that hides gives its keys back to the field with which the user worked before, not to the next
/// button.
TEST_F(FocusFallbackTest, theFieldOfTheSamePanelGetsTheKeysBack) {
    QWidget home;
    QVBoxLayout layout(&home);
    QWidget panel;
    QVBoxLayout inside(&panel);
    QLineEdit plot;
    QPushButton settings;
    QPushButton arm;
    QWidget bar;
    QVBoxLayout barLayout(&bar);
    barLayout.addWidget(&settings);
    inside.addWidget(&plot);
    inside.addWidget(&bar);
    layout.addWidget(&panel);
    layout.addWidget(&arm);
    const FocusFallback fallback(home, nullptr);
    home.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&home));
    QApplication::setActiveWindow(&home);
    plot.setFocus();
    settings.setFocus();
    bar.hide();
    EXPECT_EQ(QApplication::focusWidget(), &plot);
    bar.show();
    settings.setFocus();
    settings.setEnabled(false);
    EXPECT_NE(QApplication::focusWidget(), &arm);
    settings.setEnabled(true);
    plot.setFocus();
    QTest::keyClick(&plot, Qt::Key_Tab); // by Tab the next one, as ever
    EXPECT_EQ(QApplication::focusWidget(), &settings);
    for (QWidget* part : {static_cast<QWidget*>(&plot), static_cast<QWidget*>(&settings),
                          static_cast<QWidget*>(&bar), &panel, static_cast<QWidget*>(&arm)}) {
        part->setParent(nullptr); // they live on this function's stack
    }
}

/// A dialog that closes gives its keys back to the field with which the user worked before it.
TEST_F(FocusFallbackTest, aDialogThatClosesGivesTheKeysBackToTheFieldBefore) {
    QWidget place;
    auto* layout = new QVBoxLayout(&place);
    auto* home = new QWidget;
    auto* plot = new QLineEdit;
    auto* arm = new QPushButton;
    for (QWidget* part : {home, static_cast<QWidget*>(plot), static_cast<QWidget*>(arm)}) {
        layout->addWidget(part);
    }
    const FocusFallback fallback(*home, nullptr);
    place.show();
    QApplication::setActiveWindow(&place);
    plot->setFocus();
    QDialog dialog(&place);
    auto* field = new QLineEdit(&dialog);
    dialog.show();
    QApplication::setActiveWindow(&dialog);
    field->setFocus();
    ASSERT_EQ(QApplication::focusWidget(), field);
    QHideEvent hidden; // as on X11, where a window that hides loses the focus later
    QApplication::sendEvent(&dialog, &hidden);
    EXPECT_EQ(place.focusWidget(), plot); // when the desktop makes it the active window
}

/// A stack gives the focus of the page that goes to the first widget of the one that comes.
TEST_F(FocusFallbackTest, aPageThatGoesGivesItsKeysToNoButtonOfTheNext) {
    QStackedWidget pages;
    auto* plot = new QLineEdit;
    auto* start = new QPushButton;
    for (QWidget* part : {static_cast<QWidget*>(plot), static_cast<QWidget*>(start)}) {
        auto* page = new QWidget;
        (new QVBoxLayout(page))->addWidget(part);
        pages.addWidget(page);
    }
    const FocusFallback fallback(pages, nullptr);
    pages.show();
    QApplication::setActiveWindow(&pages);
    plot->setFocus();
    ASSERT_EQ(QApplication::focusWidget(), plot);
    pages.setCurrentIndex(1);
    EXPECT_TRUE(isSafe(QApplication::focusWidget())) << nameOf(QApplication::focusWidget());
    start->setFocus(); // on purpose
    EXPECT_EQ(QApplication::focusWidget(), start);
}

} // namespace
} // namespace halbench::app
