#include "app/workspaces/monitor/monitor_rate.h"
#include "tests/app/workspaces/fast_recording.h"
#include "tests/app/workspaces/monitor/monitor_fixture.h"
#include "widgets/controls/message_bar.h"

#include <QAction>
#include <QMenu>
#include <QTemporaryDir>

namespace halbench::app {
namespace {

class MonitorRateTest : public MonitorTest {
protected:
    MonitorRate& rate() { return *panel->findChild<MonitorRate*>(); }
    QStringList offered() {
        QMenu* menu = rate().action().menu();
        Q_EMIT menu->aboutToShow();
        QStringList texts;
        for (const QAction* action : menu->actions()) {
            texts << action->text() + (action->isChecked() ? " *" : "") +
                         (action->isEnabled() ? "" : " (disabled)");
        }
        return texts;
    }

    QTemporaryDir folder;
};

TEST_F(MonitorRateTest, offersWhatTheDeviceHasBeyondTheUsual) {
    connectTo(fastReplay(folder, 10000.0), 1.0);
    EXPECT_EQ(offered(), (QStringList{"Default (1000 Hz) *", "2000 Hz", "5000 Hz", "10000 Hz"}));
    rate().action().menu()->actions()[3]->trigger();
    EXPECT_EQ(bench().liveSignals().rate_Hz(), 10000.0);
    EXPECT_EQ(panel->view().rate_Hz, 10000.0) << "the project keeps it";
    EXPECT_EQ(offered()[3], "10000 Hz *");
    rate().action().menu()->actions()[0]->trigger();
    EXPECT_EQ(bench().liveSignals().rate_Hz(), 1000.0);
}

TEST_F(MonitorRateTest, saysWhereThereIsNoMore) {
    connectTo("sim:htm", 5.0);
    EXPECT_EQ(offered(), (QStringList{"Default (1000 Hz) *", "Maximum of device and link (disabled)"}));
}

TEST_F(MonitorRateTest, aRateThatCannotBeIsSaidWithTheOneThatComes) {
    MonitorView view;
    view.rate_Hz = 5000.0;
    panel->setView(view);
    connectTo("sim:htm", 5.0);
    EXPECT_EQ(bench().liveSignals().rate_Hz(), 1000.0);
    const auto* message = panel->findChild<widgets::MessageBar*>();
    EXPECT_TRUE(message->message().text.contains("5000 Hz")) << message->message().text.toStdString();
    EXPECT_TRUE(message->message().text.contains("1000 Hz"));
    EXPECT_EQ(panel->view().rate_Hz, 5000.0) << "the project's wish stays";
    rate().setRate_Hz(0.0);
    EXPECT_TRUE(message->message().text.isEmpty());
}

} // namespace
} // namespace halbench::app
