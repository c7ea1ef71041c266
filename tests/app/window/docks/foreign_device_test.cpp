#include "app/window/docks/dock_layout.h"
#include "app/window/docks/panels.h"
#include "app/wizards/identify_panel.h"
#include "app/workspaces/device/device_panel.h"
#include "app/workspaces/device/parameters_panel.h"
#include "app/workspaces/drive/drive_panel.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "app/workspaces/monitor/signals_panel.h"
#include "devices/formats/recording_file.h"
#include "tests/app/window/window_test.h"
#include "tests/devices/xcp/foreign_board.h"
#include "widgets/controls/message_bar.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/parameters/parameter_table_model.h"

#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include <cmath>

namespace halbench::app {
namespace {

using devices::xcp::Command;
using devices::xcp::ForeignBoard;
using devices::xcp::Packet;
using devices::xcp::SlaveTraits;
using devices::xcp::TestSlave;
using Model = widgets::ParameterTableModel;

/// The window with a board that no profile knows and that shares no code with ours (protocol.md, gate 7).
class ForeignDeviceTest : public WindowTest {
protected:
    /// Also one behind a tab.
    template <typename Panel>
    Panel& panel() const {
        for (const PanelSpec& spec : panelSpecs()) {
            if (auto* found = dynamic_cast<Panel*>(window->docks().panel(spec.id))) {
                return *found;
            }
        }
        ADD_FAILURE() << "no such panel";
        std::abort();
    }

    template <typename Widget>
    static Widget* called(const QWidget& parent, const QString& words) {
        for (Widget* widget : parent.findChildren<Widget*>()) {
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            const QString text = button == nullptr ? QString() : button->text().remove(QLatin1Char('&'));
            if (widget->accessibleName() == words || text == words) {
                return widget;
            }
        }
        ADD_FAILURE() << "nothing is called " << words.toStdString();
        return nullptr;
    }

    /// As a user does: the address into its field, Enter.
    void connectBy(const QString& address) {
        auto* field = called<QLineEdit>(panel<DevicePanel>(), "Device address");
        field->selectAll();
        QTest::keyClicks(field, address); // as typed: the list of devices, when it comes, leaves it alone
        QTest::keyClick(field, Qt::Key_Return);
    }

    void connectTo(const ForeignBoard& board) {
        open();
        connectBy(QString::fromStdString(board.uri()));
        ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
        ASSERT_TRUE(wait([&] { return window->bench().deviceValue("p.a").has_value(); }));
    }

    QTreeWidgetItem* signalRow(const QString& signal) const {
        for (QTreeWidgetItemIterator at(panel<SignalsPanel>().findChild<QTreeWidget*>()); *at != nullptr;
             ++at) {
            if ((*at)->text(0) == signal) {
                return *at;
            }
        }
        return nullptr;
    }

    double latest(const char* signal) {
        const auto value = window->bench().history().latest(signal);
        return value ? value->value : std::nan("");
    }

    Model& parameters() const {
        return panel<ParametersPanel>().findChild<widgets::ParameterTable*>()->model();
    }
    widgets::Message parameterWords() const {
        return panel<ParametersPanel>().findChild<widgets::ParameterTable*>()->messages().message();
    }
    void write() {
        for (QPushButton* button : panel<ParametersPanel>().findChildren<QPushButton*>()) {
            if (button->text().contains("Write")) {
                button->click();
                return;
            }
        }
        ADD_FAILURE() << "no button writes";
    }

