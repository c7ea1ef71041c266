#include "app/workspaces/recordings/result_history_view.h"
#include "tests/widgets/gui_fixture.h"

namespace halbench::app {
namespace {

control::Estimate estimate(double value, double half) {
    return {value, std::pair(value - half, value + half), control::EstimateSource::Identified, "N*m*s/rad"};
}

ResultRow rowOf(const std::string& file, const std::string& started, const control::Estimate& damping) {
    ResultRow row;
    row.file = file;
    row.header.device.emplace();
    row.header.device->id = "HB-17";
    row.header.started = started;
    row.values[0] = damping;
    return row;
}

class ResultHistoryViewTest : public widgets::GuiTest {
protected:
    QString text(int row, int column) const { return view.item(row, column)->text(); }
    ResultHistoryView view;
};

TEST_F(ResultHistoryViewTest, valuesHaveTheirIntervalsAndDrift) {
    view.setRows({rowOf("c.json", "2026-01-01T00:00:00Z", estimate(2e-3, 1e-4)),
                  rowOf("b.json", "2026-02-01T00:00:00Z", estimate(3e-3, 1e-4)),
                  rowOf("a.json", "2026-03-01T00:00:00Z", estimate(2.02e-3, 1e-4))});
    ASSERT_EQ(view.rowCount(), 3);
    EXPECT_EQ(text(0, 0), "c.json");
    EXPECT_EQ(text(0, 2), "HB-17");
    EXPECT_EQ(text(0, 3), "good");
    EXPECT_EQ(text(0, 4), QStringLiteral("0.00200 \u00b1 0.00010"));
    EXPECT_TRUE(text(1, 4).contains(QStringLiteral("+50.0 % \u25b2")));
    EXPECT_TRUE(text(2, 4).contains("+1.0 %)"));
    EXPECT_TRUE(view.item(1, 4)->toolTip().contains("outside both intervals"));
    EXPECT_EQ(text(0, 7), QStringLiteral("\u2013"));
}

TEST_F(ResultHistoryViewTest, whatWasGivenOrMeasuredInSimulatedTimeSaysSo) {
    ResultRow row = rowOf("m.json", "1970-01-01T00:00:00Z", estimate(2e-3, 1e-4));
    row.values[3] = {5.5e-4, std::nullopt, control::EstimateSource::Given, "kg*m^2"};
    row.header.quality.verdict = Verdict::Doubtful;
    view.setRows({row});
    EXPECT_EQ(text(0, 1), "simulated time");
    EXPECT_EQ(text(0, 3), "doubtful");
    EXPECT_TRUE(text(0, 7).endsWith("(given)")) << text(0, 7).toStdString();
}

} // namespace
} // namespace halbench::app
