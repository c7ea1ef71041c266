// Gains that go onto the device in small steps.
#include "app/workbench/shared_results.h"
#include "tests/app/workspaces/tune/tune_panel_fixture.h"

namespace halbench::app {
namespace {

class TuneStepsTest : public TunePanelTest {
protected:
    QCheckBox* inSteps() const {
        for (auto* box : panel.findChildren<QCheckBox*>()) {
            if (box->accessibleName() == "Apply gradually") {
                return box;
            }
        }
        return nullptr;
    }
    void applyInSteps() {
        inSteps()->setFocus();
        QTest::keyClick(inSteps(), Qt::Key_Space);
        ASSERT_TRUE(inSteps()->isChecked());
        click(panel, "Apply and verify");
    }
    bool says(const char* part) const {
        const auto labels = panel.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [part](const QLabel* label) {
            return label->isVisible() && plain(label->text()).contains(part);
        });
    }
};

TEST_F(TuneStepsTest, whatItDoesIsSaidBeforeItIsPressed) {
    prepare();
    EXPECT_TRUE(says("Verification: 0.5 rad"));
    inSteps()->setFocus();
    QTest::keyClick(inSteps(), Qt::Key_Space);
    EXPECT_TRUE(says("Verification after each step: 0.5 rad forth and back"));
    EXPECT_FALSE(says("Verification: "));
}

TEST_F(TuneStepsTest, theyLeadToTheProposedGains) {
    prepare();
    const auto before = valuesNow();
    QStringList told;
    QObject::connect(&bench.session(), &DeviceSession::procedureProgress, &panel,
                     [&told](double, const QString& text) { told << text; });
    applyInSteps();
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Keep"); })) << message().toStdString();
    EXPECT_NE(valuesNow(), before);
    EXPECT_TRUE(std::any_of(told.begin(), told.end(),
                            [](const QString& text) { return text.startsWith("step 3 of 8"); }));
    EXPECT_TRUE(hasVerification()); // of the last one
    click(panel, "Restore");
    ASSERT_TRUE(wait([&] { return message().contains("revious gains restored"); }));
    EXPECT_EQ(valuesNow(), before) << "those of before all steps";
}

TEST_F(TuneStepsTest, aMotorThatMovesOtherwiseHasItsOldGains) {
    connectMotor("sim:htm?seed=4&J=1.65e-3", 0.0);
    bench.setIdentification(publishedMotor());
    ASSERT_TRUE(wait([&] { return canApply(); }));
    const auto before = valuesNow();
    applyInSteps();
    ASSERT_TRUE(wait([&] { return message().contains("outside the predicted band"); }))
        << message().toStdString();
    EXPECT_TRUE(message().startsWith("Not kept, previous gains restored"));
    EXPECT_EQ(valuesNow(), before);
    EXPECT_EQ(button(panel, "Keep"), nullptr);
}

TEST_F(TuneStepsTest, aWayThatIsNotSafeIsNotBegun) {
    prepare();
    const auto before = valuesNow();
    type("gain.kp", "16.5"); // below the limit of 17.27 A/rad, with no room for the motor's uncertainty
    type("gain.ki", "0");
    type("gain.kd", "0");
    ASSERT_TRUE(wait([&] { return canApply(); })) << verdict().toStdString();
    applyInSteps();
    ASSERT_TRUE(wait([&] { return message().contains("is not safe"); })) << message().toStdString();
    EXPECT_EQ(valuesNow(), before);
}

TEST_F(TuneStepsTest, cancelledTheyLeaveWhatWasBeforeAllOfThem) {
    prepare();
    const auto before = valuesNow();
    bool isCancelled = false;
    QObject::connect(&bench.session(), &DeviceSession::procedureProgress, &panel,
                     [&](double, const QString& text) {
                         if (text.startsWith("step 3") && !isCancelled) {
                             isCancelled = true;
                             bench.session().abortProcedure();
                         }
                     });
    bench.session().setPace({20.0}); // so that the word comes before the end
    applyInSteps();
    ASSERT_TRUE(wait([&] { return message().startsWith("Cancelled"); })) << message().toStdString();
    EXPECT_EQ(valuesNow(), before);
}

} // namespace
} // namespace halbench::app
