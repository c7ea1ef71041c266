#include "tests/app/workspaces/drive/drive_panel_fixture.h"
#include "widgets/controls/elided_label.h"

namespace halbench::app {
namespace {

TEST_F(DrivePanelTest, armsASimulatedMotorAtOnceAndDisarms) {
    EXPECT_FALSE(find<QPushButton>(*panel, "Arm")->isEnabled()); // no device
    connectTo("sim:htm", 5.0);
    armByClick();
    EXPECT_EQ(parameter("hb.mode"), 2.0);
    EXPECT_EQ(parameter("hb.setpoint"), 0.0);
    click(*panel, "Disarm");
    EXPECT_TRUE(wait([&] { return !isArmed(); }));
    EXPECT_TRUE(wait([&] { return !find<QPushButton>(*panel, "Go")->isEnabled(); }));
}

TEST_F(DrivePanelTest, sendsTheSetpointOnEnterAndNotOnLeavingTheField) {
    connectTo("sim:htm", 5.0);
    armByClick();
    auto* field = find<QDoubleSpinBox>(*panel, "Set-point");
    type(field, "12");
    QTest::keyClick(field, Qt::Key_Tab);
    EXPECT_EQ(parameter("hb.setpoint"), 0.0);
    type(field, "12");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_NEAR(parameter("hb.setpoint"), degreesToRadians(12.0), 1e-6); // a 4-octet float
    click(*panel, "Zero");
    EXPECT_EQ(parameter("hb.setpoint"), 0.0);
}

TEST_F(DrivePanelTest, commandsFollowThePreferredUnits) {
    connectTo("sim:htm", 5.0);
    armByClick();
    auto* field = find<QDoubleSpinBox>(*panel, "Set-point");
    auto* jog = find<QDoubleSpinBox>(*panel, "Jog speed");
    EXPECT_TRUE(field->suffix().endsWith("\u00b0") && jog->suffix().endsWith("r/min"));
    type(field, "12");
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_NEAR(parameter("hb.setpoint"), degreesToRadians(12.0), 1e-6);
    bench().setDisplayUnits({widgets::AngleUnit::Radian, SpeedUnit::DegreesPerSecond});
    EXPECT_TRUE(field->suffix().endsWith("rad") && jog->suffix().endsWith("\u00b0/s"));
    EXPECT_NEAR(field->value(), degreesToRadians(12.0), 5e-5);           // the same angle, in four decimals
    EXPECT_NEAR(jog->value(), 45.0, 1e-9);                               // and the same speed
    EXPECT_NEAR(parameter("hb.setpoint"), degreesToRadians(12.0), 1e-6); // nothing was sent
    type(field, "0.1");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_NEAR(parameter("hb.setpoint"), 0.1, 1e-6);
    QStringList texts;
    for (const auto* label : panel->findChildren<QLabel*>()) {
        texts << label->text();
    }
    const QString all = texts.join('\n');
    EXPECT_TRUE(all.contains("Set-point 0.1000\u00a0rad")) << all.toStdString();
    EXPECT_TRUE(all.contains("Travel: up to 0.5236\u00a0rad")) << all.toStdString();
    for (const auto* box : panel->findChildren<QDoubleSpinBox*>()) {
        EXPECT_FALSE(box->suffix().contains("r/min")) << box->accessibleName().toStdString();
    }
}

TEST_F(DrivePanelTest, aNewModeStartsAtZeroWithItsOwnUnit) {
    connectTo("sim:htm", 5.0);
    armByClick();
    auto* field = find<QDoubleSpinBox>(*panel, "Set-point");
    type(field, "5");
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_GT(parameter("hb.setpoint"), 0.0);
    chooseMode(1);
    ASSERT_TRUE(wait([&] { return field->suffix().endsWith("A"); }));
    EXPECT_EQ(field->value(), 0.0);
    EXPECT_EQ(parameter("hb.mode"), 1.0);
    EXPECT_EQ(parameter("hb.setpoint"), 0.0);
}

TEST_F(DrivePanelTest, jogMovesWhileHeldAndEndsWithTheFocus) {
    connectTo("sim:htm", 1.0); // a busy machine renews the hold of 0.3 s of the device
    armByClick();
    ASSERT_TRUE(wait([&] { return hasReference(); }));
    const double before = latest("reference");
    auto* forward = find<QPushButton>(*panel, "Forward +");
    const auto isEnded = [&] { return parameter("reference.start") == 0.0; };
    QTest::mousePress(forward, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return latest("reference") > before + 0.05; }));
    QTest::mouseRelease(forward, Qt::LeftButton);
    ASSERT_TRUE(isEnded()); // at once, not when the hold runs out
    QTest::qWait(100);      // the samples of before have come
    const double after = latest("reference");
    QTest::qWait(100);
    EXPECT_EQ(latest("reference"), after);

