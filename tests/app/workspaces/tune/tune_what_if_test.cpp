// A verification move as it would have been with other gains.
#include "app/workbench/shared_results.h"
#include "tests/app/workspaces/tune/tune_panel_fixture.h"

namespace halbench::app {
namespace {

class TuneWhatIfTest : public TunePanelTest {
protected:
    static constexpr const char* Predicted = "with the proposed gains";
    static constexpr const char* Band = "90 % band";

    std::vector<double> whatIf() const { return curve("Verification", Predicted); }
    QString remarks() const { return panel.findChild<widgets::VerdictView*>("agreement")->text(); }
    double overshoot_rad() const { return *std::max_element(whatIf().begin(), whatIf().end()) - 0.5; }

    /// Everything that is said below and above the picture.
    QString words() const {
        QStringList lines;
        for (const auto* label : panel.findChildren<QLabel*>()) {
            lines << label->text();
        }
        return lines.join('\n');
    }
};

TEST_F(TuneWhatIfTest, theMeasuredMoveIsDrawnAsItWouldBeWithTheProposedGains) {
    prepare();
    verify();
    EXPECT_TRUE(whatIf().empty()) << "the gains that ran have the record itself";
    choose("Source of the gains", "Method: pole placement");
    ASSERT_TRUE(wait([&] { return !whatIf().empty(); })) << verdict().toStdString();
    ASSERT_TRUE(wait([&] { return !curve("Verification", Band).empty(); }));
    const auto measured = curve("Verification", "measured");
    EXPECT_FALSE(measured.empty());
    // A PI loop on this motor is nearly undamped (htm-theory.md 3.6): it overshoots where the other did not.
    const std::vector<double> predicted = whatIf();
    EXPECT_GT(*std::max_element(predicted.begin(), predicted.end()),
              *std::max_element(measured.begin(), measured.end()) + 0.02);
    EXPECT_TRUE(wait([&] { return words().contains("With the proposed gains: overshoot"); }))
        << words().toStdString();
    EXPECT_TRUE(wait([&] { return words().contains("amplify model errors"); })) << words().toStdString();
}

TEST_F(TuneWhatIfTest, itFollowsTheGains) {
    prepare();
    verify();
    type("gain.kp", "20");
    ASSERT_TRUE(wait([&] { return !whatIf().empty(); }));
    const std::vector<double> before = whatIf();
    type("gain.kp", "25");
    EXPECT_TRUE(wait([&] { return !whatIf().empty() && whatIf() != before; }));
}

TEST_F(TuneWhatIfTest, unstableGainsHaveNoneAndSayWhy) {
    prepare();
    verify();
    type("gain.kp", "400");
    EXPECT_TRUE(wait([&] { return words().contains("No prediction for the proposed gains"); }))
        << words().toStdString();
    EXPECT_TRUE(whatIf().empty());
}

TEST_F(TuneWhatIfTest, aRecordOfAnotherMotorHasNone) {
    connectMotor("sim:htm?seed=4&J=1.65e-3", 0.0);
    bench.setIdentification(publishedMotor());
    ASSERT_TRUE(wait([&] { return canApply(); }));
    click(panel, "Apply and verify");
    ASSERT_TRUE(wait([&] { return message().contains("Not kept"); })) << message().toStdString();
    type("gain.kp", "20");
    EXPECT_TRUE(wait([&] { return words().contains("does not match the recorded move"); }))
        << words().toStdString();
    EXPECT_TRUE(whatIf().empty());
}

TEST_F(TuneWhatIfTest, itEndsWithItsDevice) {
    prepare();
    verify();
    type("gain.kp", "20");
    ASSERT_TRUE(wait([&] { return !whatIf().empty(); }));
    bench.session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return bench.session().state() == SessionState::Disconnected; }));
    EXPECT_FALSE(hasVerification());
    connectMotor("sim:htm?seed=9", 0.0);
    ASSERT_TRUE(wait([&] { return canApply(); }));
    verify();
    EXPECT_TRUE(whatIf().empty());
}

} // namespace
} // namespace halbench::app
