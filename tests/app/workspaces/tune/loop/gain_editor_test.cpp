#include "app/workbench/document_files.h"
#include "app/workspaces/tune/loop/gain_editor.h"
#include "app/workspaces/tune/tune_question.h"
#include "tests/app/workspaces/published_motor.h"
#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/optional_number_edit.h"

#include <QComboBox>
#include <QLabel>
#include <QTemporaryDir>
#include <QtTest/QTest>

#include <vector>

namespace halbench::app {
namespace {

class GainEditorTest : public widgets::GuiTest {
protected:
    widgets::OptionalNumberEdit* edit(const char* name) {
        return editor.findChild<widgets::OptionalNumberEdit*>(name);
    }
    QComboBox* box(const QString& name) {
        for (auto* each : editor.findChildren<QComboBox*>()) {
            if (each->accessibleName() == name) {
                return each;
            }
        }
        return nullptr;
    }
    void type(const char* name, const char* text) {
        edit(name)->setFocus();
        QTest::keyClick(edit(name), Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(edit(name), Qt::Key_Delete);
        QTest::keyClicks(edit(name), text);
    }
    GainEditor editor;
};

TEST_F(GainEditorTest, whatWasSetComesBackToTheLastDigit) {
    control::PositionLaw law;
    law.gains.proportional = 1.0 / 3.0;
    law.gains.derivative = 0.1 + 0.2;
    law.coulomb_A = 1.29;
    editor.setLaw(law);
    const auto found = editor.law();
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(found->gains.proportional, law.gains.proportional);
    EXPECT_EQ(found->gains.derivative, law.gains.derivative);
    EXPECT_EQ(found->coulomb_A, law.coulomb_A);
}

TEST_F(GainEditorTest, theUnitIsThatOfTheOwnerAndTheLawStays) {
    control::PositionLaw law;
    law.gains.proportional = 40.0;
    editor.setLaw(law);
    editor.setAngleUnit(widgets::AngleUnit::Degree);
    EXPECT_NEAR(*editor.findChild<widgets::OptionalNumberEdit*>("gain.kp")->value(), 40.0 / 57.29578, 1e-5);
    EXPECT_EQ(editor.law()->gains.proportional, 40.0);
}

// K = 40, T_i = 60/40 the other way round, T_d = 1.4/40: K_I = K/T_i, K_D = K T_d.
TEST_F(GainEditorTest, theSameGainsAreShownAndTypedAsTimes) {
    control::PositionLaw law;
    law.gains.proportional = 40.0;
    law.gains.integral = 60.0;
    law.gains.derivative = 1.4;
    editor.setLaw(law);
    auto* form = box("Form of the gains");
    form->setCurrentIndex(1); // standard
    EXPECT_DOUBLE_EQ(*edit("gain.ki")->value(), 40.0 / 60.0);
    EXPECT_DOUBLE_EQ(*edit("gain.kd")->value(), 1.4 / 40.0);
    EXPECT_EQ(edit("gain.ki")->accessibleName(), "Integral time T_i");
    EXPECT_EQ(editor.law()->gains, law.gains); // to the last digit: nothing was edited
    type("gain.ki", "0.5");
    EXPECT_NEAR(editor.law()->gains.integral, 80.0, 1e-9);
    EXPECT_NEAR(editor.law()->gains.derivative, 1.4, 1e-12);
    type("gain.ki", "");
    EXPECT_EQ(editor.law()->gains.integral, 0.0); // no integral action
    type("gain.ki", "0");
    ASSERT_FALSE(editor.law()); // an infinite gain
    type("gain.ki", "0.5");
    form->setCurrentIndex(
        2); // series: K (1 + T_d/T_i) = 40 and so on; T_i T_d = K_D/K_I, T_i + T_d = K_P/K_I
    const double Ti = *edit("gain.ki")->value();
    const double Td = *edit("gain.kd")->value();
    EXPECT_NEAR(Ti * Td, 1.4 / 80.0, 1e-9);
    EXPECT_NEAR(Ti + Td, 40.0 / 80.0, 1e-9);
    form->setCurrentIndex(0);
    EXPECT_NEAR(*edit("gain.ki")->value(), 80.0, 1e-9);
}

TEST_F(GainEditorTest, complexZerosHaveNoSeriesFormAndThatIsSaid) {
    control::PositionLaw law;
    law.gains.proportional = 40.0;
    law.gains.integral = 400.0; // T_i = 0.1 s is less than 4 T_d = 0.2 s
    law.gains.derivative = 2.0;
    editor.setLaw(law);
    box("Form of the gains")->setCurrentIndex(2);
    EXPECT_EQ(box("Form of the gains")->currentIndex(), 0); // parallel, which every law has
    EXPECT_EQ(edit("gain.ki")->accessibleName(), "Integral K_I");
    bool isSaid = false;
    for (const auto* label : editor.findChildren<QLabel*>()) {
        isSaid |= label->text().contains("complex") && !label->isHidden();
    }
    EXPECT_TRUE(isSaid);
    EXPECT_EQ(editor.law()->gains, law.gains);
    box("Form of the gains")->setCurrentIndex(1);
    for (const auto* label : editor.findChildren<QLabel*>()) {
        EXPECT_FALSE(label->text().contains("complex"));
    }
}

TEST_F(GainEditorTest, aMissingNumberIsNamed) {
    auto* edit = editor.findChild<widgets::OptionalNumberEdit*>("gain.ki");
    edit->setFocus();
    QTest::keyClick(edit, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(edit, Qt::Key_Delete);
    const auto found = editor.law();
    ASSERT_FALSE(found);
    EXPECT_NE(found.error().message.find("K_I"), std::string::npos);
}

TEST(TuneQuestion, judgesTheGainsOnTheDeviceBesideTheProposedOnes) {
    TuneQuestion question;
    question.motor = motorEstimate(publishedMotor());
    question.present = control::PositionLaw{};
    question.present->law.gains.proportional = 10.0;
    const auto sketch = sketchTuning(question);
    ASSERT_TRUE(sketch) << sketch.error().message;
    ASSERT_TRUE(sketch->steady.present && sketch->steady.present->predicted);
    // i_f/K_P of 1.434 A and 10 A/rad (htm-theory.md 6.7: 8.21 degrees)
    EXPECT_NEAR(sketch->steady.present->predicted->frictionBand_rad * 180.0 / M_PI, 8.21, 0.02);
    // The sketch is the judgement without its draws.
    const auto answer = answerTuning(question);
    ASSERT_TRUE(answer) << answer.error().message;
    EXPECT_EQ(answer->law.gains.proportional, sketch->law.gains.proportional);
    EXPECT_EQ(answer->predicted.margins.phaseMargin_deg, sketch->predicted.margins.phaseMargin_deg);
    question.law = question.present;
    EXPECT_EQ(answerTuning(question)->law.gains.proportional, 10.0);
}

TEST_F(GainEditorTest, aDocumentIsWrittenWhereTheUserSays) {
    const QTemporaryDir folder;
    FileQueue files;
    std::vector<bool> answers;
    const auto then = [&](const QString&, const Result<void>& written) {
        answers.push_back(written.has_value());
    };
    const auto document = [] { return JsonValue::object(); };
    saveDocument(nullptr, {}, {}, files, document, then); // nobody to ask: nothing happens
    const FileChooser chooser{[&](QWidget*, const FileQuestion&) { return folder.filePath("a.json"); }, {}};
    saveDocument(nullptr, chooser, {}, files, document, then);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !answers.empty(); }));
    EXPECT_EQ(answers, (std::vector<bool>{true})); // in order, so the first never was asked for
    EXPECT_TRUE(QFile::exists(folder.filePath("a.json")));
}

} // namespace
} // namespace halbench::app