    forward->setFocus();
    QTest::keyPress(forward, Qt::Key_Space);
    ASSERT_TRUE(wait([&] { return latest("reference") > after + 0.05; }));
    find<QPushButton>(*panel, "Go")->setFocus();
    EXPECT_TRUE(isEnded());
}

TEST_F(DrivePanelTest, jogIsAnEvenRampBelowTheCurrentLimit) {
    connectTo("sim:htm", 1.0);
    armByClick();
    ASSERT_TRUE(wait([&] { return hasReference(); }));
    auto* forward = find<QPushButton>(*panel, "Forward +");
    const double begin_s = bench().history().latest("reference")->time_s;
    QTest::mousePress(forward, Qt::LeftButton);
    QTest::qWait(1000); // the hold is renewed six times
    const double end_s = bench().history().latest("reference")->time_s;
    QTest::mouseRelease(forward, Qt::LeftButton);
    std::vector<control::TimedValue> reference;
    bench().history().samples("reference", {begin_s, end_s}, reference);
    ASSERT_GT(reference.size(), 100U);
    for (std::size_t i = 1; i < reference.size(); ++i) {
        const double fastest_rad = degreesToRadians(45.0) * 0.010; // in a period of the position loop
        // Floats of some radians.
        EXPECT_LT(reference[i].value - reference[i - 1].value, fastest_rad + 1e-5);
        EXPECT_GE(reference[i].value, reference[i - 1].value);
    }
    EXPECT_GT(reference.back().value - reference.front().value, degreesToRadians(20.0));
    std::vector<control::TimedValue> current_A;
    bench().history().samples("current_command", {begin_s, end_s}, current_A);
    const double limit_A = bench().deviceValue("limit.current").value_or(0.0);
    for (const control::TimedValue& sample : current_A) {
        EXPECT_LT(std::abs(sample.value), limit_A); // is not in saturation
    }
}

TEST_F(DrivePanelTest, theBoardEndsAJogThatIsNotRenewed) {
    connectTo("sim:htm", 1.0);
    armByClick();
    auto* forward = find<QPushButton>(*panel, "Forward +");
    QTest::mousePress(forward, Qt::LeftButton);
    EXPECT_NEAR(parameter("reference.duration"), 0.3, 1e-6); // what follows without a window
    QTest::mouseRelease(forward, Qt::LeftButton);
}

TEST_F(DrivePanelTest, goAndZeroAfterAJogMoveNothing) {
    connectTo("sim:htm", 5.0);
    armByClick();
    ASSERT_TRUE(wait([&] { return hasReference(); }));
    const double before = latest("reference");
    auto* forward = find<QPushButton>(*panel, "Forward +");
    QTest::mousePress(forward, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return latest("reference") > before + 1.0; }));
    QTest::mouseRelease(forward, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return latest("reference.running") < 0.5; }));
    QTest::qWait(100);
    const double held = latest("reference");
    for (const char* words : {"Go", "Zero"}) {
        click(*panel, words);
        EXPECT_EQ(parameter("hb.setpoint"), 0.0);
        QTest::qWait(100);
        EXPECT_NEAR(latest("reference"), held, 1e-5) << words;
    }
}

