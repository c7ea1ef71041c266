#include "app/window/docks/dock_layout.h"
#include "app/window/preferences/preferences_dialog.h"
#include "app/workbench/drive_control.h"
#include "app/workspaces/monitor/signal_tree.h"
#include "devices/history/page_file.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/stop_button.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTimer>

namespace halbench::app {
namespace {

class PreferencesDialogTest : public WindowTest {
protected:
    /// Opens the dialog by its menu entry and does `steps` in it.
    void inDialog(const std::function<void(PreferencesDialog&)>& steps) {
        QTimer::singleShot(0, [&] { steps(*window->findChild<PreferencesDialog*>()); });
        for (QAction* action : window->findChildren<QAction*>()) {
            if (action->shortcut() == QKeySequence("Ctrl+,")) {
                action->trigger();
            }
        }
    }

    static QComboBox& box(PreferencesDialog& dialog, const QString& name) {
        for (auto* each : dialog.findChildren<QComboBox*>()) {
            if (each->accessibleName() == name) {
                return *each;
            }
        }
        throw std::logic_error("no box " + name.toStdString());
    }

    static void choose(PreferencesDialog& dialog, const QString& name, const QString& text) {
        QComboBox& one = box(dialog, name);
        one.setFocus();
        QTest::keyClicks(&one, text);
        EXPECT_EQ(one.currentText(), text);
    }

    static QLabel* labelled(PreferencesDialog& dialog, const QString& name) {
        for (auto* label : dialog.findChildren<QLabel*>()) {
            if (label->accessibleName() == name) {
                return label;
            }
        }
        return nullptr;
    }

    static void press(PreferencesDialog& dialog, QDialogButtonBox::StandardButton button) {
        QTest::mouseClick(dialog.findChild<QDialogButtonBox*>()->button(button), Qt::LeftButton);
    }

    QStringList plotUnits() {
        QStringList units;
        auto* monitor = window->docks().panel("monitor");
        for (const widgets::PlotSpec& plot : monitor->findChild<widgets::LivePlotStack*>()->plots()) {
            units << plot.unit;
        }
        return units;
    }
};

TEST_F(PreferencesDialogTest, unitsOfThePlotsChangeAtOnceAndAreKept) {
    open();
    connectMotor(1.0);
    ASSERT_TRUE(plotUnits().contains("r/min"));
    const int plots = plotUnits().size();
    inDialog([](PreferencesDialog& dialog) {
        choose(dialog, "Angles in", "radians");
        choose(dialog, "Speeds in", "radians per second");
        choose(dialog, "Frequencies in", "radians per second");
        press(dialog, QDialogButtonBox::Ok);
    });
    EXPECT_EQ(plotUnits().size(), plots);
    EXPECT_TRUE(plotUnits().contains("rad"));
    EXPECT_TRUE(plotUnits().contains("rad/s"));
    EXPECT_FALSE(plotUnits().contains("r/min"));
    EXPECT_EQ(loadPreferences().units, (DisplayUnits{widgets::AngleUnit::Radian, SpeedUnit::RadiansPerSecond,
                                                     FrequencyUnit::RadiansPerSecond}));
}

TEST_F(PreferencesDialogTest, cancelLeavesAllAsItWas) {
    open();
    connectMotor(1.0);
    const QStringList before = plotUnits();
    inDialog([](PreferencesDialog& dialog) {
        choose(dialog, "Angles in", "radians");
        press(dialog, QDialogButtonBox::Cancel);
    });
    EXPECT_EQ(plotUnits(), before);
    EXPECT_EQ(window->preferences().units, DisplayUnits());
}

TEST_F(PreferencesDialogTest, theLockOutIsTheStopButtons) {
    open();
    connectMotor(1.0);
    inDialog([](PreferencesDialog& dialog) {
        dialog.findChild<QSpinBox*>()->setFocus();
        dialog.findChild<QSpinBox*>()->selectAll();
        QTest::keyClicks(dialog.findChild<QSpinBox*>(), "0");
        press(dialog, QDialogButtonBox::Ok);
    });
    auto* stop = window->findChild<widgets::StopButton*>();
    QTest::mouseClick(stop, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return session().report().board.isStopLatched; }));
    // Without a lock-out it can be released as soon as the latch is known.
    EXPECT_TRUE(wait([&] { return window->bench().drive().canRelease(); }));
    EXPECT_EQ(loadPreferences().stopLockOut_ms, 0);
}

