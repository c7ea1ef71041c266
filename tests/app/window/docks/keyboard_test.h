#pragma once

#include "app/window/docks/dock_layout.h"
#include "app/workspaces/device/device_panel.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/stop_button.h"

#include <QAbstractButton>
#include <QLabel>
#include <QListWidget>

#include <algorithm>
#include <string>

namespace halbench::app {

/// A user without a mouse: every key goes to whatever has the focus.
class KeyboardTest : public WindowTest {
protected:
    static void press(Qt::Key code, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QWidget* focused = QApplication::focusWidget();
        ASSERT_NE(focused, nullptr);
        EXPECT_EQ(qobject_cast<widgets::StopButton*>(focused), nullptr); // only on purpose
        QTest::keyClick(focused, code, modifiers);
    }
    static QString focusedText() {
        const auto* button = qobject_cast<QAbstractButton*>(QApplication::focusWidget());
        return button != nullptr ? button->text().remove(QLatin1Char('&')) : QString();
    }
    /// With Tab, past STOP too: that is where it may be reached.
    template <typename Reached>
    static bool tabUntil(Reached isReached) {
        constexpr int MostStops = 200;
        for (int i = 0; i < MostStops && !isReached(QApplication::focusWidget()); ++i) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        }
        return isReached(QApplication::focusWidget());
    }
    static void tabTo(const QString& text) {
        ASSERT_TRUE(tabUntil([&](QWidget*) { return focusedText() == text; }))
            << text.toStdString() << ", not " << focusedText().toStdString();
    }

    /// What the window says: the reason of a wait that was in vain.
    std::string shownTexts() const {
        std::string texts;
        for (const QLabel* label : window->findChildren<QLabel*>()) {
            if (label->isVisible() && !label->text().isEmpty()) {
                texts += "\n" + label->text().toStdString();
            }
        }
        return texts;
    }

    /// Whether there is such a button to press.
    bool canPress(const QString& text) {
        const auto buttons = window->findChildren<QAbstractButton*>();
        return std::any_of(buttons.begin(), buttons.end(), [&](const QAbstractButton* button) {
            return button->isVisible() && button->isEnabled() &&
                   button->text().remove(QLatin1Char('&')) == text;
        });
    }
    void pressButton(const QString& text) {
        ASSERT_TRUE(wait([&] { return canPress(text); })) << text.toStdString() << shownTexts();
        tabTo(text);
        press(Qt::Key_Space);
    }

    /// A device of the list that the window begins with, by arrow keys and Return.
    void connectByKeys(const QString& address) {
        open();
        QApplication::setActiveWindow(window.get());
        auto* list = window->findChild<DevicePanel*>()->findChild<QListWidget*>();
        ASSERT_TRUE(tabUntil([&](QWidget* focused) { return focused == list; }));
        const auto chosen = [list] {
            return list->currentItem() == nullptr ? QString() : list->currentItem()->text();
        };
        for (int i = 0; i < list->count() && !chosen().contains(address); ++i) {
            press(Qt::Key_Down);
        }
        ASSERT_TRUE(chosen().contains(address)) << chosen().toStdString();
        press(Qt::Key_Return);
        ASSERT_TRUE(wait([&] { return !window->bench().deviceValues().empty(); }));
        session().setPace({0.0});
    }
    void goTo(Perspective perspective, Qt::Key number) {
        press(number, Qt::ControlModifier);
        ASSERT_TRUE(wait([&] { return window->docks().perspective() == perspective; }));
    }
    bool isArmed() { return session().report().board.isArmed; }
};

} // namespace halbench::app