TEST_F(DrivePanelTest, zeroSaysHowFarItSteps) {
    connectTo("sim:htm", 5.0);
    armByClick();
    auto* field = find<QDoubleSpinBox>(*panel, "Set-point");
    type(field, "12");
    QTest::keyClick(field, Qt::Key_Return);
    const auto* zero = find<QPushButton>(*panel, "Zero");
    EXPECT_TRUE(wait([&] { return zero->toolTip().contains("back by 12.00"); }));
    EXPECT_EQ(zero->accessibleDescription(), zero->toolTip());
}

TEST_F(DrivePanelTest, longWordsOfTheStateDoNotWidenThePanel) {
    connectTo("sim:htm", 5.0);
    auto* state = panel->findChild<widgets::ElidedLabel*>();
    const int least_px = state->parentWidget()->minimumSizeHint().width();
    state->setWords(QString(300, QLatin1Char('m')));
    EXPECT_EQ(state->parentWidget()->minimumSizeHint().width(), least_px);
    EXPECT_NE(state->text(), state->words());
}

TEST_F(DrivePanelTest, aJogSpeedThatIsNoNumberMovesNothing) {
    connectTo("sim:htm", 5.0);
    armByClick();
    auto* forward = find<QPushButton>(*panel, "Forward +");
    type(find<QDoubleSpinBox>(*panel, "Jog speed"), "4000");            // more than 600 r/min
    forward->setFocus();                                                // as by a click
    EXPECT_EQ(find<QDoubleSpinBox>(*panel, "Jog speed")->value(), 7.5); // 45 degrees per second
    EXPECT_TRUE(message().contains("'4000")) << message().toStdString();
    QTest::mousePress(forward, Qt::LeftButton);
    QTest::qWait(100); // five periods of the jog
    QTest::mouseRelease(forward, Qt::LeftButton);
    EXPECT_EQ(latest("reference.running"), 0.0);
    QTest::mousePress(forward, Qt::LeftButton); // once more: by the number that is shown
    EXPECT_TRUE(wait([&] { return latest("reference.running") > 0.5; }));
    QTest::mouseRelease(forward, Qt::LeftButton);
}

TEST_F(DrivePanelTest, aReferenceWithATextThatIsNoNumberDoesNotStart) {
    connectTo("sim:htm", 5.0);
    armByClick();
    const double before = parameter("reference.amplitude");
    auto* amplitude = find<QDoubleSpinBox>(*panel, "Amplitude");
    type(amplitude, "1e"); // and Start by its shortcut: the field keeps the focus
    for (int i = 0; i < 2; ++i) {
        find<QPushButton>(*panel, "Start")->click();
        EXPECT_TRUE(message().contains("'1e")) << message().toStdString();
    }
    QTest::keyClick(amplitude, Qt::Key_Tab);
    click(*panel, "Start");
    EXPECT_TRUE(message().contains("'1e")) << message().toStdString();
    EXPECT_EQ(parameter("reference.amplitude"), before);
    EXPECT_LT(latest("reference.running"), 0.5);
    type(amplitude, "12");
    find<QPushButton>(*panel, "Start")->click(); // what was typed, not what was there before
    ASSERT_TRUE(wait([&] { return latest("reference.running") > 0.5; }));
    EXPECT_NEAR(parameter("reference.amplitude"), degreesToRadians(12.0), 1e-6); // a 4-octet float
}

TEST_F(DrivePanelTest, jogOfACurrentEndsWhenLetGo) {
    connectTo("sim:htm", 1.0);
    armByClick();
    chooseMode(1);
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Go")->isEnabled(); }));
    auto* back = find<QPushButton>(*panel, QString::fromUtf8("\u2212 Back"));
    QTest::mousePress(back, Qt::LeftButton);
    EXPECT_TRUE(wait([&] { return latest("current_command") == -0.5; }));
    QTest::mouseRelease(back, Qt::LeftButton);
    EXPECT_TRUE(wait([&] { return latest("current_command") == 0.0; }));
}