TEST_F(PreferencesDialogTest, theHistorysRoomOnTheDiskCountsAtOnceAndIsKept) {
    open();
    EXPECT_EQ(window->historyPages().limit_bytes(), 12'000'000'000U);
    inDialog([](PreferencesDialog& dialog) {
        QSpinBox* room = nullptr;
        for (auto* each : dialog.findChildren<QSpinBox*>()) {
            room = each->accessibleName() == "Maximum history on disk" ? each : room;
        }
        ASSERT_NE(room, nullptr);
        QStringList labels;
        for (const auto* label : dialog.findChildren<QLabel*>()) {
            labels << label->text();
        }
        EXPECT_TRUE(labels.contains("used: 0.0 GB")) << labels.join('|').toStdString();
        for (const auto* label : dialog.findChildren<QLabel*>()) { // an access key leads to its field
            EXPECT_TRUE(!label->text().contains('&') || label->buddy() != nullptr)
                << label->text().toStdString();
        }
        room->setFocus();
        room->selectAll();
        QTest::keyClicks(room, "3");
        press(dialog, QDialogButtonBox::Ok);
    });
    EXPECT_EQ(window->historyPages().limit_bytes(), 3'000'000'000U);
    EXPECT_EQ(loadPreferences().historyLimit_GB, 3);
}

TEST_F(PreferencesDialogTest, aWrongNameMaskIsRefusedInPlaceAndAGoodOneNamesTheNextRecording) {
    open();
    connectMotor(1.0);
    inDialog([](PreferencesDialog& dialog) {
        auto* mask = dialog.findChild<QLineEdit*>();
        auto* use = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        auto* example = labelled(dialog, "Example of a recording's name");
        ASSERT_NE(example, nullptr);
        EXPECT_TRUE(example->text().startsWith("e.g. sim-htm-1_20")) << example->text().toStdString();
        mask->setText("runs/{number}");
        EXPECT_FALSE(use->isEnabled());
        EXPECT_TRUE(example->text().startsWith("name mask, character 5: a name cannot contain a folder"))
            << example->text().toStdString();
        mask->setText("bench_{number}");
        EXPECT_TRUE(use->isEnabled());
        EXPECT_EQ(example->text(), "e.g. bench_001.csv");
        press(dialog, QDialogButtonBox::Ok);
    });
    EXPECT_EQ(window->bench().recording().nameMask(), "bench_{number}");
    EXPECT_EQ(loadPreferences().recordingNames, "bench_{number}");
}

TEST_F(PreferencesDialogTest, whatWouldGoIsSaidBeforeItCanBeSwitchedOn) {
    open();
    QTemporaryDir folder;
    window->bench().recording().setFolder(folder.path());
    inDialog([&](PreferencesDialog& dialog) {
        auto* use = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        auto* plan = labelled(dialog, "Recordings to be deleted now");
        ASSERT_NE(plan, nullptr);
        EXPECT_EQ(plan->text(), "Currently never.");
        for (auto* each : dialog.findChildren<QCheckBox*>()) {
            if (each->accessibleName() == "Delete recordings by age") {
                each->click();
            }
        }
        EXPECT_FALSE(use->isEnabled()) << "not before it was looked";
        EXPECT_TRUE(QTest::qWaitFor([&] { return use->isEnabled(); }));
        EXPECT_TRUE(plan->text().startsWith("OK deletes nothing from ")) << plan->text().toStdString();
        press(dialog, QDialogButtonBox::Ok);
    });
    EXPECT_EQ(loadPreferences().retention, (RetentionLimits{90, {}}));
}

TEST_F(PreferencesDialogTest, itsStopStops) {
    open();
    connectMotor(1.0);
    inDialog([](PreferencesDialog& dialog) {
        QTest::mousePress(dialog.findChild<widgets::StopButton*>(), Qt::LeftButton);
        press(dialog, QDialogButtonBox::Cancel);
    });
    EXPECT_TRUE(wait([&] { return session().report().board.isStopLatched; }));
}

} // namespace
} // namespace halbench::app
