#include "app/window/stop_guard.h"
#include "app/window/window_application.h"

#include <QDrag>
#include <QMimeData>
#include <QProcess>
#include <QSignalSpy>
#include <QTimer>
#include <QWidget>
#include <QWindow>
#include <QtTest/QTest>

#include <gtest/gtest.h>

#include <memory>

namespace halbench::app {
namespace {

/// As the drag of the platform does: installed last, thus asked first, it lets no key on.
class KeyEater : public QObject {
public:
    KeyEater() { qApp->installEventFilter(this); }

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        return event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    }
};

/// A window with a guard on an X server of its own: the platform without a screen knows no drag.
class StopGuardTest : public testing::Test {
protected:
    void SetUp() override {
        m_server.setStandardErrorFile(QProcess::nullDevice());
        m_server.start("Xvfb", {"-displayfd", "1", "-nolisten", "tcp", "-screen", "0", "640x480x24"});
        ASSERT_TRUE(m_server.waitForStarted()) << m_server.errorString().toStdString();
        ASSERT_TRUE(m_server.waitForReadyRead());
        qputenv("DISPLAY", ":" + m_server.readLine().trimmed());
        qputenv("QT_QPA_PLATFORM", "xcb");
        qputenv("QT_XCB_GL_INTEGRATION", "none"); // nothing here is drawn by a graphics driver, and some leak
        m_application = std::make_unique<WindowApplication>(m_argumentCount, m_arguments);
        window = std::make_unique<QWidget>();
        guard = new StopGuard(window.get());
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    }
    void TearDown() override {
        window.reset();
        m_application.reset();
        m_server.terminate();
        m_server.waitForFinished();
    }

    void pressEscape() { QTest::keyClick(window->windowHandle(), Qt::Key_Escape); }

    std::unique_ptr<QWidget> window;
    StopGuard* guard = nullptr;

private:
    QProcess m_server;
    int m_argumentCount = 1;
    char m_name[5] = "test";
    char* m_arguments[2] = {m_name, nullptr};
    std::unique_ptr<WindowApplication> m_application;
};

TEST_F(StopGuardTest, escStopsAndIsToldOnce) {
    const QSignalSpy stops(guard, &StopGuard::stopRequested);
    const QSignalSpy keys(guard, &StopGuard::escapePressed);
    QTest::keyClick(window->windowHandle(), Qt::Key_A);
    EXPECT_EQ(stops.count(), 0);
    pressEscape();
    EXPECT_GE(stops.count(), 1); // the key passes as an offer and as a press; twice does no harm
    EXPECT_EQ(keys.count(), 1);
}

TEST_F(StopGuardTest, aFilterThatIsInstalledLaterCannotKeepEscFromStopping) {
    const QSignalSpy stops(guard, &StopGuard::stopRequested);
    const KeyEater eater;
    pressEscape();
    EXPECT_GE(stops.count(), 1);
}

TEST_F(StopGuardTest, escStopsWhileSomethingIsDragged) {
    const QSignalSpy stops(guard, &StopGuard::stopRequested);
    bool isDragging = true;
    bool wasDragging = false;
    QTimer::singleShot(0, window.get(), [&] {
        wasDragging = isDragging;
        pressEscape();
    });
    auto* drag = new QDrag(window.get());
    drag->setMimeData(new QMimeData);
    drag->exec(); // with an event loop of its own
    isDragging = false;
    EXPECT_TRUE(wasDragging);
    EXPECT_GE(stops.count(), 1);
}

} // namespace
} // namespace halbench::app