TEST_F(DrivePanelTest, aCurrentBeyondTheLimitIsAFaultInWords) {
    connectTo("sim:htm", 5.0);
    auto* limit = find<QDoubleSpinBox>(*panel, "Limit of Current");
    ASSERT_TRUE(wait([&] { return limit->isEnabled(); }));
    type(limit, "0.3");
    QTest::keyClick(limit, Qt::Key_Return);
    ASSERT_TRUE(wait([&] { return bench().deviceValue("limit.current").value_or(0.0) < 0.31; }));
    chooseMode(1);
    armByClick();
    click(*panel, "Start"); // a step of 0.5 A
    EXPECT_TRUE(wait([&] { return message().contains("Current command above"); })) << message().toStdString();
}

TEST_F(DrivePanelTest, theGeneratorRunsFromHereAndEnds) {
    connectTo("sim:htm", 5.0);
    armByClick();
    click(*panel, "Start");
    ASSERT_TRUE(wait([&] { return latest("reference.running") > 0.5; }));
    EXPECT_NEAR(parameter("reference.amplitude"), degreesToRadians(30.0), 1e-6);
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "End")->isEnabled(); }));
    click(*panel, "End");
    EXPECT_TRUE(wait([&] { return latest("reference.running") < 0.5; }));
    EXPECT_TRUE(isArmed());
}

TEST_F(DrivePanelTest, aLimitIsWrittenByEnterOnlyAndNotUnderAProcedure) {
    connectTo("sim:htm", 5.0);
    auto* limit = find<QDoubleSpinBox>(*panel, "Limit of Current");
    ASSERT_TRUE(wait([&] { return limit->isEnabled(); }));
    const double before = limit->value();
    const double onBoard_A = parameter("limit.current");
    type(limit, "0.3");
    QTest::keyClick(limit, Qt::Key_Tab);
    EXPECT_EQ(parameter("limit.current"), onBoard_A);
    EXPECT_EQ(limit->value(), before); // the text was taken back

    std::promise<void> end;
    ASSERT_TRUE(session().runProcedure(
        "Identify",
        [&end](devices::Device&, const ProcedureObserver&) -> Result<void> {
            end.get_future().wait();
            return {};
        },
        [](const Result<void>&) {}));
    EXPECT_FALSE(limit->isEnabled());
    EXPECT_FALSE(find<QCheckBox>(*panel, "Excursion")->isEnabled());
    end.set_value();
    EXPECT_TRUE(wait([&] { return limit->isEnabled(); }));
}

TEST_F(DrivePanelTest, theNextReferenceBeginsAtTheAngleThatIsHeld) {
    connectTo("sim:htm", 5.0);
    armByClick();
    const auto step = [&] { // by 30 degrees
        click(*panel, "Start");
        EXPECT_TRUE(wait([&] { return latest("reference.running") > 0.5; }));
        const double to_rad = latest("reference");
        EXPECT_TRUE(wait([&] { return find<QPushButton>(*panel, "End")->isEnabled(); }));
        click(*panel, "End");
        EXPECT_TRUE(wait([&] { return latest("reference.running") < 0.5; }));
        return to_rad;
    };
    const double first_rad = step();
    EXPECT_NEAR(step(), first_rad + degreesToRadians(30.0), 1e-5); // float of some radians
}

