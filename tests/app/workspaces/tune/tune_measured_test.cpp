#include "app/documents/result_documents.h"
#include "app/documents/text/output_file.h"
#include "app/workbench/shared_results.h"
#include "control/base/units.h"
#include "tests/app/workspaces/tune/tune_panel_fixture.h"

namespace halbench::app {
namespace {

/// A measured response in the open loop of the Tune panel.
class TuneMeasuredTest : public TunePanelTest {
protected:
    void SetUp() override {
        TunePanelTest::SetUp();
        panel.setFileChooser({[this](QWidget*, const FileQuestion&) { return gainsPath(); },
                              [this](QWidget*, const FileQuestion&) { return path(); }});
        bench.setIdentification(publishedMotor());
        ASSERT_TRUE(wait([&] { return bench.design().has_value(); }));
    }

    QString path() const { return m_folder.filePath("response.json"); }

    void write(double period_s) const {
        FrequencyResult result;
        result.period_s = period_s;
        for (const double frequency_Hz : {1.0, 2.0, 4.0, 8.0}) {
            const double w = 2.0 * Pi * frequency_Hz;
            FrequencyResultPoint point;
            point.measured = {w, -26.0 / (w * w), 1e-4, 0.99, 8};
            point.isUsed = frequency_Hz < 5.0;
            result.points.push_back(point);
        }
        ResultHeader header;
        header.schema = "halbench.frequency/1";
        ASSERT_TRUE(writeFile(path().toStdString(), *toJsonText(frequencyDocument(header, result))));
    }
};

// The recommended gains on 26/(j w)^2 at 1 Hz: 40 - 60 T/2 + ... near 40 A/rad times 0.659 rad/A, 28.4 dB;
// the derivative adds 1.4 w = 8.8 A/rad across it: 28.6 dB.
TEST_F(TuneMeasuredTest, isDrawnWithTheProposedGainsAndFollowsThem) {
    write(0.01);
    click(panel, "Measured response\u2026");
    ASSERT_TRUE(wait([&] { return !curve("Open loop", "measured").empty(); })) << message().toStdString();
    EXPECT_EQ(curve("Open loop", "measured").size(), 3U);
    EXPECT_EQ(curve("Open loop", "measured, low coherence").size(), 1U);
    EXPECT_NEAR(curve("Open loop", "measured").front(), 28.6, 0.3);
    EXPECT_TRUE(message().contains("response")) << message().toStdString();
    choose("Source of the gains", "Method: LQR");
    ASSERT_TRUE(wait([&] { return std::abs(curve("Open loop", "measured").front() - 28.6) > 1.0; }));
    click(panel, "Remove the response");
    EXPECT_TRUE(curve("Open loop", "measured").empty());
    EXPECT_NE(button(panel, "Measured response\u2026"), nullptr);
}

TEST_F(TuneMeasuredTest, itsCoherenceStandsOnTheSameFrequencyAxis) {
    write(0.01);
    ASSERT_EQ(figure("Open loop")->figure().panels.size(), 2U);
    click(panel, "Measured response\u2026");
    ASSERT_TRUE(wait([&] { return figure("Open loop")->figure().panels.size() == 3U; }));
    const widgets::Panel& coherence = figure("Open loop")->figure().panels.at(2);
    EXPECT_EQ(coherence.curves.at(0).y, (std::vector<double>{0.99, 0.99, 0.99}));
    EXPECT_EQ(coherence.lines.at(0).at, 0.9);
    auto* view = const_cast<widgets::FigureView*>(figure("Open loop"));
    view->probeAlong(2.0);
    EXPECT_TRUE(view->probeText().contains("coherence")) << view->probeText().toStdString();
}

TEST_F(TuneMeasuredTest, isDrawnIntoNyquistAndNicholsToo) {
    write(0.01);
    click(panel, "Measured response\u2026");
    ASSERT_TRUE(wait([&] { return !curve("Open loop", "measured").empty(); })) << message().toStdString();
    for (const auto& [view, title] : {std::pair("Nyquist", "Nyquist plot of the open loop"),
                                      std::pair("Nichols", "Nichols plot of the open loop")}) {
        choose("Open-loop plot", view);
        EXPECT_EQ(curve(title, "measured").size(), 3U) << view;
        EXPECT_EQ(curve(title, "measured, low coherence").size(), 1U) << view;
    }
}

TEST_F(TuneMeasuredTest, whatIsNoResponseOfThisLoopIsRefusedWithTheReason) {
    ASSERT_TRUE(writeFile(path().toStdString(), "{}"));
    click(panel, "Measured response\u2026");
    ASSERT_TRUE(wait([&] { return message().contains("schema"); })) << message().toStdString();
    write(0.005);
    click(panel, "Measured response\u2026");
    ASSERT_TRUE(wait([&] { return message().contains("5 ms"); })) << message().toStdString();
    EXPECT_TRUE(curve("Open loop", "measured").empty());
}

TEST_F(TuneMeasuredTest, anotherProjectHasNoneOfIt) {
    write(0.01);
    click(panel, "Measured response\u2026");
    ASSERT_TRUE(wait([&] { return !curve("Open loop", "measured").empty(); }));
    panel.restoreDesign(std::nullopt);
    ASSERT_TRUE(wait([&] { return curve("Open loop", "measured").empty(); }));
    EXPECT_NE(button(panel, "Measured response\u2026"), nullptr);
}

} // namespace
} // namespace halbench::app
