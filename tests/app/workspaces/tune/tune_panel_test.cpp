#include "app/workbench/shared_results.h"
#include "tests/app/workspaces/tune/axes/axis_model_fixture.h"
#include "tests/app/workspaces/tune/tune_panel_fixture.h"

#include <QFile>
#include <QRegularExpression>

namespace halbench::app {
namespace {

TEST_F(TunePanelTest, withoutAMotorItOffersToIdentifyOne) {
    QSignalSpy asked(&panel, &TunePanel::identifyRequested);
    click(panel, "Identify the motor");
    EXPECT_EQ(asked.count(), 1);
    EXPECT_EQ(button(panel, "Apply and verify"), nullptr);
}

TEST_F(TunePanelTest, withoutIdentifiedAxesItOffersToIdentifyThem) {
    connectMotor("sim:planar", 0.0);
    ASSERT_TRUE(wait([&] { return button(panel, "Identify the axes") != nullptr; }));
    EXPECT_EQ(button(panel, "Identify the motor"), nullptr);
    bench.session().disconnectDevice();
    EXPECT_TRUE(wait([&] { return button(panel, "Identify the motor") != nullptr; }));
}

// Other axes than those that were identified are not tuned with their model.
TEST_F(TunePanelTest, showsTheLoopsOfIdentifiedAxesOnADeviceOfTheirModelOnly) {
    connectMotor("sim:planar", 0.0);
    AxisModelFile model = platenModelFile();
    panel.useAxisModel(model);
    EXPECT_NE(button(panel, "Apply and verify"), nullptr);
    EXPECT_EQ(button(panel, "Identify the axes"), nullptr);
    model.header.device->model = "another";
    panel.useAxisModel(model);
    EXPECT_EQ(button(panel, "Apply and verify"), nullptr);
    EXPECT_NE(button(panel, "Identify the axes"), nullptr);
}

TEST_F(TunePanelTest, recommendsThePresetOfThePublishedMotorAndSavesIt) {
    bench.setIdentification(publishedMotor());
    ASSERT_TRUE(wait([&] { return bench.design().has_value(); }));
    EXPECT_NEAR(shown("gain.kp"), 40.0, 1e-4); // htm-theory.md 8.4
    EXPECT_NEAR(shown("gain.ki"), 60.0, 1e-4);
    EXPECT_NEAR(shown("gain.kd"), 1.4, 1e-4);
    EXPECT_FALSE(canApply()); // no device
    click(panel, "Save gains\u2026");
    ASSERT_TRUE(wait([&] { return message().startsWith("Saved"); })) << message().toStdString();
    const auto file = readGainsFile(gainsPath().toStdString());
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_EQ(file->law.gains.proportional, bench.design()->law.gains.proportional);
}

TEST_F(TunePanelTest, underANameOfCTheLawIsSavedAsCode) {
    const QString path = m_folder.filePath("law.c");
    panel.setFileChooser({[&path](QWidget*, const FileQuestion&) { return path; }, {}});
    bench.setIdentification(publishedMotor());
    ASSERT_TRUE(wait([&] { return bench.design().has_value(); }));
    click(panel, "Save gains\u2026");
    ASSERT_TRUE(wait([&] { return message().startsWith("Saved"); })) << message().toStdString();
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QString code = QString::fromUtf8(file.readAll());
    const auto gain = QRegularExpression("KP = ([0-9.e+-]+);").match(code);
    ASSERT_TRUE(gain.hasMatch()) << code.toStdString();
    EXPECT_EQ(gain.captured(1).toDouble(), bench.design()->law.gains.proportional);
    EXPECT_TRUE(code.contains("position_law_step"));
}

TEST_F(TunePanelTest, gainsPerDegreeAreThoseOfTheBoardOver57) {
    bench.setIdentification(publishedMotor());
    ASSERT_TRUE(wait([&] { return bench.design().has_value(); }));
    choose("Unit of the gains", "A/\u00b0");
    EXPECT_NEAR(shown("gain.kp"), 40.0 / 57.29578, 1e-4);
    type("gain.kp", "0.5");
    ASSERT_TRUE(
        wait([&] { return std::abs(bench.design()->law.gains.proportional - 0.5 * 57.29578) < 1e-4; }));
}

TEST_F(TunePanelTest, anEditIsPredictedAndMarkedAsOne) {
    bench.setIdentification(publishedMotor());
    ASSERT_TRUE(wait([&] { return bench.design().has_value(); }));
    const auto before = panel.findChild<widgets::FigureView*>()->figure().panels.at(0).curves.at(0).y;
    type("gain.kp", "20");
    ASSERT_TRUE(wait([&] { return bench.design()->law.gains.proportional == 20.0; }));
    EXPECT_EQ(bench.design()->method, "edited");
    EXPECT_EQ(panel.findChild<TuneForm*>()->origin(), TuneForm::Origin::Edited);
    EXPECT_NE(panel.findChild<widgets::FigureView*>()->figure().panels.at(0).curves.at(0).y, before);
    choose("Source of the gains", "Preset: published");
    ASSERT_TRUE(wait([&] { return bench.design()->law.gains.proportional == 10.0; }));
    EXPECT_NEAR(shown("gain.ki"), 0.1, 1e-12);
}

TEST_F(TunePanelTest, targetsAreThoseOfTheMethod) {
    bench.setIdentification(publishedMotor());
    EXPECT_FALSE(edit("bandwidth-hz")->isVisible());
    choose("Source of the gains", "Method: bandwidth");
    ASSERT_TRUE(edit("bandwidth-hz")->isVisible());
    type("bandwidth-hz", "6");
    ASSERT_TRUE(wait([&] { return bench.design() && bench.design()->targets.bandwidth_Hz == 6.0; }));
    type("bandwidth-hz", "1000"); // not with this sampling: says what is possible
    EXPECT_TRUE(wait([&] { return verdict().contains("between 0 and 50"); })) << verdict().toStdString();
}

TEST_F(TunePanelTest, theLeastErrorHasBoundsAndSaysWhichOneCounts) {
    const auto number = [&](const QString& name) {
        const auto* table = panel.findChild<TuneNumbers*>();
        for (int row = 0; row < table->rowCount(); ++row) {
            if (table->item(row, 0)->text().startsWith(name)) {
                return table->item(row, 1)->text();
            }
        }
        return QString();
    };
    bench.setIdentification(publishedMotor());
    choose("Source of the gains", "Method: least IAE");
    ASSERT_TRUE(edit("max-sensitivity")->isVisible() && edit("current-limit-a")->isVisible());
    ASSERT_TRUE(wait([&] { return number("Sensitivity p").contains("limit active"); }));
    EXPECT_EQ(number("Sensitivity p"), "1.7 of 1.7: limit active");
    EXPECT_FALSE(number("Current in a step").contains("limit active")); // 40 A/rad on 2 degrees
    type("current-limit-a", "1");
    type("step-deg", "5");
    ASSERT_TRUE(wait([&] { return bench.design() && bench.design()->targets.step_deg == 5.0; }));
    EXPECT_LE(bench.design()->law.gains.proportional, 1.001 * 180.0 / (5.0 * 3.14159265));
    ASSERT_TRUE(wait([&] { return number("Current in a step").contains("limit active"); }));
    EXPECT_EQ(number("Current in a step"), "1 A of 1 A: limit active");
    type("max-sensitivity", "1");
    EXPECT_TRUE(wait([&] { return verdict().contains("Maximum Ms"); })) << verdict().toStdString();
    type("max-sensitivity", "1.4");
    type("current-limit-a", "5"); // no board of this model gives that
    EXPECT_TRUE(wait([&] { return verdict().contains("device limit of 4 A"); })) << verdict().toStdString();
}

TEST_F(TunePanelTest, noNumberThatIsNoneReachesAGain) {
    prepare();
    const auto before = valuesNow();
    for (const char* gain : {"gain.kp", "gain.ki", "gain.kd"}) {
        for (const char* text : {"nan", "inf", "1e999", "-1", "", "abc"}) {
            type(gain, "1");
            ASSERT_TRUE(wait([&] { return !verdict().contains("number"); }));
            type(gain, text);
            if (*text == '\0') {
                QTest::keyClick(edit(gain), Qt::Key_Backspace);
            }
            EXPECT_FALSE(canApply()) << gain << " " << text;
        }
        choose("Source of the gains", "Method: recommended");
        ASSERT_TRUE(wait([&] { return canApply(); }));
    }
    EXPECT_EQ(valuesNow(), before);
}

TEST_F(TunePanelTest, anInvalidNumberIsNotOvertakenByTheAnswerToAnOlderOne) {
    prepare();
    type("gain.kp", "39");
    ASSERT_TRUE(wait([&] { return canApply(); }));
    type("gain.kp", "38");  // its worker runs
    type("gain.kp", "-38"); // back to back: nothing was delivered in between
    EXPECT_FALSE(canApply());
    ASSERT_TRUE(
        wait([&] { return !panel.isComputing(); })); // an answer that were still to come would be here
    EXPECT_FALSE(canApply());
    EXPECT_TRUE(verdict().contains("Proportional")) << verdict().toStdString();
}

TEST_F(TunePanelTest, anUnstableEditCannotBeApplied) {
    prepare();
    type("gain.kd", "0");
    type("gain.kp", "30"); // above 17.27 A/rad (htm-theory.md 3.7)
    ASSERT_TRUE(wait([&] { return bench.design()->law.gains.proportional == 30.0; }));
    EXPECT_TRUE(verdict().startsWith("Rejected")) << verdict().toStdString();
    EXPECT_FALSE(canApply());
}

TEST_F(TunePanelTest, appliesVerifiesDrawsAndRestores) {
    prepare();
    const auto before = valuesNow();
    click(panel, "Apply and verify");
    ASSERT_TRUE(wait([&] { return !message().isEmpty(); }));
    ASSERT_TRUE(message().startsWith("Applied")) << message().toStdString();
    const auto after = valuesNow();
    EXPECT_NEAR(after.at("gain.kp"), 40.0, 1e-4);
    EXPECT_EQ(after.at("window.speed"), before.at("window.speed")); // the windows of the move are gone
    EXPECT_FALSE(bench.session().report().board.isArmed);
    const widgets::FigureView* verification = nullptr;
    ASSERT_TRUE(wait([&] {
        for (auto* view : panel.findChildren<widgets::FigureView*>()) {
            verification = view->accessibleName().startsWith("Verification") ? view : verification;
        }
        return verification != nullptr && verification->isVisible();
    }));
    for (const char* part : {"set-point", "predicted", "measured"}) {
        EXPECT_FALSE(curve("Verification", part).empty()) << part;
    }
    const QString words = agreement();
    EXPECT_TRUE(words.startsWith("Within the predicted band")) << words.toStdString();
    EXPECT_TRUE(words.contains("max. deviation from the prediction")) << words.toStdString();
    click(panel, "Restore");
    ASSERT_TRUE(wait([&] { return message().contains("revious gains restored"); }));
    EXPECT_TRUE(agreement().contains("no longer active")) << agreement().toStdString();
    EXPECT_EQ(valuesNow(), before);
    EXPECT_EQ(button(panel, "Restore"), nullptr);
}

TEST_F(TunePanelTest, aDoubleClickOnApplyKeepsNothing) {
    prepare();
    click(panel, "Apply and verify");
    std::optional<bool> wasEnabled;
    ASSERT_TRUE(wait([&] {
        if (const auto* keep = button(panel, "Keep"); keep != nullptr && !wasEnabled) {
            wasEnabled = keep->isEnabled();
        }
        return wasEnabled.has_value();
    }));
    EXPECT_FALSE(*wasEnabled) << "its place is where Apply was clicked";
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Keep"); }));
    EXPECT_TRUE(isEnabled(panel, "Restore"));
}

TEST_F(TunePanelTest, keepLetsTheNewGainsStay) {
    prepare();
    click(panel, "Apply and verify");
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Keep"); })) << message().toStdString();
    click(panel, "Keep");
    EXPECT_EQ(button(panel, "Restore"), nullptr);
    EXPECT_NEAR(valuesNow().at("gain.kp"), 40.0, 1e-4);
}

// Open loop at the lowest frequency: |L| is in proportion to K_P there, which tells the gains apart.
TEST_F(TunePanelTest, beforeStaysWhatRanBeforeTheApplyUntilThatIsDecided) {
    prepare();
    const QStringList pictures = {"Open loop", "Predicted step with", "Predicted step of"};
    std::map<QString, std::vector<double>> before;
    std::map<QString, std::vector<double>> proposed;
    for (const QString& picture : pictures) {
        before[picture] = curve(picture, "before");
        proposed[picture] = curve(picture, "proposed");
        ASSERT_FALSE(before[picture].empty()) << picture.toStdString();
        ASSERT_NE(before[picture], proposed[picture]);
    }
    const auto areAsBefore = [&] {
        return std::all_of(pictures.begin(), pictures.end(), [&](const QString& picture) {
            return curve(picture, "before") == before[picture] &&
                   curve(picture, "proposed") == proposed[picture];
        });
    };
    const auto numbersHeader = [&] {
        return panel.findChild<TuneNumbers*>()->horizontalHeaderItem(3)->text();
    };
    EXPECT_EQ(numbersHeader(), "On the device");
    click(panel, "Apply and verify");
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Keep"); })) << message().toStdString();
    EXPECT_NEAR(valuesNow().at("gain.kp"), 40.0, 1e-4); // and every value is read anew
    ASSERT_TRUE(wait([&] { return canApply(); }));
    EXPECT_TRUE(areAsBefore());
    click(panel, "Apply and verify"); // again, undecided: before is still what ran at first
    ASSERT_TRUE(wait([&] { return bench.session().procedure().isEmpty() && canApply(); }));
    EXPECT_TRUE(areAsBefore());
    EXPECT_EQ(numbersHeader(), "Before applying");
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Keep"); }));
    click(panel, "Keep");
    ASSERT_TRUE(wait([&] { return curve("Open loop", "before") == proposed["Open loop"]; }));
    EXPECT_EQ(numbersHeader(), "On the device");
}

TEST_F(TunePanelTest, restoreAfterTwoAppliesBringsBackWhatRanBeforeBoth) {
    prepare();
    const auto before = valuesNow();
    click(panel, "Apply and verify");
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Keep"); })) << message().toStdString();
    type("gain.kp", "38");
    ASSERT_TRUE(wait([&] { return canApply(); }));
    click(panel, "Apply and verify");
    ASSERT_TRUE(wait([&] { return message().startsWith("Applied") && canApply(); }));
    EXPECT_NEAR(valuesNow().at("gain.kp"), 38.0, 1e-4);
    click(panel, "Restore");
    ASSERT_TRUE(wait([&] { return message().contains("revious gains restored"); }));
    EXPECT_EQ(valuesNow(), before);
}

TEST_F(TunePanelTest, theFocusGoesToTheDecisionAndThenToTheChoiceOfGains) {
    prepare();
    QApplication::setActiveWindow(&panel);
    click(panel, "Apply and verify");
    EXPECT_TRUE(wait([&] { return focused() == "Keep"; })) << focused().toStdString();
    click(panel, "Restore");
    EXPECT_TRUE(wait([&] { return focused() == "Source of the gains"; })) << focused().toStdString();
    ASSERT_TRUE(wait([&] { return canApply(); }));
    click(panel, "Apply and verify");
    EXPECT_TRUE(wait([&] { return focused() == "Keep"; })) << focused().toStdString();
    click(panel, "Keep");
    EXPECT_TRUE(wait([&] { return focused() == "Source of the gains"; })) << focused().toStdString();
}

TEST_F(TunePanelTest, valuesThatAreReadAgainAskNothingAnew) {
    prepare();
    const QSignalSpy designs(&bench, &Workbench::designChanged);
    const auto before = valuesNow(); // all values were read: nothing of the loop changed
    EXPECT_TRUE(canApply());         // so its prediction still holds
    ASSERT_TRUE(wait([&] { return !before.empty(); }));
    bench.writeValues({{"window.speed", before.at("window.speed") * 0.9}}, [](const Result<void>&) {});
    EXPECT_EQ(valuesNow().at("window.speed"), before.at("window.speed") * 0.9);
    EXPECT_TRUE(canApply());
    EXPECT_EQ(designs.count(), 0);
    bench.writeValues({{"limit.current", 2.0}}, [](const Result<void>&) {});
    ASSERT_TRUE(wait([&] { return designs.count() > 0; }));
    EXPECT_EQ(bench.design()->conditions.currentLimit_A, 2.0);
    bench.session().disconnectDevice(); // the shipped profile of the motor again
    EXPECT_TRUE(wait([&] { return bench.design()->conditions.currentLimit_A == 4.0; }));
}

TEST_F(TunePanelTest, cancelInEachStageRestoresTheGainsAndDisarms) {
    prepare();
    const auto before = valuesNow();
    for (const ProcedureState stage :
         {ProcedureState::Prepare, ProcedureState::Propose, ProcedureState::Apply, ProcedureState::Verify}) {
        ASSERT_TRUE(wait([&] { return canApply(); }));
        // At this pace the move lasts longer than the word needs.
        bench.session().setPace({stage == ProcedureState::Verify ? 1.0 : 0.0});
        const auto connection = QObject::connect(
            &bench.session(), &DeviceSession::procedureStage, &panel, [&](ProcedureState now) {
                if (now == stage && button(panel, "Cancel") != nullptr) {
                    QTest::mouseClick(button(panel, "Cancel"), Qt::LeftButton);
                }
            });
        click(panel, "Apply and verify");
        ASSERT_TRUE(wait([&] { return bench.session().procedure().isEmpty() && !button(panel, "Cancel"); }));
        QObject::disconnect(connection);
        bench.session().setPace({0.0});
        if (button(panel, "Restore") != nullptr) { // it was over before the word arrived
            EXPECT_NE(stage, ProcedureState::Verify);
            click(panel, "Restore");
            ASSERT_TRUE(wait([&] { return button(panel, "Restore") == nullptr; }));
        }
        EXPECT_EQ(valuesNow(), before) << procedureStateName(stage);
        EXPECT_FALSE(bench.session().report().board.isArmed);
    }
}

TEST_F(TunePanelTest, aDeviceLostInTheVerificationIsSaidInPlace) {
    QProcess board;
    board.start(HALBENCH_PROGRAM, {"serve", "sim:htm", "--tcp", "127.0.0.1:0"});
    ASSERT_TRUE(board.waitForReadyRead(Patience_ms));
    connectMotor(QString::fromUtf8(board.readLine()).trimmed().section(' ', 1), 1.0);
    bench.setIdentification(publishedMotor());
    ASSERT_TRUE(wait([&] { return bench.design().has_value(); }));
    if (auto* consent = panel.findChild<Preflight*>()->findChild<QCheckBox*>(); consent->isVisible()) {
        EXPECT_FALSE(canApply()); // a real motor moves only with consent
        QTest::mouseClick(consent, Qt::LeftButton, {}, {8, consent->height() / 2});
    }
    ASSERT_TRUE(wait([&] { return canApply(); })) << verdict().toStdString();
    click(panel, "Apply and verify");
    ASSERT_TRUE(wait([&] { return bench.session().report().board.isArmed; }));
    board.kill();
    ASSERT_TRUE(wait([&] { return bench.session().procedure().isEmpty(); }));
    EXPECT_FALSE(message().isEmpty());
    EXPECT_FALSE(canApply());
    type("gain.kp", "20"); // it still computes
    EXPECT_TRUE(wait([&] { return bench.design()->law.gains.proportional == 20.0; }));
    bench.session().disconnectDevice();
    board.waitForFinished(Patience_ms);
}

} // namespace
} // namespace halbench::app
