#include "app/workspaces/tune/axes/axis_gain_editor.h"
#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/optional_number_edit.h"

#include <QLabel>
#include <QSignalSpy>
#include <QtTest/QTest>

#include <algorithm>

namespace halbench::app {
namespace {

class AxisGainEditorTest : public widgets::GuiTest {
protected:
    widgets::OptionalNumberEdit* edit(const char* name) {
        for (auto* each : editor.findChildren<widgets::OptionalNumberEdit*>()) {
            if (each->accessibleName() == QLatin1String(name)) {
                return each;
            }
        }
        return nullptr;
    }
    bool shows(const char* text) {
        const auto labels = editor.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* label) { return label->text() == QString::fromUtf8(text); });
    }
    void type(const char* name, const char* text) {
        edit(name)->selectAll();
        QTest::keyClick(edit(name), Qt::Key_Delete);
        QTest::keyClicks(edit(name), text);
    }
    /// A law with weights and filter as the platen's board has (resources/help/planar-theory.md section 9).
    static LoopLaw weightedLaw() {
        LoopLaw law;
        law.law.gains.proportional = 660.48;
        law.law.gains.integral = 1267.2;
        law.law.gains.derivative = 39.808;
        law.filtered.emplace();
        law.filtered->gains = law.law.gains;
        law.filtered->gains.filter_s = 2e-3;
        law.filtered->proportionalWeight = 0.745;
        law.filtered->derivativeWeight = 0.0;
        return law;
    }
    static LoopAxis axisOf(const char* id, const char* position, const char* effort) {
        LoopAxis axis;
        axis.id = id;
        axis.positionUnit = position;
        axis.effortUnit = effort;
        return axis;
    }

    AxisGainEditor editor;
};

TEST_F(AxisGainEditorTest, lawComesBackAsItWasSet) {
    const LoopLaw law = weightedLaw();
    editor.setLaw(law, axisOf("x", "m", "N"));
    const auto found = editor.law();
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(*found, law);
}

TEST_F(AxisGainEditorTest, unitsAreThoseOfTheAxis) {
    editor.setLaw(weightedLaw(), axisOf("x", "m", "N"));
    EXPECT_TRUE(shows("N/m"));
    EXPECT_TRUE(shows("N·s/m"));
    editor.setLaw(weightedLaw(), axisOf("phi", "rad", "N*m"));
    EXPECT_FALSE(shows("N/m"));
    EXPECT_TRUE(shows("N·m/rad"));
}

TEST_F(AxisGainEditorTest, editedNumbersReachLawAndFilter) {
    QSignalSpy edited(&editor, &AxisGainEditor::edited);
    editor.setLaw(weightedLaw(), axisOf("x", "m", "N"));
    type("Proportional gain", "700");
    type("Set-point weight b of the proportional part", "0.5");
    type("Time constant of the derivative's filter", "1.5"); // ms
    EXPECT_GT(edited.count(), 0);
    const auto law = editor.law();
    ASSERT_TRUE(law) << law.error().message;
    EXPECT_EQ(law->law.gains.proportional, 700.0);
    ASSERT_TRUE(law->filtered);
    EXPECT_EQ(law->filtered->gains.proportional, 700.0);
    EXPECT_EQ(law->filtered->proportionalWeight, 0.5);
    EXPECT_NEAR(*law->filtered->gains.filter_s, 1.5e-3, 1e-15);
}

// b = 1, c = 0 and no filter: the law that every board has.
TEST_F(AxisGainEditorTest, wholeSetPointWithoutFilterIsALawOfEveryBoard) {
    editor.setLaw(weightedLaw(), axisOf("x", "m", "N"));
    type("Set-point weight b of the proportional part", "1");
    type("Set-point weight c of the derivative part", "0");
    type("Time constant of the derivative's filter", "0");
    const auto law = editor.law();
    ASSERT_TRUE(law) << law.error().message;
    EXPECT_FALSE(law->filtered);
    EXPECT_EQ(law->law.gains.proportional, 660.48);
}

TEST_F(AxisGainEditorTest, missingOrWrongNumberIsNamed) {
    editor.setLaw(weightedLaw(), axisOf("x", "m", "N"));
    type("Integral gain", "");
    ASSERT_FALSE(editor.law());
    EXPECT_EQ(editor.law().error().message, "Integral gain: is missing");
    type("Integral gain", "-1");
    ASSERT_FALSE(editor.law());
    EXPECT_EQ(editor.law().error().code, ErrorCode::InvalidInput);
    type("Integral gain", "0");
    EXPECT_TRUE(editor.law());
    type("Set-point weight b of the proportional part", "1.1"); // of a part of the set-point
    EXPECT_FALSE(editor.law());
}

} // namespace
} // namespace halbench::app
