#pragma once

#include "app/workbench/workbench.h"
#include "tests/widgets/gui_fixture.h"

#include <QAbstractButton>
#include <QTimer>
#include <QtTest/QTest>

#include <optional>
#include <string>

namespace halbench::app {

/// A workbench on the simulated motor with a window's heartbeat, for driving panels through their widgets.
class BenchTest : public widgets::GuiTest {
protected:
    static constexpr int Patience_ms = 120000;

    void SetUp() override {
        GuiTest::SetUp();
        QObject::connect(&m_frame, &QTimer::timeout, &m_frame, [this] { bench().drainSamples(); });
        m_frame.start(30);
    }

    Workbench& bench() {
        if (!m_bench) {
            m_bench.emplace();
        }
        return *m_bench;
    }
    DeviceSession& session() { return bench().session(); }

    void connectTo(const QString& uri, double speed_ratio) {
        session().connectDevice(uri, {speed_ratio});
        ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
        ASSERT_TRUE(wait([&] { return !bench().deviceValues().empty(); }));
    }

    /// No samples reach the panels, as when the stream has only just begun.
    void holdSamplesBack(bool isHeld) { isHeld ? m_frame.stop() : m_frame.start(30); }

    template <typename Condition>
    static bool wait(Condition condition) {
        return QTest::qWaitFor(condition, Patience_ms);
    }

    /// The visible or hidden widget with this accessible name or text.
    template <typename Widget>
    static Widget* find(const QWidget& parent, const QString& words) {
        for (Widget* widget : parent.findChildren<Widget*>()) {
            if (widget->accessibleName() == words) {
                return widget;
            }
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            if (button != nullptr && button->text().remove(QLatin1Char('&')) == words) {
                return widget;
            }
        }
        ADD_FAILURE() << "no widget is called " << words.toStdString();
        return nullptr;
    }

    static void click(const QWidget& parent, const QString& words) {
        if (auto* button = find<QAbstractButton>(parent, words)) {
            QTest::mouseClick(button, Qt::LeftButton);
        }
    }

    static void type(QWidget* field, const QString& text) {
        field->setFocus();
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, text);
    }

    /// A parameter read from the device now.
    double parameter(const std::string& name) {
        std::optional<double> value;
        session().request(
            [name](devices::Device& device) { return device.readParameters(std::span(&name, 1)); },
            [&value](const Result<std::vector<double>>& read) { value = read ? read->front() : -1.0; });
        EXPECT_TRUE(wait([&] { return value.has_value(); }));
        return value.value_or(-1.0);
    }

private:
    std::optional<Workbench> m_bench; ///< after the application, before the timer
    QTimer m_frame;
};

} // namespace halbench::app
