#include "app/window/docks/dock_layout.h"
#include "app/window/preferences/language.h"
#include "app/wizards/identify_panel.h"
#include "app/workbench/drive_control.h"
#include "app/workspaces/device/device_panel.h"
#include "tests/app/window/window_test.h"
#include "tests/gui/inspection.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/optional_number_edit.h"

#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QTemporaryDir>

namespace halbench::gui {
namespace {

using app::Perspective;

/// Drives the real window into what goes wrong in real life; no English may be left in what it says then.
class ErrorsTest : public app::WindowTest, public testing::WithParamInterface<const char*> {
protected:
    ErrorsTest() {
        app::speak(application, GetParam());
        phrases = phrasesOf(GetParam());
        open();
    }
    ~ErrorsTest() override { QLocale::setDefault(QLocale::c()); }

    void look(const char* place) {
        QTest::qWait(50); // one frame of the window
        for (const QString& finding : inspect(*window, phrases)) {
            EXPECT_FALSE(finding.contains("is not translated")) << place << ": " << finding.toStdString();
        }
    }

    widgets::MessageBar* message(const QWidget* parent) {
        for (auto* bar : parent->findChildren<widgets::MessageBar*>()) {
            if (bar->isVisible()) {
                return bar;
            }
        }
        return nullptr;
    }

    /// What the panel says; waits until it says something.
    QString said(const QWidget* panel) {
        EXPECT_TRUE(wait([&] { return message(panel) != nullptr; }));
        return message(panel) == nullptr ? QString() : message(panel)->message().text;
    }

    QWidget* devices() { return window->findChild<app::DevicePanel*>(); }

    void click(const QWidget* panel, const char* context, const char* text) {
        const QString words = QCoreApplication::translate(context, text);
        for (auto* found : panel->findChildren<QPushButton*>()) {
            if (found->text() == words && found->isVisible()) {
                ASSERT_TRUE(wait([&] { return found->isEnabled(); }));
                QTest::mouseClick(found, Qt::LeftButton);
                return;
            }
        }
        FAIL() << "no button " << text;
    }

    QHash<QString, QString> phrases;
};

TEST_P(ErrorsTest, anAddressThatIsNone) {
    for (const char* address :
         {"sim:nothing", "sim:htm?seed=x", "sim:htm?c=-1", "htm", "smoke:1", "replay:/no/file.csv",
          "tcp:127.0.0.1:1", "sim:htm?nosuch=1", "tcp:nowhere"}) {
        window->connectDevice(address);
        ASSERT_TRUE(wait([&] { return session().state() == app::SessionState::Disconnected; }));
        const QString text = said(devices());
        EXPECT_NE(text, QString());
        look(address);
    }
}

TEST_P(ErrorsTest, aDeviceThatVanishes) {
    QProcess board;
    board.start(HALBENCH_PROGRAM, {"serve", "sim:htm", "--tcp", "127.0.0.1:0"});
    ASSERT_TRUE(board.waitForReadyRead(Patience_ms));
    window->connectDevice(QString::fromUtf8(board.readLine()).trimmed().section(' ', 1));
    ASSERT_TRUE(wait([&] { return session().state() == app::SessionState::Connected; }));
    board.kill();
    ASSERT_TRUE(wait([&] { return session().state() == app::SessionState::Reconnecting; }));
    EXPECT_NE(said(window.get()), QString());
    look("lost");
    board.waitForFinished(Patience_ms);
}

TEST_P(ErrorsTest, aFaultAndWhatIsRefusedBecauseOfIt) {
    connectMotor(1.0);
    std::optional<Result<void>> armed;
    session().request(
        [](::halbench::devices::Device& device) -> Result<void> {
            const std::vector<ParameterValue> cold = {{"limit.temperature", -30.0}};
            if (Result<void> written = device.writeParameters(cold); !written) {
                return written;
            }
            return device.arm();
        },
        [&](const Result<void>& result) { armed = result; });
    ASSERT_TRUE(wait([&] { return session().report().board.fault != 0; }));
    for (const Perspective perspective : app::AllPerspectives) {
        window->docks().setPerspective(perspective);
        look("fault");
    }
}

TEST_P(ErrorsTest, aStopFromTheKeyboard) {
    connectMotor(1.0);
    window->bench().drive().giveConsent();
    window->bench().drive().arm(); // Esc stops what is armed
    ASSERT_TRUE(wait([&] { return session().report().board.isArmed; }));
    QTest::keyClick(window.get(), Qt::Key_Escape);
    ASSERT_TRUE(wait([&] { return session().report().board.isStopLatched; }));
    for (const Perspective perspective : app::AllPerspectives) {
        window->docks().setPerspective(perspective);
        look("stopped");
    }
}

TEST_P(ErrorsTest, aSweepThatIsBeyondTheMotor) {
    connectMotor(1.0);
    window->docks().setPerspective(Perspective::Identify);
    auto* panel = window->findChild<app::IdentifyPanel*>();
    for (auto* edit : panel->findChildren<widgets::OptionalNumberEdit*>()) {
        edit->setFocus();
        QTest::keyClick(edit, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(edit, "-1");
        look("a given constant that cannot be");
        QTest::keyClick(edit, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(edit, Qt::Key_Delete);
    }
    const auto boxes = panel->findChildren<QDoubleSpinBox*>();
    boxes[0]->setValue(boxes[0]->maximum());
    boxes[1]->setValue(boxes[1]->minimum());
    look("a sweep downwards");
    boxes[1]->setValue(boxes[1]->maximum());
    boxes[0]->setValue(boxes[0]->minimum());
    boxes[2]->setValue(boxes[2]->minimum());
    look("a sweep of too many currents");
}

TEST_P(ErrorsTest, anIdentificationThatFindsNothing) {
    connectMotor(0.0); // as fast as possible
    window->docks().setPerspective(Perspective::Identify);
    auto* panel = window->findChild<app::IdentifyPanel*>();
    const auto boxes = panel->findChildren<QDoubleSpinBox*>();
    const double currents_A[] = {0.3, 0.5, 0.1}; // below the breakaway current: the rotor never turns
    for (int i = 0; i < 3; ++i) {
        boxes[i]->setValue(currents_A[i]);
    }
    click(panel, "halbench::app::IdentifyPanel", "Start identification");
    ASSERT_TRUE(wait([&] { return !session().procedure().isEmpty(); }));
    ASSERT_TRUE(QTest::qWaitFor([&] { return session().procedure().isEmpty(); }, 120000));
    look("nothing found");
}

TEST_P(ErrorsTest, aProjectThatIsDamaged) {
    QTemporaryDir folder;
    for (const char* content :
         {"schema = \"halbench.project/9\"", "schema = 3", "notes = [",
          "colour = 1\nschema = \"halbench.project/1\"", "schema = \"halbench.project/1\"\nlayout = 3"}) {
        QFile file(folder.filePath("motor.toml"));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(content);
        file.close();
        window->openProject(file.fileName());
        EXPECT_NE(said(window.get()), QString());
        look(content);
    }
    window->openProject(folder.filePath("none.toml"));
    look("no file");
}

INSTANTIATE_TEST_SUITE_P(Gui, ErrorsTest, testing::Values("de", "zh_CN"),
                         [](const testing::TestParamInfo<const char*>& language) {
                             return std::string(language.param);
                         });

} // namespace
} // namespace halbench::gui
