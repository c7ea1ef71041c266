#pragma once

#include "app/window/docks/perspective_bar.h"
#include "app/window/help/help_pages.h"
#include "app/window/help/help_window.h"
#include "app/window/top_bar.h"
#include "tests/app/window/window_test.h"

#include <QAction>
#include <QApplication>
#include <QTextBrowser>
#include <QToolButton>

namespace halbench::app {

/// What stands on top of every perspective, by mouse and keys.
class TopBarTest : public WindowTest {
protected:
    template <typename Widget>
    Widget* inBar() {
        return window->findChild<TopBar*>()->findChild<Widget*>();
    }
    void key(Qt::Key code, Qt::KeyboardModifiers modifiers) {
        QTest::keyClick(window.get(), code, modifiers);
    }
    bool isArmed() { return session().report().board.isArmed; }
    QToolButton* perspective(const QString& title) {
        for (auto* button : inBar<PerspectiveBar>()->findChildren<QToolButton*>()) {
            if (button->text() == title && button->isVisible()) {
                return button;
            }
        }
        return nullptr;
    }
    QString helpWords() {
        // What F1 does; the platform without a screen gives no window the focus.
        for (auto* action : window->findChildren<QAction*>()) {
            if (action->shortcut() == QKeySequence::HelpContents) {
                action->trigger();
            }
        }
        auto* help = window->findChild<HelpWindow*>();
        const QString words = help->findChild<QTextBrowser*>()->toPlainText();
        delete help;
        QApplication::setActiveWindow(window.get());
        return words;
    }
    static QString pageWords(const QString& page) {
        QTextBrowser text;
        text.setMarkdown(helpText(page));
        return text.toPlainText();
    }
};

} // namespace halbench::app