    /// What message bars of a panel say.
    static QString said(const QWidget& panel) {
        QString all;
        for (const auto* bar : panel.findChildren<widgets::MessageBar*>()) {
            all += bar->message().text + QLatin1Char(' ') + bar->message().remedy + QLatin1Char('\n');
        }
        return all;
    }
};

TEST_F(ForeignDeviceTest, isWatchedPlottedRecordedAndSetByName) {
    ForeignBoard board;
    const QTemporaryDir folder;
    connectTo(board);
    ASSERT_NE(signalRow("wave"), nullptr);
    ASSERT_TRUE(wait([&] { return latest("wave") > 0.0; })); // the first signals are plotted by themselves
    EXPECT_EQ(signalRow("byte")->checkState(0), Qt::Checked);
    signalRow("byte")->setCheckState(0, Qt::Unchecked);
    EXPECT_TRUE(wait([&] {
        const auto& streamed = window->bench().liveSignals().streamed();
        return std::find(streamed.begin(), streamed.end(), "byte") == streamed.end();
    }));

    RecordingControl& recording = window->bench().recording();
    recording.setFolder(folder.path());
    QTest::keyClick(window.get(), Qt::Key_R, Qt::ControlModifier);
    ASSERT_TRUE(wait([&] { return recording.status().rows > 20; }));
    QTest::keyClick(window.get(), Qt::Key_R, Qt::ControlModifier);
    ASSERT_TRUE(wait([&] { return !recording.isRecording(); }));
    const auto file = devices::readRecordingFile(recording.path().toStdString());
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_EQ(file->recording.layout->columns.size(), 3U);
    EXPECT_EQ(file->recording.layout->columns[0].name, "count");
    EXPECT_EQ(file->recording.layout->columns[1].name, "wave");
    for (std::size_t row = 0; row < file->recording.rows(); ++row) { // one row is one moment of the board
        EXPECT_EQ(file->recording.values[3 * row + 1], file->recording.values[3 * row] / 4.0);
    }

    ASSERT_TRUE(parameters().edit("p.a", 1.5));
    ASSERT_TRUE(parameters().edit("p.n", 12.0));
    write();
    ASSERT_TRUE(wait([&] { return parameterWords().severity == widgets::Severity::Success; }))
        << parameterWords().text.toStdString();
    EXPECT_EQ(window->bench().deviceValue("p.a"), 1.5);
    EXPECT_EQ(board.look([](TestSlave& slave) { return slave.parameter(slave.runningPage(), 0); }), 1.5F);
}

TEST_F(ForeignDeviceTest, noListsTellsAndFilledSamplesInTheOtherByteOrderAreTakenAsTheyAre) {
    SlaveTraits traits;
    traits.maxDaq = 0;
    traits.dtoAlignment = 4;
    traits.order = devices::xcp::ByteOrder::BigEndian;
    traits.idField = devices::xcp::IdField::RelativeWordAligned;
    ForeignBoard board(traits);
    connectTo(board);
    ASSERT_TRUE(wait([&] { return latest("count") > 10.0; }));
    EXPECT_EQ(latest("wave"), latest("count") / 4.0);
    EXPECT_EQ(latest("big"), latest("count") / 8.0);
}

TEST_F(ForeignDeviceTest, valuesThatChangeOneByOneAreWarnedAbout) {
    SlaveTraits traits;
    traits.hasPages = false;
    traits.hasGap = true;
    ForeignBoard board(traits);
    connectTo(board);
    ASSERT_TRUE(parameters().edit("p.a", 2.0));
    write();
    ASSERT_TRUE(wait([&] { return parameterWords().severity == widgets::Severity::Success; })); // one is one
    ASSERT_TRUE(parameters().edit("p.a", 3.0));
    ASSERT_TRUE(parameters().edit("p.b", 4.0));
    write();
    ASSERT_TRUE(wait([&] { return parameterWords().severity == widgets::Severity::Warning; }));
    EXPECT_TRUE(parameterWords().remedy.contains("one after the other"))
        << parameterWords().remedy.toStdString();
    EXPECT_EQ(board.look([](TestSlave& slave) { return slave.parameter(0, 8); }), 4.0F);
}

TEST_F(ForeignDeviceTest, aPageThatTakesNoWritesIsSaidAndItsValuesAreStillShown) {
    SlaveTraits traits;
    traits.isPage1ReadOnly = true;
    ForeignBoard board(traits, [](TestSlave& slave) {
        slave.bendAnswers = [](const Packet& command, std::deque<Packet>& answers) {
            if (command[0] == static_cast<std::uint8_t>(Command::GetCalPage)) {
                answers = {{0xFF, 0, 0, 1}}; // it runs on the page that only takes reads
            }
        };
    });
    connectTo(board);
    EXPECT_TRUE(parameterWords().text.contains("Read-only parameters: 3"))
        << parameterWords().text.toStdString();
    const QModelIndex cell = parameters().indexOf("p.a");
    EXPECT_EQ(cell.siblingAtColumn(Model::DeviceColumn).data().toString(), "0");
    EXPECT_FALSE(parameters().flags(cell) & Qt::ItemIsEditable);
    EXPECT_FALSE(parameters().edit("p.a", 1.0));
}

TEST_F(ForeignDeviceTest, whatNeedsAnActuatorOfOursIsNotThere) {
    ForeignBoard board;
    connectTo(board);
    for (const QPushButton* button : window->findChildren<QPushButton*>()) {
        EXPECT_FALSE(button->text() == "Arm" && button->isVisible());
    }
    window->docks().setPerspective(Perspective::Identify); // which has no use for it
    EXPECT_EQ(window->docks().perspective(), Perspective::Monitor);
    // STOP is sent all the same, and the log says what it is worth.
    QStringList log;
    QObject::connect(&session(), &DeviceSession::message, window.get(),
                     [&](MessageLevel, const QString&, const QString& text) { log << text; });
    QTest::keyClick(window.get(), Qt::Key_Escape);
    EXPECT_TRUE(wait([&] { return log.join("\n").contains("does not report whether it stopped"); }))
        << log.join("\n").toStdString();
    EXPECT_EQ(session().state(), SessionState::Connected);
}

TEST_F(ForeignDeviceTest, withoutADescriptionOfItsOwnItIsUsedByAFile) {
    std::string text;
    ForeignBoard board({}, [&](TestSlave& slave) {
        slave.bendAnswers = [](const Packet& command, std::deque<Packet>& answers) {
            if (command[0] == static_cast<std::uint8_t>(Command::GetId) && command[1] == 4) {
                answers = devices::xcp::slaveError(devices::xcp::SlaveError::OutOfRange);
            }
        };
        text = slave.ownDescription();
    });
    const QTemporaryDir folder;
    const QString path = folder.filePath("maker's & 100% board.a2l");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text.c_str());
    file.close();
    open();
    connectBy(QString::fromStdString(board.uri()));
    ASSERT_TRUE(wait([&] { return said(panel<DevicePanel>()).contains("A2L file"); }));
    EXPECT_EQ(session().state(), SessionState::Disconnected);

