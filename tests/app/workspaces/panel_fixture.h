#pragma once

#include "app/workbench/workbench.h"
#include "tests/widgets/gui_fixture.h"

#include <QAbstractButton>
#include <QPlainTextEdit>
#include <QtTest/QTest>

#include <map>
#include <string>

namespace halbench::app {

/// A panel with a real session on a simulated motor, driven through its widgets.
class PanelTest : public widgets::GuiTest {
protected:
    static constexpr int Patience_ms = 120000; ///< a loaded machine under a sanitizer

    template <typename Condition>
    static bool wait(Condition condition) {
        return QTest::qWaitFor(condition, Patience_ms);
    }

    void connectMotor(const QString& uri, double speed_ratio) {
        bench.session().connectDevice(uri, {speed_ratio});
        ASSERT_TRUE(wait([&] { return bench.session().state() == SessionState::Connected; }));
        ASSERT_TRUE(wait([&] { return !bench.deviceValues().empty(); }));
    }

    static void show(QWidget& panel, QSize size = {1100, 720}) {
        panel.resize(size);
        panel.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    }

    /// The button with this text, which the user could see and click now.
    static QAbstractButton* button(const QWidget& panel, const QString& text) {
        for (auto* found : panel.findChildren<QAbstractButton*>()) {
            if (found->text().remove('&') == text && found->isVisible()) {
                return found;
            }
        }
        return nullptr;
    }

    static void click(const QWidget& panel, const QString& text) {
        QAbstractButton* found = button(panel, text);
        ASSERT_NE(found, nullptr) << text.toStdString();
        ASSERT_TRUE(found->isEnabled()) << text.toStdString();
        QTest::mouseClick(found, Qt::LeftButton);
    }

    static bool isEnabled(const QWidget& panel, const QString& text) {
        const QAbstractButton* found = button(panel, text);
        return found != nullptr && found->isEnabled();
    }

    /// Whether the user sees all of that button without scrolling, and nothing lies over it.
    static bool isWhole(const QWidget& panel, const QString& text) {
        const QAbstractButton* found = button(panel, text);
        return found != nullptr && found->visibleRegion() == QRegion(found->rect()) &&
               panel.childAt(found->mapTo(&panel, found->rect().center())) == found;
    }

    /// Every value of a calibration page, read anew: what a procedure must leave as it was. Generator and
    /// capture are tools that the next user sets anyway.
    std::map<std::string, double> valuesNow() {
        bool isRead = false;
        const auto connection =
            QObject::connect(&bench, &Workbench::valuesChanged, &bench, [&isRead] { isRead = true; });
        bench.refreshValues();
        EXPECT_TRUE(wait([&] { return isRead; }));
        QObject::disconnect(connection);
        std::map<std::string, double> values = bench.deviceValues();
        for (const ParameterSpec& spec : bench.session().catalogue().parameters) {
            if (!spec.isTransactional) {
                values.erase(spec.name);
            }
        }
        return values;
    }

    Workbench bench;
};

} // namespace halbench::app
