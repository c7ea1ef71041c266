#pragma once

#include "app/workbench/drive_control.h"
#include "app/workspaces/drive/drive_limits.h"
#include "app/workspaces/drive/drive_panel.h"
#include "control/base/units.h"
#include "devices/open/serve_device.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/controls/message_bar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QWheelEvent>

#include <atomic>
#include <cmath>
#include <future>
#include <mutex>
#include <thread>

namespace halbench::app {

class DrivePanelTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        panel = std::make_unique<DrivePanel>(bench());
        panel->resize(320, 700);
        panel->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(panel.get()));
    }
    void TearDown() override { panel.reset(); }

    bool isArmed() { return session().report().board.isArmed; }
    void armByClick() {
        ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Arm")->isEnabled(); }));
        click(*panel, "Arm");
        ASSERT_TRUE(wait([&] { return isArmed(); }));
        ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Go")->isEnabled() || mode() == 0; }));
    }
    int mode() { return find<QComboBox>(*panel, "Mode")->currentIndex(); }
    void chooseMode(int index) { find<QComboBox>(*panel, "Mode")->setCurrentIndex(index); }
    QString message() {
        const auto* bar = panel->findChild<widgets::MessageBar*>();
        return bar->isVisible() ? bar->message().text : QString();
    }
    double latestTime_s() { return bench().history().latest("reference")->time_s; }
    /// The board is armed and its samples say so: before, there is no reference.
    bool hasReference() { return std::isfinite(latest("reference")) && latest("reference") != 0.0; }
    double latest(const char* signal) {
        const auto value = bench().history().latest(signal);
        return value ? value->value : 0.0;
    }

    std::unique_ptr<DrivePanel> panel;
};

} // namespace halbench::app