TEST_F(DrivePanelTest, heldAngleAndSetpointTogetherStayInsideTheWindow) {
    connectTo("sim:htm", 1.0); // a jog is renewed each 0.3 s of the device, on a busy machine too
    bench().writeValues({{"window.position", degreesToRadians(60.0)}, {"window.position_enabled", 1.0}},
                        [](const Result<void>&) {});
    ASSERT_TRUE(wait([&] { return bench().deviceValue("window.position_enabled") == 1.0; }));
    armByClick();
    click(*panel, "Start"); // a step by 30 degrees
    ASSERT_TRUE(wait([&] { return latest("reference.running") > 0.5; }));
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "End")->isEnabled(); }));
    click(*panel, "End");
    ASSERT_TRUE(wait([&] { return !find<QPushButton>(*panel, "End")->isEnabled(); }));
    auto* field = find<QDoubleSpinBox>(*panel, "Set-point");
    type(field, "45"); // 75 degrees from where it was armed
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_EQ(parameter("hb.setpoint"), 0.0);
    EXPECT_TRUE(message().contains("outside the excursion window")) << message().toStdString();
    auto* forward = find<QPushButton>(*panel, "Forward +");
    // Slowly and from rest, r/min: the rotor must not swing over the window's end, where the board stops it.
    type(find<QDoubleSpinBox>(*panel, "Jog speed"), "20");
    ASSERT_TRUE(wait([&] { return bench().drive().excursion_rad() > degreesToRadians(29.0); }));
    ASSERT_TRUE(wait([&] { return std::abs(latest("speed")) < 0.1; }));
    QTest::mousePress(forward, Qt::LeftButton);
    // 90 % of the window, what was held included; the origin is known to a sample of the angle, which is up
    // to a degree off when the machine is busy: the last 10 % are there for that.
    EXPECT_TRUE(wait([&] { return latest("reference") > degreesToRadians(0.9 * 60.0 - 2.0); }));
    QTest::mouseRelease(forward, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return latest("reference.running") < 0.5; }));
    EXPECT_EQ(parameter("hb.setpoint"), 0.0);
    EXPECT_NEAR(bench().drive().held_rad(), degreesToRadians(0.9 * 60.0), degreesToRadians(2.0));
}

TEST_F(DrivePanelTest, aStopLeavesTheFocusWhereNoKeyChangesAnything) {
    connectTo("sim:htm", 5.0);
    armByClick();
    auto* start = find<QPushButton>(*panel, "Start");
    start->setFocus();
    session().stopActuator();
    ASSERT_TRUE(wait([&] { return !start->isEnabled(); }));
    const QWidget* focus = panel->focusWidget();
    EXPECT_NE(qobject_cast<const QLabel*>(focus), nullptr) << focus->accessibleName().toStdString();
}

TEST_F(DrivePanelTest, messagesMoveNoControl) {
    connectTo("sim:htm", 5.0);
    armByClick();
    QTest::qWait(50); // laid out
    const auto places = [&] {
        QString all;
        for (const char* words : {"Go", "Start", "Disarm", "Limit of Current"}) {
            const QWidget* one = find<QWidget>(*panel, words);
            all += QString("%1: %2 ").arg(words).arg(one->mapTo(panel.get(), QPoint()).y());
        }
        return all;
    };
    const QString before = places();
    auto* field = find<QDoubleSpinBox>(*panel, "Set-point");
    type(field, "400000");
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_FALSE(message().isEmpty());
    QTest::qWait(50);
    EXPECT_EQ(places(), before);
    find<QDoubleSpinBox>(*panel, "Amplitude")->setValue(9000.0); // far: a warning in the line below Start
    QTest::qWait(50);
    EXPECT_EQ(places(), before);
}

TEST_F(DrivePanelTest, windowsAreSwitchedAndWarnBeforeTheMotion) {
    connectTo("sim:htm", 5.0);
    auto* excursion = find<QDoubleSpinBox>(*panel, "Limit of Excursion");
    ASSERT_TRUE(wait([&] { return excursion->isEnabled(); }));
    type(excursion, "20");
    QTest::keyClick(excursion, Qt::Key_Return);
    auto* isWatched = find<QCheckBox>(*panel, "Excursion");
    QTest::mouseClick(isWatched, Qt::LeftButton, {}, QPoint(8, isWatched->height() / 2));
    ASSERT_TRUE(wait([&] { return bench().deviceValue("window.position_enabled").value_or(0.0) == 1.0; }));
    EXPECT_NEAR(*bench().deviceValue("window.position"), degreesToRadians(20.0), 1e-6);
    const auto labels = panel->findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(),
                            [](const QLabel* label) { return label->text().contains("Above the limit"); }));
}

} // namespace
} // namespace halbench::app