    panel<DevicePanel>().setFileChooser({{}, [&](QWidget*, const FileQuestion&) { return path; }});
    ASSERT_TRUE(
        wait([&] { return called<QPushButton>(panel<DevicePanel>(), "Description file…")->isEnabled(); }));
    QTest::mouseClick(called<QPushButton>(panel<DevicePanel>(), "Description file…"), Qt::LeftButton);
    EXPECT_TRUE(panel<DevicePanel>().address().contains("?a2l="))
        << panel<DevicePanel>().address().toStdString();
    ASSERT_TRUE(wait([&] { return called<QPushButton>(panel<DevicePanel>(), "Connect")->isEnabled(); }));
    QTest::mouseClick(called<QPushButton>(panel<DevicePanel>(), "Connect"), Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }))
        << said(panel<DevicePanel>()).toStdString();
    EXPECT_TRUE(wait([&] { return latest("wave") > 0.0; }));
}

TEST_F(ForeignDeviceTest, aSignalOfAnotherEventIsNamedInsteadOfStoppingTheOthers) {
    ForeignBoard board({}, [](TestSlave& slave) {
        std::string text = slave.ownDescription();
        const std::string own = "MEASUREMENT big \"\" FLOAT64_IEEE NO_COMPU_METHOD 0 0 0 1e9 ECU_ADDRESS 24";
        text.replace(text.find(own), own.size(),
                     own + " /begin IF_DATA XCP /begin DAQ_EVENT FIXED_EVENT_LIST EVENT 7 /end DAQ_EVENT "
                           "/end IF_DATA");
        slave.descriptionText = text;
    });
    connectTo(board);
    ASSERT_TRUE(wait([&] { return latest("wave") > 0.0; }));
    EXPECT_EQ(window->bench().liveSignals().leftOut(), std::vector<std::string>{"big"});
    const QString words = said(panel<MonitorPanel>());
    EXPECT_TRUE(words.contains("Not shown: big")) << words.toStdString();
}

} // namespace
} // namespace halbench::app
